// SPDX-License-Identifier: GPL-3.0-or-later
// The part of StationControl about the azimuth cable: unwinding, and telling in time that it ends before the pass does
// and that the mount turns back because it ends.
#include "core/base/numbers.h"
#include "core/base/text.h"
#include "core/control/station_control.h"
#include "core/tracking/cable_forecast.h"
#include "core/units/degrees_text.h"

#include <QDateTime>

#include <algorithm>
#include <cmath>

namespace boresight {
namespace {

const QString kCableCause = QStringLiteral("azimuth cable");
// Whichever is earlier. Told a little longer than begun, so that a path that trembles does not come and go.
constexpr Seconds kWarnTime{60.0};
constexpr Angle kWarnAngle = Angle::fromDegrees(30.0);
constexpr double kKeep = 1.3;
constexpr std::uint64_t kTicksBetween = 10;
// The path bends, and with it the time that was told: told anew when it is off by this, or by a fifth of what is left.
constexpr Seconds kTimeOff{10.0};
constexpr double kPartOff = 0.2;
constexpr Seconds kToldAnewAfter{10.0};
// A stream's next target is no farther away than this; what is farther is another target.
constexpr Angle kNextOfStream = Angle::fromDegrees(10.0);
constexpr Angle kTurnedBack = Angle::fromDegrees(1.0);
constexpr Angle kSameWay = Angle::fromDegrees(1e-6);

// Ramps included; the jerk adds a part of a second.
Seconds turnTime(const tracking::MotionLimits& limits)
{
    return Seconds(360.0 / limits.speed.degrees() + limits.speed.degrees() / limits.acceleration.degrees());
}

QString timeText(Seconds time)
{
    return time < Seconds(100.0) ? QStringLiteral("%1 s").arg(std::lround(time.count()))
                                 : QStringLiteral("%1 min").arg(std::lround(time.count() / 60.0));
}

QString clockText(UtcTime utc)
{
    const auto time = std::chrono::round<std::chrono::seconds>(utc).time_since_epoch();
    return QDateTime::fromSecsSinceEpoch(time.count(), Qt::UTC).toString(QStringLiteral("HH:mm:ss'Z'"));
}

}  // namespace

// Of the turns of this direction the one nearest to the cable that is not wound, 0°; empty if it stands there.
std::optional<AxisPosition> StationControl::leastWound(const AxisPosition& place) const
{
    const TravelRange& range = m_motion.region().ranges().azimuth;
    std::optional<AxisPosition> best;
    Angle least = abs(place.azimuth);
    for (double turns = std::ceil((range.min - place.azimuth).turns()); turns <= (range.max - place.azimuth).turns();
         turns += 1.0) {
        const AxisPosition other{.azimuth = place.azimuth + Angle::fromTurns(turns), .elevation = place.elevation};
        if (turns != 0.0 && abs(other.azimuth) < least) {
            least = abs(other.azimuth);
            best = other;
        }
    }
    return best;
}

Result<> StationControl::handle(const request::Unwind&, const Source& source)
{
    return mayPoint(source).and_then([&]() -> Result<> {
        const auto place = leastWound(standing());
        if (!place) {
            return failure(ErrorCode::Refused,
                           Text::tr("in this direction the azimuth cable can not be wound less than it is"));
        }
        return goTo(*place, Activity::Pointing, source,
                    Text::tr("unwind the cable, azimuth to %1").arg(degreesText(place->azimuth, 1)));
    });
}

void StationControl::watchCable()
{
    if (m_tick % kTicksBetween != 0) {
        return;
    }
    const TravelRange& range = m_motion.region().ranges().azimuth;
    const auto path = m_activity == Activity::Streaming && turnsKnown() ? m_motion.path(m_now) : std::nullopt;
    const auto forecast = path ? tracking::forecastCableEnd(*path, range) : std::nullopt;
    const double keep = m_cableEnd ? kKeep : 1.0;
    if (!forecast || (forecast->in > kWarnTime * keep && forecast->left > kWarnAngle * keep)) {
        m_cableEnd.reset();
        m_cableTold.reset();
        m_alarms.clear(kCableCause);
        return;
    }
    const Angle back = Angle::fromTurns(forecast->end == range.max ? -1.0 : 1.0);
    m_cableEnd =
        CableEnd{.end = forecast->end,
                 .in = forecast->in,
                 .turningBack = range.contains(forecast->end + back) ? std::optional(turnTime(m_profile.azimuth.limits))
                                                                     : std::nullopt};
    tellCable(*m_cableEnd);
}

bool StationControl::cableTold(const CableTold& end, Seconds in) const
{
    if (!m_cableTold || end.severity > m_cableTold->severity) {
        return false;
    }
    const Seconds off = std::chrono::abs(Seconds(end.ends - m_cableTold->ends));
    return off < std::max(kTimeOff, kPartOff * in) || end.when - m_cableTold->when < kToldAnewAfter;
}

// When it comes in sight, when it is near, and when it turns out to end at another time. The time of day stays true
// while it is read; the bar counts.
void StationControl::tellCable(const CableEnd& end)
{
    const Severity severity = end.in > kWarnTime ? Severity::Advisory : Severity::Warning;
    const CableTold now{.severity = m_cableTold ? std::max(severity, m_cableTold->severity) : severity,
                        .ends = m_clock.utc() + std::chrono::round<UtcTime::duration>(end.in),
                        .when = m_now};
    if (cableTold(now, end.in)) {
        return;
    }
    m_cableTold = now;
    const QString what =
        Text::tr("azimuth cable ends at %1, about %2").arg(degreesText(end.end, 1), clockText(now.ends));
    if (end.turningBack) {
        m_alarms.raise(kCableCause, now.severity,
                       {.what = what,
                        .action = Text::tr("There Boresight turns back by 360° and follows on; the target is "
                                           "lost for about %1")
                                      .arg(timeText(*end.turningBack)),
                        .remedy = Text::tr("To turn back earlier press Unwind, then give control back")});
    } else {
        m_alarms.raise(kCableCause, now.severity,
                       {.what = what,
                        .action = Text::tr("Boresight holds there until the target can be reached again"),
                        .remedy = Text::tr("Widen the limits if the cable allows, or let the target go")});
    }
}

// Both from where the axes are going, which chose the turn, and from where they are.
std::optional<StationControl::TurnBack> StationControl::turnBackTo(const AxisPosition& place,
                                                                   const Source& source) const
{
    const TravelRange& range = m_motion.region().ranges().azimuth;
    const auto leadsBeyond = [&](Angle from) {
        const Angle near = place.azimuth.nearestTo(from);
        const bool bothAsNear = abs(abs(near - from) - 180_deg) < kSameWay;
        return !bothAsNear && abs(near - place.azimuth) > 180_deg && !range.contains(near);
    };
    const Angle here = standing().azimuth;
    if (!leadsBeyond(heading().azimuth) || !leadsBeyond(here)) {
        return std::nullopt;
    }
    const Angle near = place.azimuth.nearestTo(here);
    const bool follows = m_activity == Activity::Streaming && m_commander == source && abs(near - here) < kNextOfStream;
    return TurnBack{.by = place.azimuth - (follows ? near : here),
                    .end = near > range.max ? range.max : range.min,
                    .follows = follows};
}

// The log names it as a motion of its own: the mount leaves a target that it seemed to follow.
void StationControl::beginTurnBack(const std::optional<TurnBack>& back)
{
    if (!back) {
        return;
    }
    m_turnBack = back;
    const QString what = Text::tr("turns back by %1: the cable ends at %2")
                             .arg(degreesText(abs(back->by), 0), degreesText(back->end, 1));
    tell(Severity::Advisory, m_commander,
         back->follows
             ? Text::tr("%1; the target is lost for about %2").arg(what, timeText(turnTime(m_profile.azimuth.limits)))
             : what,
         LogKind::MotionStart);
}

// Until it is there, or is led the other way again.
void StationControl::watchTurnBack()
{
    if (!m_turnBack) {
        return;
    }
    const auto target = moves() && m_motion.noWay().empty() ? m_motion.target(m_now) : std::nullopt;
    const double sign = m_turnBack->by < Angle{} ? -1.0 : 1.0;
    if (!target || sign * (target->azimuth - m_motion.place().azimuth) < kTurnedBack) {
        m_turnBack.reset();
    }
}

// Short, for the line below the state.
QString StationControl::turnBackText() const
{
    return Text::tr("cable ends: turns back by %1").arg(degreesText(abs(m_turnBack->by), 0));
}

}  // namespace boresight
