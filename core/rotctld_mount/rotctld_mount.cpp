// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/rotctld_mount/rotctld_mount.h"

#include "core/alarms/catalogue.h"
#include "core/base/bus_name.h"
#include "core/base/text.h"
#include "core/rotator_box/box_interlock.h"
#include "core/rotctl/rotctl_error.h"
#include "core/units/degrees_text.h"

namespace boresight::rotctl {
namespace {

// Finer steps would move a rotator with gears to and fro without use. Its accuracy is not known, nor whether its motors
// have a speed control.
constexpr AxisCapabilities kAxis{.step = Angle::fromDegrees(0.1),
                                 .miss = ObedienceWatch::kMet + 0.5 * RotctldMount::kGrain,
                                 .fastest = {},
                                 .silence = RotctldMount::kSilence};

bool lacks(const RotatorState& state, Axis axis)
{
    return state.type == (axis == Axis::Azimuth ? RotatorType::El : RotatorType::Az);
}

Result<> axisFits(const profile::Profile& profile, const RotatorState& state, Axis axis, Angle step)
{
    if (lacks(state, axis)) {
        return failure(
            ErrorCode::Refused,
            axis == Axis::Azimuth
                ? Text::tr("This rotator has no azimuth. Set azimuth.driver to \"none\" in the profile.")
                : Text::tr("This rotator has no elevation. Set elevation.driver to \"none\" in the profile."));
    }
    const TravelRange& reach = axis == Axis::Azimuth ? state.azimuth : state.elevation;
    const TravelRange& travel = profile.axis(axis).geometry.travel;
    constexpr Angle kRounding = Angle::fromDegrees(1e-4);  // rounding of the numbers in its text
    const TravelRange steps = stepsIn(travel, step);
    if (travel.min >= reach.min - kRounding && travel.max <= reach.max + kRounding && steps.min <= steps.max) {
        return {};
    }
    return failure(ErrorCode::Refused,
                   Text::tr("The travel %1…%2 does not fit this rotator. Its rotctld permits %3…%4. Change "
                            "%5.travel_min_deg and %5.travel_max_deg in the profile.")
                       .arg(degreesText(travel.min, 1), degreesText(travel.max, 1), degreesText(reach.min, 1),
                            degreesText(reach.max, 1), tableOf(axis)));
}

}  // namespace

RotctldMount::RotctldMount(const profile::InForce& profile, AlarmBoard& alarms, const AxisSet& axes)
    : BoxMount(profile, alarms, axes, asInProfile(kAxis, *profile), kGrain), m_interlock(fits())
{
    offerHomeRuns();
}

QString RotctldMount::kindInWords() const
{
    return Text::tr("a rotctld");
}

// Some servers do not report the limits. Then only those of the profile count.
Result<> RotctldMount::fits() const
{
    for (const Axis axis : kAxes) {
        if (!capabilities().has(axis)) {
            continue;
        }
        const Result<> counts = countsAsTheRotator(*profile(), axis);
        const Result<> fits = counts && m_checked
                                  ? axisFits(*profile(), *m_checked, axis, capabilities().axes[index(axis)]->step)
                                  : counts;
        if (!fits) {
            return fits;
        }
    }
    return {};
}

void RotctldMount::observe(SteadyTime now)
{
    BoxMount::observe(now);
    if (const auto& state = m_talk.state(); state && state != m_checked) {
        m_checked = state;
        m_interlock = fits();
    }
    m_talk.standsAt(standing());
}

// Noise at a limit of the rotator can put it a little outside, and rotctld would then refuse the command for both axes.
std::optional<AxisPosition> RotctldMount::standing() const
{
    const auto& azimuth = believed(Axis::Azimuth);
    const auto& elevation = believed(Axis::Elevation);
    if (!azimuth || !elevation) {
        return std::nullopt;
    }
    const AxisPosition place = permitted({.azimuth = *azimuth, .elevation = *elevation});
    const bool isNear = abs(place.azimuth - *azimuth) <= kAxis.miss && abs(place.elevation - *elevation) <= kAxis.miss;
    return isNear ? std::optional(place) : std::nullopt;
}

AxisPosition RotctldMount::permitted(const AxisPosition& place) const
{
    return m_checked ? AxisPosition{.azimuth = m_checked->azimuth.clamped(place.azimuth),
                                    .elevation = m_checked->elevation.clamped(place.elevation)}
                     : place;
}

MountFindings RotctldMount::supervise(const MountSituation& known)
{
    MountFindings found = BoxMount::supervise(known);
    if (m_talk.refusals() >= kMostRefusals) {
        loseAll(found, {alarmEntry("rotator.refused"), {errorInWords(m_talk.refusal())}});
    }
    return found;
}

// A command of rotctld has both axes, and rotctld refuses both if one is outside its limits. An axis that does not
// belong to this mount is sent to where it is.
bool RotctldMount::goTo(const RotatorTalk::Places& target)
{
    return target.azimuth && target.elevation &&
           m_talk.go(permitted({.azimuth = *target.azimuth, .elevation = *target.elevation}));
}

QString RotctldMount::remedyOfNoAnswer() const
{
    const bool isOwn = parseBusName(profile()->bus).value_or(BusName{}).kind == BusKind::Hamlib;
    if (m_talk.positionError() != 0 && isOwn) {
        return Text::tr(
                   "The answer of rotctld is: %1. Check the rotator, its power, its cable, its model (bus.name, %2) "
                   "and its speed (bus.baud, %3)")
            .arg(errorInWords(m_talk.positionError()), toQString(profile()->bus))
            .arg(profile()->baud);
    }
    if (isOwn) {
        return Text::tr(
                   "The rotctld of Boresight does not answer. Boresight ends it and starts it again. Check the "
                   "rotator and its port (bus.name, %1)")
            .arg(toQString(profile()->bus));
    }
    if (m_talk.positionError() != 0) {
        return Text::tr(
                   "The answer of rotctld is: %1. Check the rotator, its power, its cable and the options of rotctld")
            .arg(errorInWords(m_talk.positionError()));
    }
    return Text::tr("Check that rotctld still runs there (%1). If it hangs, end it and start it again")
        .arg(toQString(profile()->bus));
}

}  // namespace boresight::rotctl
