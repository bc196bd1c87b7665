// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/control/gates.h"

#include "core/base/numbers.h"
#include "core/base/text.h"
#include "core/control/calibration_source.h"
#include "core/control/status_report.h"
#include "core/units/degrees_text.h"

#include <algorithm>

namespace boresight {

// The wind is checked last, because the other reasons also forbid parking.
Result<> Gates::isWindFine() const
{
    return m_of.arming.isReady().and_then([this] { return m_of.wind.admits(); });
}

Result<> Gates::mayMove(const Source& source) const
{
    return isWindFine().and_then([&] { return mayMoveInWind(source); });
}

Result<> Gates::mayMoveInWind(const Source& source) const
{
    if (m_of.mount.proofRunning()) {
        return failure(ErrorCode::Refused, Text::tr("The crash-stop test moves the mount. End it first."));
    }
    const auto commands = [&] { return mayCommand(source).and_then([this] { return m_of.brake.admits(); }); };
    return m_of.arming.admits(source).and_then(commands).and_then([&]() -> Result<> {
        for (const Axis axis : kAxes) {
            if (!m_of.mount.measured(axis)) {
                return failure(ErrorCode::NoAnswer,
                               Text::tr("The %1 reports no position. Check its encoder.").arg(m_of.mount.label(axis)));
            }
        }
        return {};
    });
}

Result<> Gates::mayHold(const Source& source) const
{
    return m_of.current.moves() ? mayLeavePark() : mayMove(source);
}

// On its way to the park position the mount may be held.
Result<> Gates::mayLeavePark() const
{
    return m_of.current.is(Activity::Parking) && m_of.motion.atRest() ? m_of.wind.admitsUnpark() : Result<>{};
}

Result<> Gates::isPlaced(Axis axis) const
{
    if (!m_of.mount.report(axis).wrapKnown) {
        const QString what =
            axis == Axis::Azimuth
                ? Text::tr("The cable wrap of the %1 is unknown. Enter the position of the axis. Only slow jog works.")
                : Text::tr("The position of the %1 is unknown. Enter the position of the axis. Only slow jog works.");
        return failure(ErrorCode::Refused, what.arg(m_of.mount.label(axis)));
    }
    return {};
}

Result<> Gates::axesPlaced() const
{
    return isPlaced(Axis::Azimuth).and_then([this] { return isPlaced(Axis::Elevation); }).and_then([this] {
        return insideTravel();
    });
}

Result<> Gates::mayPoint(const Source& source) const
{
    return isWindFine().and_then([&] { return mayPark(source); });
}

Result<> Gates::mayPark(const Source& source) const
{
    const auto directionsSeen = [this]() -> Result<> {
        if (m_of.profile.mount.directions != profile::Directions::Confirmed) {
            return failure(
                ErrorCode::Refused,
                Text::tr(
                    "The directions of the axes are not confirmed. Jog each axis a little and confirm them first."));
        }
        return {};
    };
    return mayMoveInWind(source).and_then(directionsSeen).and_then([this] { return axesPlaced(); }).and_then([this] {
        return mayLeaveSunBand({}, {});
    });
}

Result<> Gates::mayCommand(const Source& source) const
{
    return m_of.arming.mayCommand(source).and_then([&]() -> Result<> {
        return source.kind == SourceKind::Client ? m_of.clientControl.admits(m_of.profile.rotctld, source, m_of.now)
                                                 : Result<>{};
    });
}

Result<> Gates::mayShellCommand() const
{
    static const std::string kThisComputer = "127.0.0.1";
    return m_of.arming.authority() == Authority::Operator
               ? Result<>{}
               : m_of.clientControl.admitsHost(m_of.profile.rotctld, kThisComputer, m_of.now);
}

int Gates::farOutside(Axis axis) const
{
    const auto place = m_of.mount.measured(axis);
    if (!m_of.mount.report(axis).wrapKnown || !place) {
        return 0;
    }
    const TravelRange& travel = m_of.model.axis(axis).travel;
    const Angle margin = m_of.profile.control.driveLimitMargin;
    return *place > travel.max + margin ? 1 : *place < travel.min - margin ? -1 : 0;
}

Result<> Gates::insideTravel() const
{
    for (const Axis axis : kAxes) {
        if (farOutside(axis) != 0) {
            const TravelRange& travel = m_of.model.axis(axis).travel;
            return failure(ErrorCode::Refused,
                           Text::tr("The %1 stands at %2, outside its travel (%3 to %4). Jog it back slowly.")
                               .arg(m_of.mount.label(axis), degreesText(*m_of.mount.measured(axis), 2),
                                    degreesText(travel.min, 2), degreesText(travel.max, 2)));
        }
    }
    return {};
}

// Somebody must watch the cable of an axis whose wrap is unknown, or that is far outside its travel. So only the
// operator may jog it, and slowly.
Result<> Gates::mayJog(const AxisRates& rates, const Source& source) const
{
    return mayMove(source).and_then([&] { return m_of.endSwitches.admits(rates); }).and_then([&]() -> Result<> {
        if (const Result<> placed = axesPlaced(); !placed) {
            return source.kind == SourceKind::Operator ? mayJogSlowly(rates) : placed;
        }
        return mayLeaveSunBand(rates, source);
    });
}

Result<> Gates::mayJogSlowly(const AxisRates& rates) const
{
    for (const Axis axis : kAxes) {
        if (!m_of.mount.report(axis).wrapKnown && !m_of.mount.report(axis).wrapAsked) {
            return failure(ErrorCode::Refused,
                           Text::tr("Boresight is finding the position of the axes. Wait a moment."));
        }
        const AngularRate rate = axis == Axis::Azimuth ? rates.azimuth : rates.elevation;
        if (rate * static_cast<double>(farOutside(axis)) > AngularRate{}) {
            return failure(ErrorCode::Refused,
                           Text::tr("The %1 stands outside its travel. It may only be jogged back inside.")
                               .arg(m_of.mount.label(axis)));
        }
    }
    const AngularRate fastest = m_of.profile.jog.unwind;
    if (std::max(abs(rates.azimuth), abs(rates.elevation)) > fastest) {
        return failure(
            ErrorCode::Refused,
            (m_of.mount.wrapsKnown() ? Text::tr("An axis stands outside its travel. Jog at %1°/s "
                                                "or slower.")
                                     : Text::tr("The cable wrap of an axis is unknown. Jog at %1°/s or slower."))
                .arg(toQString(formatFixed(fastest.degrees(), 1))));
    }
    return {};
}

// Slow where somebody must watch the cable. Before the directions of the axes are confirmed, slow enough for the
// operator to react.
AngularRate Gates::fastestJog() const
{
    const profile::JogSettings& jog = m_of.profile.jog;
    if (!axesPlaced() || isInSunBand(m_of.standing())) {
        return std::min(jog.slow, jog.unwind);
    }
    const bool confirmed = m_of.profile.mount.directions == profile::Directions::Confirmed;
    return confirmed ? jog.fast : std::min(jog.fast, profile::kFastestUnconfirmed);
}

Result<> Gates::isElevation(Angle elevation) const
{
    const Angle top = std::max(90_deg, m_of.model.elevation().travel.max);
    if (elevation > top) {
        return failure(ErrorCode::OutOfRange,
                       Text::tr("elevation %1 above limit %2").arg(degreesText(elevation, 2), degreesText(top, 2)));
    }
    return {};
}

Result<> Gates::hasAxis(Axis axis) const
{
    if (m_of.mount.capabilities().has(axis)) {
        return {};
    }
    return failure(ErrorCode::NotAvailable, axis == Axis::Azimuth ? Text::tr("This mount has no azimuth axis.")
                                                                  : Text::tr("This mount has no elevation axis."));
}

Result<> Gates::isWayOn(Axis axis, bool upwards) const
{
    const auto place = m_of.mount.measured(axis);
    const TravelRange& travel = m_of.motion.travel(axis);
    if (!place || !m_of.mount.report(axis).wrapKnown || travel.max <= travel.min) {
        return {};
    }
    if (upwards && *place > travel.max - kAtEdge) {
        return failure(ErrorCode::OutOfRange, Text::tr("at the upper limit %1").arg(degreesText(travel.max)));
    }
    if (!upwards && *place < travel.min + kAtEdge) {
        return failure(ErrorCode::OutOfRange, Text::tr("at the lower limit %1").arg(degreesText(travel.min)));
    }
    return {};
}

Result<> Gates::mayBeAt(const AxisPosition& place) const
{
    const pointing::Resolved resolved = m_of.model.resolve(place);
    const QString why = resolved.limited ? resolved.reason : m_of.motion.region().reason(resolved.position);
    return why.isEmpty() ? Result<>{} : failure(ErrorCode::OutOfRange, why);
}

AxisPosition Gates::home() const
{
    const pointing::AxisBox& ranges = m_of.motion.region().ranges();
    return {.azimuth = ranges.azimuth.clamped(0_deg), .elevation = ranges.elevation.clamped(0_deg)};
}

// A rotator with steps cannot reach a place between its last step and the end of the profile's limits. It parks at
// that step. A place outside the limits stays unchanged, and is refused.
AxisPosition Gates::park() const
{
    const bool isStowed = m_of.wind.forbids() && m_of.profile.wind.stowAt == profile::StowAt::Place;
    const AxisPosition& place = isStowed ? m_of.profile.wind.place : m_of.profile.park;
    const pointing::Region& limits = m_of.profile.limits;
    const pointing::AxisBox& ranges = m_of.motion.region().ranges();
    const auto reached = [](Angle angle, const TravelRange& limit, const TravelRange& range) {
        return limit.contains(angle) ? range.clamped(angle) : angle;
    };
    return {.azimuth = reached(place.azimuth, limits.azimuth, ranges.azimuth),
            .elevation = reached(place.elevation, limits.elevation, ranges.elevation)};
}

bool Gates::isAtPark() const
{
    constexpr Angle kThere = Angle::fromDegrees(0.3);
    const auto measured = m_of.mount.measured();
    const AxisPosition place = park();
    return measured && m_of.mount.wrapsKnown() && abs(measured->azimuth - place.azimuth) < kThere &&
           abs(measured->elevation - place.elevation) < kThere;
}

Result<AxisPosition> Gates::unwound() const
{
    const auto place = CableGuard::leastWound(m_of.standing(), m_of.motion.region().ranges().azimuth);
    if (!place) {
        return failure(ErrorCode::Refused,
                       Text::tr("The azimuth cable cannot be unwrapped further in this direction."));
    }
    return *place;
}

Result<> Gates::isFresh(Axis axis) const
{
    const AxisReport report = m_of.mount.report(axis);
    if (!report.place || m_of.clock.now() - report.placed > kOldestPosition) {
        return failure(ErrorCode::NoAnswer, Text::tr("no fresh position from the %1").arg(m_of.mount.label(axis)));
    }
    return {};
}

Result<> Gates::mayResetStop() const
{
    return m_of.arming.mayResetStop().and_then([this]() -> Result<> {
        if (m_of.mount.underOrders() && !m_of.motion.atRest()) {
            return failure(ErrorCode::Refused,
                           Text::tr("The mount is still braking. Reset STOP when it stands still."));
        }
        return {};
    });
}

Result<> Gates::mayHoldAtEnd() const
{
    if (m_of.current.keepsWrap()) {
        return failure(ErrorCode::Refused, Text::tr("Hold at end is chosen already."));
    }
    const std::optional<CableEnd>& end = m_of.cable.end();
    return end && end->turningBack
               ? Result<>{}
               : failure(ErrorCode::Refused, Text::tr("No unwrapping is ahead. There is nothing to choose."));
}

Result<> Gates::mayClearTrim() const
{
    return m_of.motion.trim() != AxisPosition{} ? Result<>{}
                                                : failure(ErrorCode::Refused, Text::tr("The target has no trim."));
}

bool Gates::isInSunBand(const AxisPosition& place) const
{
    return m_of.mount.wrapsKnown() && m_of.sun.mayBeAt(m_of.model.toSky(place), m_of.model.missing());
}

// The Sun may be anywhere in the band, so no way out of the band is known to be safe.
Result<> Gates::mayLeaveSunBand(const AxisRates& rates, const Source& source) const
{
    const AngularRate fastest = m_of.profile.jog.unwind;
    const AngularRate rate = std::max(abs(rates.azimuth), abs(rates.elevation));
    const bool jogsSlowly = source.kind == SourceKind::Operator && rate > AngularRate{} && rate <= fastest;
    if (jogsSlowly || !isInSunBand(m_of.standing())) {
        return {};
    }
    return failure(ErrorCode::Refused,
                   Text::tr("The clock of this computer is not synchronised, so the Sun may be in the beam. Only the "
                            "operator may jog the mount out, at %1°/s or slower.")
                       .arg(toQString(formatFixed(fastest.degrees(), 1))));
}

Result<> Gates::mayFaceSun() const
{
    if (m_of.profile.sun.keepAway == profile::KeepAway::On) {
        return failure(ErrorCode::Refused, Text::tr("the profile keeps the beam away from the Sun. If feed and "
                                                    "receiver withstand the Sun, switch sun.keep_away off first."));
    }
    return {};
}

Result<> Gates::mayGiveControl() const
{
    if (m_of.arming.stopLatched()) {
        return failure(ErrorCode::Refused, Text::tr("STOP is latched. Reset STOP first."));
    }
    for (const Axis axis : kAxes) {
        if (m_of.mount.report(axis).wrapAsked) {
            return isPlaced(axis);  // clients cannot move the mount before the operator answers
        }
    }
    return m_of.wind.admitsClients();
}

Result<> Gates::mayGiveControlTo(std::uint64_t clientId) const
{
    return mayGiveControl().and_then([&] { return m_of.clientControl.mayBeGiven(m_of.profile.rotctld, clientId); });
}

// The change gives other axis angles to a direction. A tracking mount would leave its target, and a mount on its way to
// a direction would arrive beside it.
Result<> Gates::mayChangePointing() const
{
    if (m_of.current.is(Activity::Streaming)) {
        return failure(ErrorCode::Refused,
                       Text::tr("The mount tracks a target, and the change would move the mount. Press Hold first."));
    }
    const bool goes = m_of.current.is(Activity::Pointing) || m_of.current.is(Activity::Placing);
    if (goes && !StatusReport(m_of).arrived()) {
        return failure(ErrorCode::Refused, Text::tr("The mount moves to a target, and the change would move the mount "
                                                    "elsewhere. Wait until it stands still, or press Hold."));
    }
    return {};
}

Result<> Gates::usesMainAntenna() const
{
    const pointing::Antenna& antenna = m_of.antenna.inUse();
    return antenna.isMain() ? Result<>{}
                            : failure(ErrorCode::Refused,
                                      Text::tr("Antenna \"%1\" is in use. Use the antenna \"main\" to find north.")
                                          .arg(toQString(antenna.name)));
}

Result<> Gates::mayUseAntenna() const
{
    if (StatusReport(m_of).state() == StationState::Calibrate) {
        return failure(ErrorCode::Refused, Text::tr("A calibration moves the mount. End it first."));
    }
    return m_of.antenna.tracks() ? Result<>{} : mayChangePointing();
}

Result<> Gates::mayTurnBeam(const profile::Profile& after) const
{
    if (m_of.antenna.termsBy(after) == m_of.antenna.terms()) {
        return {};
    }
    const bool isChoice = after.pointing == m_of.profile.pointing && after.antennas == m_of.profile.antennas;
    return isChoice ? mayUseAntenna() : mayChangePointing();
}

}  // namespace boresight
