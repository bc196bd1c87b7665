// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"

#include <optional>
#include <utility>

// Counts the cycles in a row in which a client received an error. In each cycle Gpredict 2 sends its target if it has a
// new one, and then reads the position. A cycle is in error if one of the two is refused. A timer of Gpredict looks at
// the last cycle, once in the "Cycle" of its Antenna Control (1 s by default). Gpredict disengages when kGiveUp looks
// in a row find an error. Pure.
namespace boresight::rotctld {

class ErrorCycles
{
public:
    // MAX_ERROR_COUNT of Gpredict is 5, and the error after these ends it.
    static constexpr int kGiveUp = 6;

    void target(const Result<>& outcome) { m_target = errorOf(outcome); }
    // Ends the cycle.
    void reading(const Result<>& outcome)
    {
        m_error = m_target ? std::exchange(m_target, std::nullopt) : errorOf(outcome);
        m_inARow = m_error ? m_inARow + 1 : 0;
    }

    [[nodiscard]] int inARow() const { return m_inARow; }
    // The error of the last cycle. Empty if it had none.
    [[nodiscard]] const std::optional<Error>& error() const { return m_error; }

private:
    [[nodiscard]] static std::optional<Error> errorOf(const Result<>& outcome)
    {
        return outcome ? std::nullopt : std::optional(outcome.error());
    }

    std::optional<Error> m_target;  // of the running cycle
    std::optional<Error> m_error;
    int m_inARow = 0;
};

}  // namespace boresight::rotctld
