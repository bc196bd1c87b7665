// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mqtt/broker_client.h"
#include "tests/fakes/manual_clock.h"
#include "tests/fakes/wait_until.h"

#include <QAbstractEventDispatcher>
#include <QElapsedTimer>
#include <QTimer>

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <vector>

// A client with a hand-turned clock, its reports, and the longest delay of the event loop.
namespace boresight::mqtt {

[[nodiscard]] inline Broker onLoopback(std::uint16_t port)
{
    return {.host = QStringLiteral("127.0.0.1"), .port = port};
}

// Half the watchdog time of the drives.
inline constexpr std::chrono::milliseconds kLongestStall{50};

// Ticks every 2 ms and keeps the longest gap. Counts how often the event loop woke up.
class LoopWatch
{
public:
    LoopWatch()
    {
        m_timer.setTimerType(Qt::PreciseTimer);
        m_timer.callOnTimeout([this] { m_longest = std::max(m_longest, m_sinceTick.restart()); });
        QObject::connect(QAbstractEventDispatcher::instance(), &QAbstractEventDispatcher::awake, &m_timer,
                         [this] { ++m_turns; });
        m_sinceTick.start();
        m_timer.start(std::chrono::milliseconds(2));
    }
    [[nodiscard]] std::chrono::milliseconds longest() const { return std::chrono::milliseconds(m_longest); }
    // Runs the event loop for this time and counts its turns.
    [[nodiscard]] int turnsIn(std::chrono::milliseconds time)
    {
        m_turns = 0;
        QElapsedTimer elapsed;
        elapsed.start();
        EXPECT_TRUE(fakes::waitUntil([&] { return elapsed.hasExpired(time.count()); }));
        return m_turns;
    }

private:
    QTimer m_timer;
    QElapsedTimer m_sinceTick;
    qint64 m_longest = 0;
    int m_turns = 0;
};

// The longest stall in the best of many runs: blocking code stalls in every run, other load of this computer does not.
template <class Scenario>
[[nodiscard]] std::chrono::milliseconds stallOf(Scenario scenario)
{
    auto best = std::chrono::milliseconds::max();
    for (int run = 0; run < 30 && best >= kLongestStall; ++run) {
        LoopWatch watch;
        scenario(watch);
        best = std::min(best, watch.longest());
    }
    testing::Test::RecordProperty("longest_stall_ms", static_cast<int>(best.count()));
    return best;
}

struct Rig
{
    Rig()
    {
        QObject::connect(&client, &BrokerClient::connected, &client, [this] { ++connections; });
        QObject::connect(&client, &BrokerClient::problemChanged, &client,
                         [this](const QString& text) { problems.push_back(text.toStdString()); });
        QObject::connect(&client, &BrokerClient::messageReceived, &client,
                         [this](const QString& topic, const QByteArray& payload) {
                             messages.push_back({.topic = topic, .payload = payload});
                         });
    }

    [[nodiscard]] bool connected() const
    {
        return fakes::waitUntil([this] { return client.isConnected(); });
    }
    // Runs until an attempt has failed and the next one is due later.
    [[nodiscard]] bool failed() const
    {
        return fakes::waitUntil([this] { return client.nextAttempt().has_value(); });
    }
    [[nodiscard]] bool received(std::size_t count) const
    {
        return fakes::waitUntil([this, count] { return messages.size() >= count; });
    }
    void letTimePass(Seconds time)
    {
        clock.advance(time);
        client.service();
    }

    fakes::ManualClock clock;
    BrokerClient client{clock};
    int connections = 0;
    std::vector<std::string> problems;
    std::vector<Message> messages;
};

}  // namespace boresight::mqtt
