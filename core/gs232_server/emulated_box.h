// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/gs232_server/client_words.h"
#include "core/rotctld/line_session.h"

// The mount as a GS-232A or GS-232B box for one client. Commands that the box or the station refuses are answered "?>".
// Station thread.
namespace boresight::gs232 {

class EmulatedBox final : public rotctld::LineProtocol
{
public:
    // The rotator outlives this.
    EmulatedBox(rotctld::Client client, rotctld::Rotator& rotator, Dialect dialect);

    [[nodiscard]] rotctld::LineOutcome obey(std::string_view line) override;

private:
    void carryOut(Ask question, rotctld::LineOutcome& outcome);
    void carryOut(const PointTo& place, rotctld::LineOutcome& outcome);
    void carryOut(const Turn& turn, rotctld::LineOutcome& outcome);
    void carryOut(const StopTurning& stop, rotctld::LineOutcome& outcome);
    void carryOut(const Speed& speed, rotctld::LineOutcome& outcome);

    rotctld::Client m_client;
    rotctld::Rotator& m_rotator;
    Dialect m_dialect;
};

// How a server starts a conversation with a client. Rotator and clock outlive it.
[[nodiscard]] rotctld::StartConversation talkGs232(rotctld::Rotator& rotator, const Clock& clock, Dialect dialect);

}  // namespace boresight::gs232
