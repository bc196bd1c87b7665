// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/sim/reference_mount.h"

#include <algorithm>
#include <numbers>

namespace boresight::sim {
namespace {

// Gains for a control bandwidth of 40 rad/s (6 Hz) with critical damping. Per turn of the output (J times 2 pi): kp =
// J·w², kd = 2·J·w, ki = kp·w/5. The control is so stiff that 5 Nm of friction make an error of 0.01° before the
// integrator corrects it.
ServoGains gainsFor(double inertia)
{
    constexpr double kBandwidth = 40.0;
    const double perTurn = inertia * 2.0 * std::numbers::pi;
    const double kp = perTurn * kBandwidth * kBandwidth;
    return {.kp = kp, .ki = kp * kBandwidth / 5.0, .kd = 2.0 * perTurn * kBandwidth, .ilimit = 60.0};
}

ReferenceAxis makeAxis(double sign, Angle offset, const TravelRange& travel, const PlantSettings& settings)
{
    ReferenceAxis axis{.sign = sign,
                       .offset = offset,
                       .travel = travel,
                       .gearRatio = 100.0,
                       .plant = settings,
                       .gains = gainsFor(settings.inertia)};
    const Angle buffer = 8.0_deg;  // rubber stops beyond the travel
    const double low = axis.toTurns(travel.min - buffer);
    const double high = axis.toTurns(travel.max + buffer);
    axis.plant.stopMin = std::min(low, high);
    axis.plant.stopMax = std::max(low, high);
    axis.plant.levelAt = axis.toTurns(0.0_deg);
    return axis;
}

constexpr double kBacklash = 0.02 / 360.0;

}  // namespace

const ReferenceAxis& referenceAxis(Axis axis)
{
    static const ReferenceAxis azimuth = makeAxis(1.0, 0.0_deg, {.min = -90.0_deg, .max = 450.0_deg},
                                                  {.inertia = 20.0,
                                                   .coulombFriction = 3.0,
                                                   .staticFriction = 4.0,
                                                   .viscousFriction = 5.0,
                                                   .backlash = kBacklash});
    // The counterweight leaves an unbalance of 5 Nm. This is less than the friction, so the antenna stays where it is
    // without power.
    static const ReferenceAxis elevation = makeAxis(-1.0, 90.0_deg, {.min = 0.0_deg, .max = 90.0_deg},
                                                    {.inertia = 12.0,
                                                     .coulombFriction = 5.5,
                                                     .staticFriction = 7.0,
                                                     .viscousFriction = 5.0,
                                                     .gravityTorque = 5.0,
                                                     .backlash = kBacklash});
    return axis == Axis::Azimuth ? azimuth : elevation;
}

const ReferenceAxis& referenceFeed()
{
    static const ReferenceAxis feed =
        makeAxis(1.0, 0.0_deg, {.min = -90.0_deg, .max = 90.0_deg},
                 {.inertia = 0.5, .coulombFriction = 0.1, .staticFriction = 0.15, .viscousFriction = 0.1});
    return feed;
}

}  // namespace boresight::sim
