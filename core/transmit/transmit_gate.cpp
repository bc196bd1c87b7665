// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/transmit/transmit_gate.h"

#include "core/units/angle_between.h"

namespace boresight::transmit {
namespace {

GateDecision judged(const GateInput& input, Angle limit)
{
    if (input.obstacle != Obstacle::None) {
        return {.obstacle = input.obstacle};
    }
    if (!input.target) {
        return {.obstacle = Obstacle::NoTarget};
    }
    if (!input.beam) {
        return {.obstacle = Obstacle::NoPosition};
    }
    const Angle error = angleBetween(*input.beam, *input.target);
    return {.obstacle = error < limit ? Obstacle::None : Obstacle::Away, .error = error};
}

}  // namespace

GateDecision TransmitGate::decide(const GateInput& input, SteadyTime now)
{
    GateDecision decision = judged(input, m_on ? input.within : input.within * kComesBack);
    if (!decision.on()) {
        m_on = false;
        m_inside.reset();
        return decision;
    }
    m_inside = m_inside.value_or(now);
    m_on = m_on || now - *m_inside >= kSettled;
    if (!m_on) {
        decision.obstacle = Obstacle::Settling;
    }
    return decision;
}

}  // namespace boresight::transmit
