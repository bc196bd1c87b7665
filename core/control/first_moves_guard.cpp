// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/control/first_moves_guard.h"

namespace boresight {

Result<> FirstMovesGuard::admits(const ControlParts& of, const AxisRates& rates)
{
    if (of.profile.mount.directions == profile::Directions::Confirmed) {
        return {};
    }
    const AxisPosition place = of.mount.follows() ? of.motion.place() : *of.mount.measured();
    const auto rest = [&](Axis axis, Angle from, AngularRate wanted) {
        tracking::Setpoint then = of.motion.setpoint(axis);
        then.position = from;
        then.rate = abs(then.rate) > abs(wanted) ? then.rate : wanted;
        return restingPlace(then, of.profile.axis(axis).limits);
    };
    return m_moves.admits(rates, place,
                          {.azimuth = rest(Axis::Azimuth, place.azimuth, rates.azimuth),
                           .elevation = rest(Axis::Elevation, place.elevation, rates.elevation)});
}

bool FirstMovesGuard::exceeded(const ControlParts& of) const
{
    if (of.profile.mount.directions == profile::Directions::Confirmed || !of.current.runsFreely()) {
        return false;
    }
    const auto rest = [&](Axis axis) { return restingPlace(of.motion.setpoint(axis), of.profile.axis(axis).limits); };
    const AxisRates rates{.azimuth = of.motion.setpoint(Axis::Azimuth).rate,
                          .elevation = of.motion.setpoint(Axis::Elevation).rate};
    return of.mount.follows() && m_moves.exceeded(rates, {rest(Axis::Azimuth), rest(Axis::Elevation)});
}

std::optional<Motion::Band> FirstMovesGuard::band(const profile::Profile& profile, const pointing::Antenna& antenna)
{
    if (profile.mount.directions != profile::Directions::Confirmed) {
        return std::nullopt;
    }
    return Motion::Band{.width = profile.deadBand(antenna), .halfBeam = 0.5 * antenna.beamWidth};
}

}  // namespace boresight
