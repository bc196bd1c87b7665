// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"
#include "core/base/result.h"
#include "core/rotctld/client_program.h"
#include "core/rotctld/command_parser.h"
#include "core/rotctld/command_rate.h"
#include "core/rotctld/point_steps.h"

#include <QString>

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

// What one client does, for the list of clients: which program it probably is, what it asks for and how often. Nothing
// that is granted or refused depends on it. Pure.
namespace boresight::rotctld {

inline constexpr std::size_t kShownBytes = 40;
// What the client sent, for the log: printable, and no more than so many bytes. It may be no text at all.
[[nodiscard]] QString shownText(std::string_view bytes);

class ClientHabits
{
public:
    explicit ClientHabits(SteadyTime begin) : m_rate(begin) {}

    // Each command, before it is run; one that was understood, afterwards; a line without sense.
    void take(const Command& command, SteadyTime now);
    // The same of another protocol. `point`: where the client wants the mount to point, if it says so.
    void take(std::string_view command, bool motion, const std::optional<SkyPointing>& point, SteadyTime now);
    void understood(const Command& command) { m_program.observe(command); }
    // The last command. `became`: what an accepted target became, empty if nothing else than the client wrote.
    void answered(const Result<>& outcome, const QString& became = {});
    void countOdd() { ++m_oddCommands; }

    [[nodiscard]] std::string_view program() const { return m_program.name(); }
    [[nodiscard]] QString lastCommand() const { return shownText(m_lastCommand); }
    // The last command, and why it was refused if it was, or what became of its target: "P 400 30 → az 40.0°".
    [[nodiscard]] QString lastInWords() const;
    [[nodiscard]] std::uint64_t oddCommands() const { return m_oddCommands; }
    [[nodiscard]] double commandsPerSecond(SteadyTime now) const { return m_rate.perSecond(now); }
    [[nodiscard]] std::optional<SteadyTime> lastMotion() const { return m_lastMotion; }  // asked for, granted or not
    [[nodiscard]] std::optional<Angle> leap() const { return m_steps.leap(); }

private:
    void noteMotion(const Command& command, SteadyTime now);

    ClientProgram m_program;
    CommandRate m_rate;
    PointSteps m_steps;
    std::optional<SteadyTime> m_lastMotion;
    std::string m_lastCommand;
    QString m_lastRefusal;  // empty: accepted
    QString m_became;
    std::uint64_t m_oddCommands = 0;
};

}  // namespace boresight::rotctld
