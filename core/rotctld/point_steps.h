// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"
#include "core/units/sky.h"

#include <optional>

// How coarsely a client tracks its target, measured by the points that it sends. Gpredict sends the next one only when
// the satellite is its "Threshold" away from the antenna, 5° unless the user changed it, and points as far ahead: it is
// silent for a while, leaps by up to twice that, corrects the leap while the antenna is under way, and is silent again.
// Pure.
namespace boresight::rotctld {

class PointSteps
{
public:
    void observe(const SkyPointing& point, SteadyTime now);
    // The smallest of the last leaps, while it keeps leaping; empty again once it follows closely.
    [[nodiscard]] std::optional<Angle> leap() const;

private:
    std::optional<SkyPointing> m_last;
    SteadyTime m_lastTime{};
    SteadyTime m_lastSilence{};  // its end
    Angle m_smallest;
    int m_leaps = 0;  // in a row, each after a silence
};

}  // namespace boresight::rotctld
