// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/jog/gamepad_pilot.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace boresight::ui {

namespace {

// Worn sticks rest up to a sixth off their centre. A push along one axis must not move the other axis.
constexpr double kDeadZone = 0.2;

// Finer near the centre: half a stick gives a quarter of the rate.
double response(double stick)
{
    const double beyond = std::clamp((std::abs(stick) - kDeadZone) / (1.0 - kDeadZone), 0.0, 1.0);
    return std::copysign(beyond * beyond, stick);
}

}  // namespace

Steering GamepadPilot::take(const GamepadSample& sample, bool permitted)
{
    const bool pressed = sample.deadMan && !m_wasDeadMan;
    m_wasDeadMan = sample.deadMan;
    m_stopPressed = m_stopPressed || (sample.stop && !m_wasStop);
    m_wasStop = sample.stop;
    m_held = sample.deadMan && permitted && (m_held || pressed);
    if (!m_held || !std::isfinite(sample.right) || !std::isfinite(sample.up)) {
        return {};
    }
    return {.azimuth = response(sample.right), .elevation = response(sample.up)};
}

void GamepadPilot::gone()
{
    *this = {};
}

bool GamepadPilot::takeStop()
{
    return std::exchange(m_stopPressed, false);
}

}  // namespace boresight::ui
