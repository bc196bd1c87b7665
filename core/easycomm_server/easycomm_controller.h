// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/easycomm_server/easycomm_words.h"
#include "core/rotctld/line_session.h"

#include <optional>
#include <string>

// The mount as an EasyComm controller for one client. Questions are always answered. If there is no answer, an alarm is
// sent. Commands are not answered. Versions II and III send an alarm for the first of several refused commands. Station
// thread.
namespace boresight::easycomm {

class EasycommController final : public rotctld::LineProtocol
{
public:
    // The rotator outlives this.
    EasycommController(rotctld::Client client, rotctld::Rotator& rotator, Version version);

    [[nodiscard]] rotctld::LineOutcome obey(std::string_view line) override;

private:
    // Each returns the answer, which may be empty.
    Result<std::string> carryOut(Ask question, rotctld::LineOutcome& outcome);
    Result<std::string> carryOut(const Target& target, rotctld::LineOutcome& outcome);
    Result<std::string> carryOut(const Turn& turn, rotctld::LineOutcome& outcome);
    Result<std::string> carryOut(const StopTurning& stop, rotctld::LineOutcome& outcome);
    Result<std::string> carryOut(const Park& park, rotctld::LineOutcome& outcome);
    Result<std::string> carryOut(const Reset& reset, rotctld::LineOutcome& outcome);
    Result<std::string> carryOut(const NotForARotator& other, rotctld::LineOutcome& outcome);
    Result<std::string> done(const Result<>& outcome);
    [[nodiscard]] std::string status();
    [[nodiscard]] std::string alarmFor(const Error& error, bool asked);

    rotctld::Client m_client;
    rotctld::Rotator& m_rotator;
    Version m_version;
    bool m_turns = false;                 // this client turns the mount at a rate
    std::optional<ErrorCode> m_reported;  // the last alarm of a command, until a command is accepted
};

// How a server starts a conversation with a client. Rotator and clock outlive it.
[[nodiscard]] rotctld::StartConversation talkEasycomm(rotctld::Rotator& rotator, const Clock& clock, Version version);

}  // namespace boresight::easycomm
