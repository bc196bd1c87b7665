// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"

#include <array>
#include <cstdint>
#include <optional>

// How late the control ticks come: a histogram with steps of 0.1 ms up to 100 ms, and of 10 ms up to 10 s. It serves
// the benchmark, and an operator who wants to know whether this computer is fast enough. Station thread only.
namespace boresight {

class TickLateness
{
public:
    explicit TickLateness(Seconds period) : m_period(period) {}

    void tick(SteadyTime now);

    [[nodiscard]] std::uint64_t count() const { return m_count; }
    // The lateness that this share of the ticks (0…1) did not exceed. For a share of 1 the value is exact.
    [[nodiscard]] Seconds percentile(double share) const;

private:
    static constexpr Seconds kStep{0.0001};
    static constexpr Seconds kCoarseStep{0.01};

    Seconds m_period;
    std::optional<SteadyTime> m_last;
    std::array<std::uint64_t, 1000> m_fine{};
    std::array<std::uint64_t, 1000> m_coarse{};  // the first ten stay empty; the last also counts everything above 10 s
    Seconds m_most{};
    std::uint64_t m_count = 0;
};

}  // namespace boresight
