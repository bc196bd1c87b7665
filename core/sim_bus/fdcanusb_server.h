// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/serial/line_splitter.h"
#include "core/sim/simulated_pair.h"
#include "core/sim_bus/due_queue.h"

#include <map>
#include <optional>
#include <string>
#include <string_view>

// An fdcanusb adapter with the simulated pair on its bus: bytes from a client go in, bytes for the client come out.
// Pure. Times are those of the pair. Each answer has a checksum if its request had one, so clients of both kinds can
// come one after the other.
namespace boresight::sim {

class FdcanusbServer
{
public:
    explicit FdcanusbServer(SimulatedPair& pair);

    [[nodiscard]] std::string receive(std::string_view bytes, Seconds now);

    // Returns the delayed replies that are due now.
    [[nodiscard]] std::string takeDue(Seconds now);
    [[nodiscard]] std::optional<Seconds> nextDue() const { return m_late.nextDue(); }

    // The client has closed. Drops its incomplete line and the replies that it waited for.
    void clientGone();

private:
    enum class Style
    {
        Plain,
        WithChecksum,
    };
    struct Late
    {
        PairReply reply;
        Style style = Style::Plain;
    };

    void handleLine(std::string_view line, Seconds now);
    void execute(std::string_view text, Style style, Seconds now);
    void send(std::string_view text, Style style, Seconds now);
    void can(std::string_view subcommand, std::string_view text, Style style, Seconds now);
    void configure(std::string_view text, Style style);
    void followBus(Seconds now);
    void answer(std::string_view line, Style style);
    void answer(const PairReply& reply, Style style);
    [[nodiscard]] bool isInjected(FaultKind kind, Seconds now) const;

    SimulatedPair& m_pair;
    LineSplitter m_splitter;
    std::map<std::string, std::string, std::less<>> m_config;
    DueQueue<Late> m_late;
    std::string m_output;
    bool m_busOn = true;
};

}  // namespace boresight::sim
