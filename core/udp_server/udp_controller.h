// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"
#include "core/rotctld/command_budget.h"
#include "core/rotctld/line_protocol.h"
#include "core/rotctld/rotator.h"
#include "core/rotctld/settling.h"
#include "core/udp_server/rotor_command.h"

// The mount for one client that sends datagrams. Only questions are answered, and only while the position is known.
// Station thread.
namespace boresight::udp {

class UdpController final
{
public:
    static constexpr std::size_t kLongest = 512;  // bytes of a datagram

    // What the clients of a listener share. All of it outlives them.
    struct Shared
    {
        rotctld::Rotator& rotator;
        const Parse& parse;
        const rotctld::Settling& settling;
        const Clock& clock;
    };

    UdpController(rotctld::Client client, const Shared& shared);

    // A STOP is always obeyed. Any other datagram is refused if it is too long. A motion is refused while it may be
    // old, and in a flood of motions.
    [[nodiscard]] rotctld::LineOutcome obey(std::string_view datagram);

private:
    void logRefusal(std::string_view datagram, const Error& error) const;
    // The command, if it may be carried out.
    [[nodiscard]] Result<Command> read(std::string_view datagram);
    [[nodiscard]] Result<> admits(const Command& command);
    void carryOut(Ask question, rotctld::LineOutcome& outcome);
    void carryOut(const Target& target, rotctld::LineOutcome& outcome);
    void carryOut(const StopTurning& stop, rotctld::LineOutcome& outcome);
    void carryOut(const Park& park, rotctld::LineOutcome& outcome);
    static void carryOut(const Nothing& nothing, rotctld::LineOutcome& outcome);

    rotctld::Client m_client;
    Shared m_shared;
    rotctld::CommandBudget m_budget;  // for motions
};

}  // namespace boresight::udp
