// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/orientation/judge.h"

#include <cmath>

namespace boresight::orientation {
namespace {

// The sensor sends a sentence about every second. At this part of the time until "lost", two of five are missing.
constexpr double kLateShare = 0.6;
// The values have two decimals.
constexpr Angle kRounding = Angle::fromDegrees(0.005);
// Noise, wind and averaging over a second can add this much to a motion.
constexpr Angle kMargin = Angle::fromDegrees(5.0);
constexpr int kBelievedAgain = 3;  // the jump and two values that agree with it

constexpr Calibration kUncalibrated{};

}  // namespace

bool isDeadMark(const Orientation& value, Angle declinationInSensor)
{
    return abs(value.heading.since(SensorHeading::folded(declinationInSensor))) < kRounding &&
           value.elevation == Angle{} && value.temperature.value_or(0.0) == 0.0 &&
           value.calibration.value_or(kUncalibrated) == kUncalibrated;
}

ValueFate Judge::take(const Orientation& value)
{
    m_dead = isDeadMark(value, m_settings.declinationInSensor);
    if (m_dead) {
        return ValueFate::Dead;
    }
    if (!isBelieved(value)) {
        ++m_outliers;
        return ValueFate::Outlier;
    }
    use(value);
    return ValueFate::Used;
}

void Judge::forget()
{
    const std::uint64_t breaks = m_breaks + 1;
    *this = Judge(m_settings);
    m_breaks = breaks;
}

Presence Judge::presence(SteadyTime now) const
{
    if (!m_last) {
        return Presence::Awaited;
    }
    const Seconds age = now - m_last->arrival;
    return age >= m_settings.lost                ? Presence::Lost
           : age >= m_settings.lost * kLateShare ? Presence::Late
                                                 : Presence::Present;
}

std::optional<SteadyTime> Judge::frozenSince() const
{
    return m_last && m_sameSince < m_last->arrival ? m_sameSince : std::nullopt;
}

Angle Judge::course() const
{
    return m_last ? m_last->heading.angle() + Angle::fromTurns(static_cast<double>(m_turns)) : Angle{};
}

bool Judge::follows(const Orientation& before, const Orientation& value) const
{
    const Seconds gap = value.arrival - before.arrival;
    const Angle azimuth = abs(value.heading.since(before.heading));
    const Angle elevation = abs(value.elevation - before.elevation);
    return azimuth <= m_settings.azimuthSpeed * gap + kMargin && elevation <= m_settings.elevationSpeed * gap + kMargin;
}

// After a longer silence no comparison is possible, because the antenna may be anywhere.
bool Judge::isBelieved(const Orientation& value)
{
    if (!m_last || value.arrival - m_last->arrival >= m_settings.lost || follows(*m_last, value)) {
        return true;
    }
    m_agreeing = m_doubted && follows(*m_doubted, value) ? m_agreeing + 1 : 1;
    m_doubted = value;
    return m_agreeing >= kBelievedAgain;
}

// After a restart the sensor's count begins at 0, or at -1 if the first heading is above 180°. Its calibration begins
// again, too. A jump of the count that the antenna may have turned during a silence is not a restart.
bool Judge::isRestart(const Orientation& value) const
{
    const Angle turned = value.extendedAzimuth - m_last->extendedAzimuth;
    const Angle leap = abs(turned - turned.wrapped180());
    const Angle possible = m_settings.azimuthSpeed * Seconds(value.arrival - m_last->arrival) + kMargin;
    const bool counted =
        leap > kRounding && abs(turned) > possible && (value.revolutions == 0 || value.revolutions == -1);
    const bool uncalibrated = m_last->calibration && value.calibration && *value.calibration == kUncalibrated &&
                              m_last->calibration->gyro > 0 && m_last->calibration->magnetometer > 0;
    return counted || uncalibrated;
}

void Judge::use(const Orientation& value)
{
    const bool restarted = m_last && isRestart(value);
    const bool followed = m_last && value.arrival - m_last->arrival < m_settings.lost && follows(*m_last, value);
    m_restarts += restarted ? 1 : 0;
    m_breaks += restarted || !followed ? 1 : 0;
    if (m_last) {
        const Angle way = value.heading.since(m_last->heading);
        const Angle passed = m_last->heading.angle() + way - value.heading.angle();  // whole turns
        m_turns += std::llround(passed.turns());
    }
    const bool same = m_last && m_last->heading == value.heading && m_last->elevation == value.elevation;
    m_sameSince = same ? m_sameSince : std::optional(value.arrival);
    m_last = value;
    m_doubted.reset();
    m_agreeing = 0;
}

}  // namespace boresight::orientation
