// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/can_frame.h"
#include "core/base/clock.h"
#include "core/sim/fault_injection.h"

#include <cstdint>
#include <deque>
#include <optional>
#include <random>
#include <utility>
#include <vector>

// Applies to the replies of one drive the faults of the schedule that concern content, sender or number of replies.
// Keeps the replies of the last kLongestStale. Pure. Random numbers depend on the seed only. Times are those of the
// pair.
namespace boresight::sim {

inline constexpr Seconds kLongestStale{10.0};

class ReplySpoiler
{
public:
    ReplySpoiler(Axis axis, std::uint32_t seed) : m_axis(axis), m_random(seed) {}

    // The frames that arrive in place of `reply`. `otherId`: the id of the other drive.
    [[nodiscard]] std::vector<CanFrame> spoil(const CanFrame& reply, const FaultSchedule& faults, Seconds now,
                                              int otherId);

private:
    struct Edit
    {
        FaultKind kind{};
        double value = 0.0;
    };
    struct Said
    {
        Seconds at;
        CanFrame frame;
    };

    [[nodiscard]] std::vector<Edit> editsFor(const FaultSchedule& faults, Seconds now);
    [[nodiscard]] Edit randomEdit();
    void apply(const Edit& edit, CanFrame& reply, Seconds now, int otherId) const;
    void remember(const CanFrame& reply, Seconds now);
    [[nodiscard]] std::optional<CanFrame> said(const CanFrame& like, Seconds at) const;
    [[nodiscard]] double random(double low, double high)
    {
        return std::uniform_real_distribution<double>(low, high)(m_random);
    }

    Axis m_axis;
    std::minstd_rand m_random;
    std::deque<Said> m_said;
};

}  // namespace boresight::sim
