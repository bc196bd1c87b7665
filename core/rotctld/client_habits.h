// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"
#include "core/base/result.h"
#include "core/rotctld/client_program.h"
#include "core/rotctld/command_parser.h"
#include "core/rotctld/command_rate.h"
#include "core/rotctld/error_cycles.h"
#include "core/rotctld/line_protocol.h"
#include "core/rotctld/point_steps.h"

#include <QString>

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

// The behaviour of one client, for the list of clients: its probable program, its commands and their rate. No
// permission depends on it. Pure.
namespace boresight::rotctld {

inline constexpr std::size_t kShownBytes = 40;
// The text of a client for the log: printable, and no more than kShownBytes bytes. It may be binary data.
[[nodiscard]] QString shownText(std::string_view bytes);
// The command asks for a motion.
[[nodiscard]] bool asksForMotion(const Command& command);

class ClientHabits
{
public:
    explicit ClientHabits(SteadyTime begin) : m_rate(begin) {}

    // Call take() for each command before it runs, understood() afterwards if it was understood, and countOdd() for an
    // unknown line.
    void take(const Command& command, SteadyTime now);
    // take() for another protocol, after the command ran.
    void take(std::string_view command, const LineOutcome& outcome, SteadyTime now);
    void understood(const Command& command) { m_program.observe(command); }
    // The result of the last command. `became`: the changed target if the station changed it, else empty.
    void answered(const Result<>& outcome, const QString& became = {});
    void countOdd() { ++m_oddCommands; }

    [[nodiscard]] std::string_view program() const { return m_program.name(); }
    [[nodiscard]] QString lastCommand() const { return shownText(m_last.command); }
    // The last command that moves or stops the mount, with the reason if it was refused, or with its changed target:
    // "P 400 30 → az 40.0°". Most programs read the position after each target. Before the first such command, and if
    // the last command was refused: the last command.
    [[nodiscard]] QString lastInWords() const;
    [[nodiscard]] std::uint64_t oddCommands() const { return m_oddCommands; }
    [[nodiscard]] double commandsPerSecond(SteadyTime now) const { return m_rate.perSecond(now); }
    [[nodiscard]] std::optional<SteadyTime> lastMotion() const { return m_lastMotion; }  // requested, accepted or not
    [[nodiscard]] std::optional<Angle> leap() const { return m_steps.leap(); }
    [[nodiscard]] const ErrorCycles& errors() const { return m_errors; }

private:
    struct Answered
    {
        std::string command;
        QString refusal = {};  // empty: accepted
        QString became = {};
    };

    void noteMotion(const Command& command, SteadyTime now);
    void noteError(const Result<>& outcome);

    ClientProgram m_program;
    CommandRate m_rate;
    PointSteps m_steps;
    ErrorCycles m_errors;
    std::optional<SteadyTime> m_lastMotion;
    Answered m_last;
    std::optional<CommandId> m_lastId;  // empty in another protocol
    bool m_lastActs = false;            // it moves or stops the mount
    std::optional<Answered> m_act;
    std::uint64_t m_oddCommands = 0;
};

}  // namespace boresight::rotctld
