// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/guards/cable_guard.h"

#include "core/alarms/catalogue.h"
#include "core/base/text.h"
#include "core/base/time_of_day.h"
#include "core/tracking/cable_room.h"
#include "core/units/degrees_text.h"

#include <algorithm>
#include <cmath>

namespace boresight {
namespace {

// The alarm is raised when the first of these two limits is met. The limits for clearing it are 1.3 times as wide, so
// that the alarm does not come and go when the predicted path varies a little.
constexpr Seconds kWarnTime{60.0};
constexpr Angle kWarnAngle = Angle::fromDegrees(30.0);
constexpr double kKeep = 1.3;
constexpr std::uint64_t kTicksBetween = 10;
// The predicted time varies with the bends of the path. A change smaller than this leaves the alarm text as it is.
constexpr Seconds kTimeOff{2.0};
// Two targets of one stream are no farther apart than this. A target farther away is a different one.
constexpr Angle kNextOfStream = Angle::fromDegrees(10.0);
constexpr Angle kTurnedBack = Angle::fromDegrees(1.0);
constexpr Angle kSameWay = Angle::fromDegrees(1e-6);

// How long the target of a stream is lost if the mount waits at the end. Its path is unknown, so it counts as turning
// on at its present azimuth rate: half a turn later the mount reaches it again on the other side, after half a turn of
// its own. Coarse steps, so that the number stands still. Empty: the azimuth of the target stands.
std::optional<Seconds> lostByWaiting(AngularRate azimuthRate, const tracking::MotionLimits& limits)
{
    constexpr AngularRate kSlowestTarget = AngularRate::fromDegrees(0.001);
    constexpr Seconds kCoarseTime{10.0};
    if (abs(azimuthRate) < kSlowestTarget) {
        return std::nullopt;
    }
    const Seconds lost = Seconds(180_deg / (abs(azimuthRate) * Seconds(1.0))) + tracking::fullTurnTime(limits) / 2.0;
    return kCoarseTime * std::round(lost / kCoarseTime);
}

QString timeText(Seconds time)
{
    return time < Seconds(100.0) ? QStringLiteral("%1 s").arg(std::lround(time.count()))
                                 : QStringLiteral("%1 min").arg(std::lround(time.count() / 60.0));
}

}  // namespace

std::optional<AxisPosition> CableGuard::leastWound(const AxisPosition& place, const TravelRange& range)
{
    std::optional<AxisPosition> best;
    Angle least = abs(place.azimuth);
    const int most = static_cast<int>(std::floor((range.max - place.azimuth).turns()));
    for (int turns = static_cast<int>(std::ceil((range.min - place.azimuth).turns())); turns <= most; ++turns) {
        const AxisPosition other{.azimuth = place.azimuth + Angle::fromTurns(turns), .elevation = place.elevation};
        if (turns != 0 && abs(other.azimuth) < least) {
            least = abs(other.azimuth);
            best = other;
        }
    }
    return best;
}

bool CableGuard::hasOtherWrap(Angle end, const TravelRange& range)
{
    return range.contains(end + Angle::fromTurns(end == range.max ? -1.0 : 1.0));
}

// Judges from where the axis is going and from where it is. Only if both ways lead beyond the end, the mount unwraps.
std::optional<CableGuard::TurnBack> CableGuard::turnBackTo(Angle azimuth, const Way& way, const TravelRange& range)
{
    const auto leadsBeyond = [&](Angle from) {
        const Angle near = azimuth.nearestTo(from);
        const bool bothAsNear = abs(abs(near - from) - 180_deg) < kSameWay;
        return !bothAsNear && abs(near - azimuth) > 180_deg && !range.contains(near);
    };
    if (!leadsBeyond(way.heading) || !leadsBeyond(way.here)) {
        return std::nullopt;
    }
    const Angle near = azimuth.nearestTo(way.here);
    const bool follows = way.follows && abs(near - way.here) < kNextOfStream;
    return TurnBack{.by = azimuth - (follows ? near : way.here),
                    .end = near > range.max ? range.max : range.min,
                    .follows = follows};
}

QString CableGuard::begin(const TurnBack& back, const tracking::MotionLimits& limits)
{
    m_turnBack = back;
    const QString by = degreesText(abs(back.by), 0);
    const QString end = degreesText(back.end, 1);
    return back.follows
               ? Text::tr("unwraps the cable by %1 because the cable ends at axis %2. The target is lost for about %3")
                     .arg(by, end, timeText(tracking::fullTurnTime(limits)))
               : Text::tr("goes the long way, %1, because the cable ends at axis %2").arg(by, end);
}

void CableGuard::watch(const std::optional<tracking::MovingTarget>& path, const std::optional<Angle>& left,
                       const TravelRange& range, const tracking::MotionLimits& limits, bool keepsWrap,
                       const std::optional<Angle>& heldAt)
{
    if (++m_ticks % kTicksBetween == 0) {
        if (heldAt) {
            holdAt(*heldAt, keepsWrap && hasOtherWrap(*heldAt, range));
        } else {
            watchEnd(path, range, limits, keepsWrap);
        }
    }
    watchTurnBack(left);
}

void CableGuard::watchEnd(const std::optional<tracking::MovingTarget>& path, const TravelRange& range,
                          const tracking::MotionLimits& limits, bool keepsWrap)
{
    const auto forecast = path ? tracking::forecastCableEnd(*path, range) : std::nullopt;
    const double keep = m_end ? kKeep : 1.0;
    if (!forecast || (forecast->in > kWarnTime * keep && forecast->left > kWarnAngle * keep)) {
        m_end.reset();
        m_told.reset();
        m_alarms.clear(alarmEntry("cable.ends"));
        return;
    }
    const bool canTurnBack = hasOtherWrap(forecast->end, range);
    const bool turnsBack = canTurnBack && !keepsWrap;
    m_end = CableEnd{.end = forecast->end,
                     .in = forecast->in,
                     .turningBack = turnsBack ? std::optional(tracking::fullTurnTime(limits)) : std::nullopt,
                     .lostByHolding = turnsBack ? lostByWaiting(path->rates.azimuth, limits) : std::nullopt};
    tell(*m_end, canTurnBack && keepsWrap);
}

// Where the mount has no other wrap, target.outside gives the reason.
void CableGuard::holdAt(Angle end, bool isChosen)
{
    m_end = CableEnd{.end = end, .in = Seconds(0.0), .turningBack = std::nullopt};
    m_told.reset();
    if (isChosen) {
        m_alarms.raise(alarmEntry("cable.held"), {degreesText(end, 1)});
    } else {
        m_alarms.clear(alarmEntry("cable.ends"));
    }
}

bool CableGuard::isTold(const Told& end) const
{
    return m_told && end.entry == m_told->entry && end.severity <= m_told->severity &&
           std::chrono::abs(Seconds(end.ends - m_told->ends)) < kTimeOff;
}

// The first alarm is an advisory. It becomes a warning when the end is near. Its time is corrected as the path
// changes.
void CableGuard::tell(const CableEnd& end, bool holdIsChosen)
{
    const AlarmEntry& entry = end.turningBack ? alarmEntry("cable.turns-back")
                              : holdIsChosen  ? alarmEntry("cable.hold-chosen")
                                              : alarmEntry("cable.ends");
    const Severity severity = end.in > kWarnTime ? Severity::Advisory : Severity::Warning;
    const Told now{.severity = m_told ? std::max(severity, m_told->severity) : severity,
                   .ends = m_clock.utc() + std::chrono::round<UtcTime::duration>(end.in),
                   .entry = &entry};
    if (isTold(now)) {
        return;
    }
    m_told = now;
    QStringList when{degreesText(end.end, 1), timeOfDayText(now.ends)};
    if (end.turningBack) {
        when << timeText(*end.turningBack);
    }
    m_alarms.raise(entry, now.severity, when);
}

// The unwrapping is over when the axis is nearly there, or is sent the other way.
void CableGuard::watchTurnBack(const std::optional<Angle>& left)
{
    if (m_turnBack && (!left || (m_turnBack->by < Angle{} ? -*left : *left) < kTurnedBack)) {
        m_turnBack.reset();
    }
}

std::optional<QString> CableGuard::turnBackText() const
{
    if (!m_turnBack) {
        return std::nullopt;
    }
    const QString by = degreesText(abs(m_turnBack->by), 0);
    return m_turnBack->follows ? Text::tr("unwraps the cable by %1").arg(by)
                               : Text::tr("cable end, long way %1").arg(by);
}

}  // namespace boresight
