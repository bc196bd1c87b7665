// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/guards/end_switch_guard.h"

#include "core/alarms/catalogue.h"
#include "core/base/text.h"
#include "core/units/degrees_text.h"

#include <algorithm>

namespace boresight {
namespace {

using end_switches::EndSwitch;
using end_switches::indexOf;
using end_switches::kEndSwitches;
using end_switches::SwitchState;

QString endName(const EndSwitch& one)
{
    if (one.axis == Axis::Azimuth) {
        return one.isUpper ? Text::tr("the upper end of the azimuth") : Text::tr("the lower end of the azimuth");
    }
    return one.isUpper ? Text::tr("the upper end of the elevation") : Text::tr("the lower end of the elevation");
}

// The alarm in this place is about one switch.
AlarmKey keyOf(const AlarmEntry& entry, const EndSwitch& one)
{
    constexpr std::array<const char*, kEndSwitches.size()> kSubjects{"azimuth lower", "azimuth upper",
                                                                     "elevation lower", "elevation upper"};
    return entry.of(QLatin1String(kSubjects.at(indexOf(one))));
}

}  // namespace

bool EndSwitchGuard::isUsed(const EndSwitch& one) const
{
    return !m_of.profile->endSwitches.input(one).empty();
}

std::optional<bool> EndSwitchGuard::isPressed(const EndSwitch& one) const
{
    const std::optional<bool>& isOn = m_readings.at(indexOf(one)).isOn;
    const bool whenOn = m_of.profile->endSwitches.pressedWhen == profile::PressedWhen::On;
    return isOn ? std::optional(*isOn == whenOn) : std::nullopt;
}

bool EndSwitchGuard::isClosed(const EndSwitch& one) const
{
    const SwitchState state = m_watches.at(indexOf(one)).state();
    const bool counts = m_of.profile->endSwitches.whenUnread == profile::WhenUnread::Pressed;
    return isUsed(one) && (state == SwitchState::Pressed || (state == SwitchState::Unread && counts));
}

std::optional<EndSwitchGuard::Hit> EndSwitchGuard::step(bool isFault, bool isReachable, SteadyTime now)
{
    if (!m_of.profile->endSwitches.isUsed()) {
        return std::nullopt;
    }
    m_since = m_since.value_or(now);
    std::optional<Hit> found;
    for (const EndSwitch& one : kEndSwitches) {
        if (!isUsed(one)) {
            continue;
        }
        end_switches::SwitchWatch& watch = m_watches.at(indexOf(one));
        const bool wasPressed = watch.state() == SwitchState::Pressed;
        watch.step(isPressed(one), now);
        const bool isMet = !wasPressed && watch.state() == SwitchState::Pressed && !m_of.motion.atRest();
        std::optional<SwitchState>& hitIn = m_hitIn.at(indexOf(one));
        hitIn = isFault ? hitIn : std::nullopt;
        if (isClosed(one) && !hitIn && m_of.motion.goesInto(one.axis, one.isUpper)) {
            hitIn = m_watches.at(indexOf(one)).state();
            found = found.value_or(Hit{.axis = one.axis, .why = whyClosed(one)});
        }
        if (isMet) {
            judgePlace(one);
            if (m_losses.at(indexOf(one))) {
                found = Hit{.axis = one.axis, .why = whyLost(one)};
            }
        }
        tell(one, isReachable, now);
    }
    return found;
}

// A switch that a person presses by hand while nothing moves shows nothing about the axis.
void EndSwitchGuard::judgePlace(const EndSwitch& one)
{
    const profile::EndSwitchSettings& settings = m_of.profile->endSwitches;
    const std::optional<Angle> known = settings.place(one);
    const std::optional<Angle> shown = m_of.mount.report(one.axis).place;
    if (known && shown) {
        const bool isLost = abs(*shown - *known) > settings.lostSteps;
        m_losses.at(indexOf(one)) = isLost ? std::optional(Loss{.shown = *shown, .known = *known}) : std::nullopt;
    }
}

QString EndSwitchGuard::whyLost(const EndSwitch& one) const
{
    const Loss& loss = *m_losses.at(indexOf(one));
    return Text::tr("The end switch at %1 was met at %2, but it is at %3")
        .arg(endName(one), degreesText(loss.shown, 1), degreesText(loss.known, 1));
}

void EndSwitchGuard::tell(const EndSwitch& one, bool isReachable, SteadyTime now)
{
    const end_switches::SwitchWatch& watch = m_watches.at(indexOf(one));
    const bool isUnread =
        watch.state() == SwitchState::Unread && isReachable && (watch.wasRead() || now - *m_since >= kPatience);
    if (isUnread) {
        const AlarmEntry& entry = isClosed(one) ? alarmEntry("switch.unread") : alarmEntry("switch.ignored");
        m_of.alarms.raise(keyOf(entry, one),
                          {endName(one), problemOf(one), toQString(m_of.profile->endSwitches.input(one))});
    } else {
        m_of.alarms.clear(keyOf(alarmEntry("switch.unread"), one));
    }
    if (const auto& loss = m_losses.at(indexOf(one))) {
        m_of.alarms.raise(keyOf(alarmEntry("switch.lost-steps"), one),
                          {endName(one), degreesText(loss->shown, 1), degreesText(loss->known, 1)});
    } else {
        m_of.alarms.clear(keyOf(alarmEntry("switch.lost-steps"), one));
    }
    if (m_hitIn.at(indexOf(one)) == SwitchState::Pressed && !m_losses.at(indexOf(one))) {
        m_of.alarms.raise(keyOf(alarmEntry("switch.hit"), one), {endName(one)});
    } else if (watch.state() == SwitchState::Pressed) {
        m_of.alarms.raise(keyOf(alarmEntry("switch.pressed"), one), {endName(one)});
    } else {
        m_of.alarms.clear(keyOf(alarmEntry("switch.pressed"), one));
    }
}

QString EndSwitchGuard::problemOf(const EndSwitch& one) const
{
    const QString& problem = m_readings.at(indexOf(one)).problem;
    return problem.isEmpty() ? Text::tr("no reading has come yet") : problem;
}

QString EndSwitchGuard::whyClosed(const EndSwitch& one) const
{
    return m_watches.at(indexOf(one)).state() == SwitchState::Pressed
               ? Text::tr("The end switch at %1 is pressed").arg(endName(one))
               : Text::tr("The end switch at %1 cannot be read (%2), so it counts as pressed")
                     .arg(endName(one), problemOf(one));
}

ClosedEnds EndSwitchGuard::closed(Axis axis) const
{
    return {.lower = isClosed({axis, false}), .upper = isClosed({axis, true})};
}

bool EndSwitchGuard::isUrgent() const
{
    return std::ranges::any_of(kEndSwitches, [this](const EndSwitch& one) {
        return isClosed(one) && m_of.motion.goesInto(one.axis, one.isUpper);
    });
}

Result<> EndSwitchGuard::admits(Axis axis, bool upwards) const
{
    const EndSwitch one{.axis = axis, .isUpper = upwards};
    return isClosed(one)
               ? failure(ErrorCode::OutOfRange, Text::tr("%1. Move the axis the other way.").arg(whyClosed(one)))
               : Result<>{};
}

Result<> EndSwitchGuard::admits(const AxisRates& rates) const
{
    for (const EndSwitch& one : kEndSwitches) {
        const AngularRate rate = one.axis == Axis::Azimuth ? rates.azimuth : rates.elevation;
        if (one.isUpper ? rate > AngularRate{} : rate < AngularRate{}) {
            if (const Result<> may = admits(one.axis, one.isUpper); !may) {
                return may;
            }
        }
    }
    return {};
}

Result<> EndSwitchGuard::admitsWay(const AxisPosition& from, const AxisPosition& to) const
{
    const auto sign = [](Angle way) {
        return abs(way) < kAtEdge ? AngularRate{} : AngularRate::fromDegrees(way > Angle{} ? 1.0 : -1.0);
    };
    return admits(
        AxisRates{.azimuth = sign(to.azimuth - from.azimuth), .elevation = sign(to.elevation - from.elevation)});
}

void EndSwitchGuard::clearAlarms()
{
    for (const EndSwitch& one : kEndSwitches) {
        m_of.alarms.clear(keyOf(alarmEntry("switch.unread"), one));
        m_of.alarms.clear(keyOf(alarmEntry("switch.pressed"), one));
        m_of.alarms.clear(keyOf(alarmEntry("switch.lost-steps"), one));
    }
}

void EndSwitchGuard::profileChanged(const profile::Profile& before, const profile::Profile& after)
{
    if (before.endSwitches == after.endSwitches) {
        return;
    }
    m_readings = {};
    m_watches = {};
    m_hitIn = {};
    m_losses = {};
    m_since.reset();
    clearAlarms();
}

std::vector<EndSwitchStatus> EndSwitchGuard::status() const
{
    std::vector<EndSwitchStatus> all;
    for (const EndSwitch& one : kEndSwitches) {
        if (isUsed(one)) {
            all.push_back({.which = one,
                           .input = toQString(m_of.profile->endSwitches.input(one)),
                           .state = m_watches.at(indexOf(one)).state(),
                           .problem = m_readings.at(indexOf(one)).problem,
                           .isClosed = isClosed(one)});
        }
    }
    return all;
}

}  // namespace boresight
