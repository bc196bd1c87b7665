// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mqtt/newest_messages.h"
#include "core/pairs_server/pairs_talk.h"
#include "core/rotctld/client_habits.h"
#include "core/rotctld/command_budget.h"
#include "core/rotctld/rotator.h"
#include "core/rotctld/settling.h"

#include <QByteArray>

#include <functional>
#include <optional>
#include <string_view>

// Carries out the commands that arrive at the command topics of a broker, during one connection to the broker. A
// message does not contain its sender, so all senders together are one client of the mount. It does not use the broker
// itself: messages in, answers out. Station thread.
namespace boresight::mqtt {

// Latches STOP, like the STOP button of the window.
using LatchStop = std::function<Result<>(const rotctld::Client& client)>;

class CommandTalk
{
public:
    static constexpr std::size_t kLongest = 200;  // bytes of a command

    // No flood may displace a STOP or a hold. Pure, any thread.
    [[nodiscard]] static Urgency urgencyOf(const QByteArray& message);

    // Create it when the connection begins. The rotator and the clock outlive this.
    CommandTalk(rotctld::Client client, rotctld::Rotator& rotator, const Clock& clock, pairs::SiteNow site,
                LatchStop latchStop);

    // Carries out a message of the command topic. Returns the answer as one line of JSON. In a flood only STOP and hold
    // are obeyed, without an answer.
    [[nodiscard]] std::optional<QByteArray> obey(const QByteArray& message, Retain retain);
    // Carries out a message of the STOP topic. Any text means STOP.
    [[nodiscard]] std::optional<QByteArray> stop(const QByteArray& message, Retain retain);

    // Call once per tick. After a pause the settling begins again, because messages may have waited in the socket.
    void tick() { m_settling.tick(); }

    [[nodiscard]] const rotctld::Client& client() const { return m_client; }
    [[nodiscard]] const rotctld::ClientHabits& habits() const { return m_habits; }

private:
    [[nodiscard]] std::optional<QByteArray> latch(const QByteArray& message, std::string_view line, Retain retain);
    [[nodiscard]] rotctld::LineOutcome run(std::string_view line, bool isHold, Retain retain);
    [[nodiscard]] rotctld::LineOutcome refuseOld(std::string_view line);
    [[nodiscard]] rotctld::LineOutcome refuse(std::string_view line, ErrorCode code, const QString& reason);
    [[nodiscard]] Result<> admits(const pairs::Command& command) const;
    [[nodiscard]] bool isFlood();
    std::optional<QByteArray> answer(const QByteArray& message, std::string_view line,
                                     const rotctld::LineOutcome& outcome, bool flood);
    void logMessage(const QByteArray& message, const QByteArray& answer, const rotctld::LineOutcome& outcome);

    rotctld::Client m_client;
    rotctld::Rotator& m_rotator;
    const Clock& m_clock;
    LatchStop m_latchStop;
    pairs::PairsTalk m_talk;
    rotctld::ClientHabits m_habits;
    rotctld::Settling m_settling;
    rotctld::CommandBudget m_budget;
};

}  // namespace boresight::mqtt
