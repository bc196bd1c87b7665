// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/rotctld/line_protocol.h"
#include "core/rotctld/rotator.h"
#include "core/rotctld/settling.h"
#include "core/udp_server/rotor_command.h"

// The mount for one client that sends datagrams. Only questions are answered, and only while the position is known.
// Station thread.
namespace boresight::udp {

class UdpController final : public rotctld::LineProtocol
{
public:
    static constexpr std::size_t kLongest = 512;  // bytes of a datagram

    // What the clients of a listener share. All of it outlives them.
    struct Shared
    {
        rotctld::Rotator& rotator;
        const Parse& parse;
        const rotctld::Settling& settling;
    };

    UdpController(rotctld::Client client, const Shared& shared);

    // A STOP is always obeyed. Any other datagram is refused if it is too long. A motion is refused while it may be
    // old.
    [[nodiscard]] rotctld::LineOutcome obey(std::string_view datagram) override;

private:
    [[nodiscard]] Result<> admits(const Command& command) const;
    void carryOut(Ask question, rotctld::LineOutcome& outcome);
    void carryOut(const Target& target, rotctld::LineOutcome& outcome);
    void carryOut(const StopTurning& stop, rotctld::LineOutcome& outcome);
    void carryOut(const Park& park, rotctld::LineOutcome& outcome);
    static void carryOut(const Nothing& nothing, rotctld::LineOutcome& outcome);

    rotctld::Client m_client;
    Shared m_shared;
};

}  // namespace boresight::udp
