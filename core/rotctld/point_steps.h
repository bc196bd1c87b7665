// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"
#include "core/units/sky.h"

#include <optional>

// How coarsely a client tracks its target, measured from the points that it sends. Gpredict sends the next point only
// when the satellite is its "Threshold" away from the antenna (default 5°), and points as far ahead. So it is silent
// for a while, leaps by up to twice that angle, corrects the leap while the antenna moves, and is silent again. Pure.
namespace boresight::rotctld {

class PointSteps
{
public:
    void observe(const SkyPointing& point, SteadyTime now);
    // The smallest of the last leaps, while the client keeps leaping. Empty again when it tracks closely.
    [[nodiscard]] std::optional<Angle> leap() const;

private:
    std::optional<SkyPointing> m_last;
    SteadyTime m_lastTime{};
    SteadyTime m_lastSilence{};  // when the last silence ended
    Angle m_smallest;
    int m_leaps = 0;  // in a row, each after a silence
};

}  // namespace boresight::rotctld
