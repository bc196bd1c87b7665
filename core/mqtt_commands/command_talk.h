// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"
#include "core/mqtt/broker.h"
#include "core/pairs_server/pairs_talk.h"
#include "core/rotctld/client_habits.h"
#include "core/rotctld/rotator.h"
#include "core/rotctld/settling.h"

#include <QByteArray>

#include <functional>
#include <optional>
#include <string_view>

// The mount to those who write to the command topics of a broker, during one connection to the broker. Together they
// are one client: a message does not say who sent it. Knows no broker: messages in, answers out. Station thread.
namespace boresight::mqtt {

// Latches STOP, as the button of the window does.
using LatchStop = std::function<Result<>(const rotctld::Client& client)>;

class CommandTalk
{
public:
    static constexpr std::size_t kLongest = 200;  // bytes of a command
    static constexpr int kPerSecond = 20;         // commands

    // It begins with the connection. The rotator and the clock outlive this.
    CommandTalk(rotctld::Client client, rotctld::Rotator& rotator, const Clock& clock, pairs::SiteNow site,
                LatchStop latchStop);

    // A message of the topic for commands. What is answered, as one line of JSON; nothing to most of a flood.
    [[nodiscard]] std::optional<QByteArray> obey(const QByteArray& message, Retain retain);
    // A message of the topic for STOP, whatever it says.
    [[nodiscard]] std::optional<QByteArray> stop(const QByteArray& message, Retain retain);

    // Each tick: the settling begins again when the computer wakes up.
    void tick() { m_settling.tick(); }

    [[nodiscard]] const rotctld::Client& client() const { return m_client; }
    [[nodiscard]] const rotctld::ClientHabits& habits() const { return m_habits; }

private:
    [[nodiscard]] std::optional<QByteArray> latch(std::string_view line, Retain retain);
    [[nodiscard]] rotctld::LineOutcome run(std::string_view line, Retain retain);
    [[nodiscard]] rotctld::LineOutcome refuse(std::string_view line, ErrorCode code, const QString& reason);
    [[nodiscard]] Result<> admits(const pairs::Command& command) const;
    [[nodiscard]] bool isFlood();
    QByteArray answer(std::string_view line, const rotctld::LineOutcome& outcome);

    rotctld::Client m_client;
    rotctld::Rotator& m_rotator;
    const Clock& m_clock;
    LatchStop m_latchStop;
    pairs::PairsTalk m_talk;
    rotctld::ClientHabits m_habits;
    rotctld::Settling m_settling;
    SteadyTime m_second;  // the beginning of the second that is counted
    int m_inSecond = 0;   // commands
};

}  // namespace boresight::mqtt
