// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/sources/target_track.h"

#include "core/alarms/catalogue.h"
#include "core/base/text.h"
#include "core/base/time_of_day.h"
#include "core/elements/julian_date.h"
#include "core/profile/clear_sky.h"
#include "core/sources/roomy_start.h"
#include "core/tracking/cable_forecast.h"
#include "core/units/duration_text.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace boresight::sources {
namespace {

using Days = std::chrono::duration<double, std::chrono::days::period>;

// The rate of a set-point is taken from where the target is this much later.
constexpr std::chrono::milliseconds kApart{20};
// Of the way that is shown, and by which the wrap is chosen: of a satellite or a table, and of all else, which goes
// slower.
constexpr std::chrono::seconds kPassStep{5};
constexpr std::chrono::minutes kSlowStep{5};
// A satellite that is up for half a day is slow, too.
constexpr int kMostSteps = 600;

const orbit::ElementSet* elementsOf(const targets::Target& target)
{
    return std::get_if<orbit::ElementSet>(&target.kind);
}

// Of a satellite.
std::optional<std::int64_t> numberOf(const targets::Target& target)
{
    const orbit::ElementSet* const elements = elementsOf(target);
    return elements ? std::optional(elements->number) : std::nullopt;
}

// A direction of its own, which may be below the horizon.
bool isDirection(const targets::Target& target)
{
    return std::holds_alternative<SkyPointing>(target.kind);
}

bool isTable(const targets::Target& target)
{
    return std::holds_alternative<tables::SharedTable>(target.kind);
}

bool stays(const targets::Target& target)
{
    return isDirection(target) || std::holds_alternative<targets::EarthPosition>(target.kind);
}

Result<> isFresh(const targets::Target& target, UtcTime now, double oldestDays)
{
    const orbit::ElementSet* const elements = elementsOf(target);
    const double age = elements ? std::abs(Days(now - orbit::utcTime(elements->epoch)).count()) : 0.0;
    return age <= oldestDays ? Result<>{}
                             : failure(ErrorCode::Refused,
                                       Text::tr("The elements of %1 are %2 days old. The setting oldest_days permits "
                                                "%3. Load newer elements.")
                                           .arg(target.name)
                                           .arg(age, 0, 'f', 1)
                                           .arg(oldestDays, 0, 'f', 0));
}

Result<targets::UpTime> isSoon(const targets::UpTime& up, const QString& name, UtcTime now)
{
    if (up.rises - now > TargetTrack::kLongestWait) {
        return failure(ErrorCode::Refused,
                       Text::tr("%1 rises at %2, in %3. Track it in the last %4 minutes before that.")
                           .arg(name, timeOfDayText(up.rises), durationText(up.rises - now))
                           .arg(TargetTrack::kLongestWait.count()));
    }
    return up;
}

}  // namespace

Result<SkyPointing> TargetTrack::Tracked::at(UtcTime utc)
{
    // A table has nothing before it rises and after it sets.
    const UtcTime asked = isTable(target) ? std::clamp(utc, up.rises, std::max(up.rises, up.sets.value_or(utc))) : utc;
    return path.at(asked).map([&](SkyPointing direction) {
        if (!isDirection(target)) {
            direction.elevation = std::max(direction.elevation, Angle{});  // at its rise, by a hair
        }
        return direction;
    });
}

// Seen a little ahead, so that the drives are there in time.
UtcTime TargetTrack::aimed(UtcTime utc) const
{
    return utc + std::chrono::round<UtcTime::duration>(helm().view().profile.orbit.lead);
}

Result<> TargetTrack::permits(const targets::Target& target, UtcTime now) const
{
    const ControlParts view = helm().view();
    if (!view.profile.site.known && targets::needsSite(target)) {
        return failure(ErrorCode::Refused, Text::tr("The site of the mount is not set. Enter it in the profile."));
    }
    const Result<> mayFace = targets::isSun(target) ? Gates(view).mayFaceSun() : Result<>{};
    return mayFace.and_then([&] { return isFresh(target, now, view.profile.orbit.oldestDays); });
}

// What stays is reached now or never. What moves is led along the edge of what is permitted.
Result<> TargetTrack::reaches(Tracked& tracked, UtcTime now) const
{
    return stays(tracked.target)
               ? tracked.at(now).and_then([&](const SkyPointing& there) { return helm().reaches(there); })
               : Result<>{};
}

Result<TargetTrack::Tracked> TargetTrack::plan(const targets::Target& target, const Source& by) const
{
    const ControlParts view = helm().view();
    const UtcTime now = view.clock.utc();
    if (const Result<> may = permits(target, now); !may) {
        return tl::unexpected(may.error());
    }
    const Site site = view.profile.site.place();
    Tracked tracked{.target = target,
                    .path = targets::TargetPath(target, site, view.profile.orbit.refraction),
                    .site = site,
                    .by = by};
    return tracked.path.nextUp(now)
        .and_then([&](const targets::UpTime& up) { return isSoon(up, target.name, now); })
        .map([&](const targets::UpTime& up) {
            tracked.up = up;
            tracked.isUp = up.rises <= now;
            return std::move(tracked);
        });
}

Result<> TargetTrack::ask(const request::Track& wanted, const Source& by)
{
    return operatorOnly(by)
        .and_then([&] { return helm().mayPoint(by); })
        .and_then([&] { return plan(wanted.target, by); })
        .and_then([&](Tracked tracked) {
            // Its beam goes there. A refusal leaves the antenna that was in use.
            const std::optional<AntennaChoice::Tracked> before = helm().view().antenna.tracked();
            helm().useAntennaFor(AntennaChoice::Tracked{.satellite = numberOf(wanted.target)});
            Result<> begun = begin(std::move(tracked));
            if (!begun) {
                helm().useAntennaFor(before);
            }
            return begun;
        });
}

Result<> TargetTrack::begin(Tracked tracked)
{
    m_utc = {};
    const UtcTime now = m_utc.now(helm().view().clock);
    if (Result<> may = reaches(tracked, now); !may) {
        return may;
    }
    const UtcTime from = std::max(now, tracked.up.rises);
    tracked.way = wayOf(tracked, from);
    tracked.place = roomyStart(helm().view(), *tracked.way);
    const bool goesOn = helm().current().continues(Activity::Streaming, tracked.by);
    return follow(tracked, from).map([&](const AxisPosition& place) {
        if (goesOn) {  // no motion begins that the log would name
            helm().note(Severity::Advisory, Text::tr("tracks %1 from now on").arg(tracked.target.name));
        }
        tracked.place = place;
        tracked.errand = helm().current().errand();
        m_tracked = std::move(tracked);
        helm().clearAlarm(alarmEntry("track.no-orbit"));
    });
}

// It ends with its set, or where its orbit ends.
targets::SkyWay TargetTrack::wayOf(Tracked& tracked, UtcTime from) const
{
    const auto isClear = profile::clearSky(helm().view().profile, helm().view().antenna.inUse());
    tracked.terms = helm().view().antenna.terms();
    const UtcTime end = tracked.up.sets.value_or(from + targets::TargetPath::kSearched);
    const bool isFast = elementsOf(tracked.target) || isTable(tracked.target);
    const UtcTime::duration step =
        isFast ? std::max<UtcTime::duration>(kPassStep, (end - from) / kMostSteps) : kSlowStep;
    auto way = std::make_shared<std::vector<targets::SkyMoment>>();
    for (UtcTime utc = from; way->empty() || way->back().utc < end; utc = std::min(utc + step, end)) {
        const Result<SkyPointing> direction = tracked.at(utc);
        if (!direction) {
            break;
        }
        way->push_back({.utc = utc, .direction = *direction, .isHidden = !isClear(*direction)});
    }
    return way;
}

// If the mount waits at the end of the cable on the wrap that it has now.
Seconds TargetTrack::lostByHolding() const
{
    const ControlParts view = helm().view();
    const UtcTime now = view.clock.utc();
    Angle last = m_tracked->place->azimuth;
    std::vector<tracking::PathMoment> path{{.in = Seconds(0.0), .azimuth = last}};
    for (const targets::SkyMoment& moment : *m_tracked->way) {
        if (moment.utc > now) {
            last = view.model.pointing().toAxes(moment.direction).axes.azimuth.nearestTo(last);
            path.push_back({.in = moment.utc - now, .azimuth = last, .isReachable = !moment.isHidden});
        }
    }
    return tracking::timeBeyond(path, view.motion.region().ranges().azimuth);
}

Result<AxisPosition> TargetTrack::follow(Tracked& tracked, UtcTime utc)
{
    const bool waits = utc <= tracked.up.rises;  // where it rises, standing
    const UtcTime from = waits ? tracked.up.rises : aimed(utc);
    return tracked.at(from).and_then([&](const SkyPointing& now) {
        return tracked.at(from + kApart).and_then([&](const SkyPointing& soon) {
            return helm().lead({.now = now, .soon = waits ? now : soon, .apart = kApart, .near = tracked.place},
                               tracked.by, Text::tr("track %1").arg(tracked.target.name));
        });
    });
}

// The profile may have changed.
Result<> TargetTrack::mayGoOn() const
{
    if (helm().view().profile.site.place() != m_tracked->site) {
        return failure(ErrorCode::Refused, Text::tr("The site of the mount was changed. Track the target again."));
    }
    return targets::isSun(m_tracked->target) ? Gates(helm().view()).mayFaceSun() : Result<>{};
}

void TargetTrack::step(SteadyTime)
{
    if (!m_tracked) {
        return;
    }
    const CurrentMotion& current = helm().current();
    if (!current.is(Activity::Streaming) || !current.isFor(m_tracked->by)) {
        forget();  // somebody has ended it, or moves the mount
        return;
    }
    if (current.errand() != m_tracked->errand) {
        end(Severity::Advisory, Text::tr("ends the tracking, because control was given away"));
        return;
    }
    const UtcTime utc = m_utc.now(helm().view().clock);
    watchClock();
    renewWay(utc);
    m_tracked->isUp = utc > m_tracked->up.rises;
    if (m_tracked->up.sets && utc > *m_tracked->up.sets) {
        end(Severity::Advisory,
            (isTable(m_tracked->target) ? Text::tr("the table of %1 leads no further, and the mount holds")
                                        : Text::tr("%1 has set, and the mount holds"))
                .arg(m_tracked->target.name));
        return;
    }
    followOn(std::max(utc, m_tracked->up.rises));
}

void TargetTrack::followOn(UtcTime utc)
{
    const Result<AxisPosition> place = mayGoOn().and_then([&] { return follow(*m_tracked, utc); });
    if (place) {
        m_tracked->place = *place;
        return;
    }
    if (place.error().code == ErrorCode::NotAvailable) {  // no gate refuses it so
        helm().raiseAlarm(alarmEntry("track.no-orbit"), {m_tracked->target.name, place.error().text});
    }
    end(Severity::Warning, Text::tr("ends the tracking: %1").arg(place.error().text));
}

// The profile or the antenna may have changed. The way that is shown goes the same as the mount.
void TargetTrack::renewWay(UtcTime utc)
{
    const ephemeris::RefractionRule rule = helm().view().profile.orbit.refraction;
    if (m_tracked->path.rule() != rule || m_tracked->terms != helm().view().antenna.terms()) {
        m_tracked->path.setRule(rule);
        m_tracked->way = wayOf(*m_tracked, std::max(utc, m_tracked->up.rises));
    }
}

// A direction and a place on the Earth are where they are at any time.
void TargetTrack::watchClock()
{
    const targets::TargetKind& kind = m_tracked->target.kind;
    const bool needsTime =
        !std::holds_alternative<SkyPointing>(kind) && !std::holds_alternative<targets::EarthPosition>(kind);
    if (!needsTime || helm().view().clock.synchronised()) {
        helm().clearAlarm(alarmEntry("track.clock"));
    } else {
        helm().raiseAlarm(alarmEntry("track.clock"), {m_tracked->target.name});
    }
}

void TargetTrack::forget()
{
    m_tracked.reset();
    helm().endTracking();
    helm().clearAlarm(alarmEntry("track.clock"));
}

void TargetTrack::end(Severity severity, const QString& why)
{
    forget();
    helm().end(severity, why);
}

void TargetTrack::describe(StationStatus& status) const
{
    if (!m_tracked) {
        return;
    }
    status.tracked = TrackedTarget{.name = m_tracked->target.name,
                                   .isUp = m_tracked->isUp,
                                   .next = m_tracked->isUp ? m_tracked->up.sets : std::optional(m_tracked->up.rises),
                                   .way = m_tracked->way};
    status.tracked->number = numberOf(m_tracked->target);
    if (status.cableEnd && status.cableEnd->turningBack && m_tracked->place) {
        status.cableEnd->lostByHolding = lostByHolding();
    }
}

}  // namespace boresight::sources
