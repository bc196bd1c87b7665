// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"

#include <array>
#include <cstdint>
#include <optional>

// How late the control ticks come, as a histogram in steps of 0.1 ms up to 100 ms and of 10 ms up to 10 s: for the
// benchmark and for an operator who wonders whether this computer is up to it. Station thread only.
namespace boresight {

class TickLateness
{
public:
    explicit TickLateness(Seconds period) : m_period(period) {}

    void tick(SteadyTime now);

    [[nodiscard]] std::uint64_t count() const { return m_count; }
    // The lateness that a share of the ticks (0…1) did not exceed; of all of them it is exact.
    [[nodiscard]] Seconds percentile(double share) const;

private:
    static constexpr Seconds kStep{0.0001};
    static constexpr Seconds kCoarseStep{0.01};

    Seconds m_period;
    std::optional<SteadyTime> m_last;
    std::array<std::uint64_t, 1000> m_fine{};
    std::array<std::uint64_t, 1000> m_coarse{};  // its first ten stay empty; its last is open
    Seconds m_most{};
    std::uint64_t m_count = 0;
};

}  // namespace boresight
