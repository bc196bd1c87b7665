// SPDX-License-Identifier: GPL-3.0-or-later
// The texts about topics that a broker refuses, tested without a broker.
#include "core/orientation_stream/mqtt_source.h"
#include "tests/fakes/hand_turned_timers.h"
#include "tests/fakes/one_word.h"

#include <gtest/gtest.h>

#include <string>

namespace boresight::orientation {
namespace {

class ConnectedBroker final : public mqtt::Connection
{
public:
    void subscribe(const QString&) override {}
    void unsubscribe(const QString&) override {}
    bool publish(const mqtt::Message&) override { return false; }
    [[nodiscard]] const mqtt::Broker& broker() const override { return m_broker; }
    [[nodiscard]] bool isConnected() const override { return true; }
    [[nodiscard]] const QString& problem() const override { return m_problem; }

private:
    mqtt::Broker m_broker;
    QString m_problem;
};

// Another topic is refused, no data arrives, and then that topic is permitted.
std::string saidAfterTheGrant()
{
    fakes::ManualClock clock;
    ConnectedBroker broker;
    MqttSource source(broker, {}, clock);
    fakes::HandTurnedTimers timers(source, clock);
    source.open();
    Q_EMIT broker.subscriptionRefused(QStringLiteral("antenna/status"));
    EXPECT_FALSE(source.status().problem.isEmpty());
    timers.elapse(Seconds(6.0));
    Q_EMIT broker.subscriptionGranted(QStringLiteral("antenna/status"));
    return source.status().problem.toStdString();
}

// Story: a comparison of two translated texts decided whether the refusal was on the screen.
// REQ-ORIENTATION-500: When the broker permits a topic, the report that no data arrives stays on the screen, in every
// language.
TEST(MqttDenial, AGrantTakesBackTheRefusalOnly)
{
    EXPECT_NE(saidAfterTheGrant().find("No data on antenna/orientation"), std::string::npos);
    const fakes::OneWord translator;
    EXPECT_NE(saidAfterTheGrant(), "");
}

TEST(MqttDenial, AGrantTakesBackTheRefusal)
{
    const fakes::OneWord translator;
    fakes::ManualClock clock;
    ConnectedBroker broker;
    MqttSource source(broker, {}, clock);
    source.open();
    Q_EMIT broker.subscriptionRefused(QStringLiteral("antenna/orientation"));
    Q_EMIT broker.subscriptionRefused(QStringLiteral("antenna/status"));
    EXPECT_FALSE(source.status().problem.isEmpty());
    Q_EMIT broker.subscriptionGranted(QStringLiteral("antenna/orientation"));
    EXPECT_FALSE(source.status().problem.isEmpty());
    Q_EMIT broker.subscriptionGranted(QStringLiteral("antenna/status"));
    EXPECT_TRUE(source.status().problem.isEmpty());
}

}  // namespace
}  // namespace boresight::orientation
