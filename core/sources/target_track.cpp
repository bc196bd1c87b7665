// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/sources/target_track.h"

#include "core/alarms/catalogue.h"
#include "core/base/text.h"
#include "core/plan/plan_words.h"
#include "core/profile/clear_sky.h"
#include "core/sources/roomy_start.h"
#include "core/targets/track_rules.h"
#include "core/tracking/cable_forecast.h"
#include "core/units/angle_between.h"
#include "core/units/degrees_text.h"
#include "core/units/duration_text.h"

#include <algorithm>
#include <utility>

namespace boresight::sources {
namespace {

// The rate of a set-point is computed from the directions of the target now and this much later.
constexpr std::chrono::milliseconds kApart{20};
// Time between two points of the way, which the screen shows and by which the wrap is chosen. kPassStep is for
// satellites and tables, kSlowStep for all other targets, which move slower.
constexpr std::chrono::seconds kPassStep{5};
constexpr std::chrono::minutes kSlowStep{5};
// A satellite or table that is up for hours gets longer steps instead of more points.
constexpr int kMostSteps = 600;

const orbit::ElementSet* elementsOf(const targets::Target& target)
{
    return std::get_if<orbit::ElementSet>(&target.kind);
}

// The catalogue number of a satellite. Empty for any other target.
std::optional<std::int64_t> numberOf(const targets::Target& target)
{
    const orbit::ElementSet* const elements = elementsOf(target);
    return elements ? std::optional(elements->number) : std::nullopt;
}

// A fixed direction, which may be below the horizon.
bool isDirection(const targets::Target& target)
{
    return std::holds_alternative<SkyPointing>(target.kind);
}

bool isTable(const targets::Target& target)
{
    return std::holds_alternative<tables::SharedTable>(target.kind);
}

// A path of some minutes or hours, known from its rise to its set.
bool isPass(const targets::Target& target)
{
    return elementsOf(target) || isTable(target);
}

// The same direction, for axes that lean over the zenith.
SkyPointing overTheTop(const SkyPointing& direction)
{
    return {.azimuth = direction.azimuth + 180_deg, .elevation = 180_deg - direction.elevation};
}

AngularRate rateBetween(const SkyPointing& from, const SkyPointing& to, UtcTime::duration time)
{
    return angleBetween(from, to) / time;
}

AngularRate fastestOf(const std::vector<targets::SkyMoment>& way)
{
    AngularRate fastest;
    for (std::size_t i = 1; i < way.size(); ++i) {
        fastest = std::max(fastest, rateBetween(way[i - 1].direction, way[i].direction, way[i].utc - way[i - 1].utc));
    }
    return fastest;
}

}  // namespace

Result<SkyPointing> TargetTrack::Tracked::at(UtcTime utc)
{
    // A table may have no directions before its rise and after its set.
    const UtcTime asked = isTable(target) ? std::clamp(utc, up.rises, std::max(up.rises, up.sets.value_or(utc))) : utc;
    return path.at(asked).map([&](SkyPointing direction) {
        if (!isDirection(target)) {
            direction.elevation = std::max(direction.elevation, Angle{});  // at the rise it may be slightly negative
        }
        return direction;
    });
}

// The time for which the mount is aimed: ahead of `utc` by the lead of the profile, because the drives lag.
UtcTime TargetTrack::aimed(UtcTime utc) const
{
    return utc + std::chrono::round<UtcTime::duration>(helm().view().profile.orbit.lead);
}

Result<> TargetTrack::permits(const targets::Target& target, UtcTime now) const
{
    const ControlParts view = helm().view();
    return targets::hasSite(target, view.profile.site.known)
        .and_then([&] { return targets::isSun(target) ? Gates(view).mayFaceSun() : Result<>{}; })
        .and_then([&] { return targets::isFresh(target, now, view.profile.orbit.oldestDays); });
}

// A target that does not move must be reachable when it is requested. A moving target may leave the permitted region:
// then the mount follows along the edge of that region.
Result<> TargetTrack::reaches(Tracked& tracked, UtcTime now) const
{
    return targets::stays(tracked.target)
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
        .and_then([&](const targets::UpTime& up) {
            tracked.up = up;
            tracked.isUp = up.rises <= now;
            return targets::isSoon(target.name, up.rises, now);
        })
        .map([&] { return std::move(tracked); });
}

Result<> TargetTrack::ask(const request::Track& wanted, const Source& by)
{
    return operatorOnly(by)
        .and_then([&] { return helm().mayPoint(by); })
        .and_then([&] { return plan(wanted.target, by); })
        .and_then([&](Tracked tracked) {
            tracked.wanted = wanted.way;
            // The antenna of the satellite is used. If the request is refused, the previous antenna stays in use.
            const std::optional<AntennaChoice::Tracked> before = helm().view().antenna.tracked();
            helm().useAntennaFor(AntennaChoice::Tracked{.satellite = numberOf(wanted.target)});
            Result<> begun = begin(std::move(tracked));
            if (!begun) {
                helm().useAntennaFor(before);
            }
            return begun;
        });
}

Result<> TargetTrack::trackFor(const Source& client, const targets::Target& target)
{
    return helm().mayPoint(client).and_then([&] { return plan(target, client); }).and_then([&](Tracked tracked) {
        return begin(std::move(tracked));
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
    setWay(tracked, from);
    // If the pass has begun, the plan decides whether the mount changes its wrap.
    const bool isWithinPass = isPass(tracked.target) && tracked.isUp;
    tracked.place = isWithinPass ? helm().heading() : roomyStart(helm().view(), *tracked.way);
    const bool goesOn = helm().current().continues(Activity::Streaming, tracked.by);
    return follow(tracked, from).map([&](const AxisPosition& place) {
        if (goesOn && tracked.by.kind != SourceKind::Client) {  // otherwise the log would not show the new target
            helm().note(Severity::Advisory, Text::tr("tracks %1 from now on").arg(tracked.target.name));
        }
        tracked.place = place;
        tracked.motionId = helm().current().motionId();
        m_tracked = std::move(tracked);
        helm().clearAlarm(alarmEntry("track.no-orbit"));
    });
}

void TargetTrack::setWay(Tracked& tracked, UtcTime from) const
{
    tracked.isWayOld = false;
    tracked.way = wayOf(tracked, from);
    tracked.fastest = fastestOf(*tracked.way);
    if (isPass(tracked.target) && tracked.up.sets && from < *tracked.up.sets) {
        const ControlParts view = helm().view();
        if (tracked.wanted && tracked.drive.variant()) {  // planned again: the wrap is the one on which it goes on
            tracked.wanted->startAzimuth = tracked.drive.sideAt(from).azimuth;
        }
        tracked.drive.compute(tracked.path,
                              {.from = from,
                               .to = *tracked.up.sets,
                               .now = view.heading(),
                               .begins = from > tracked.up.rises ? plan::Begins::Now : plan::Begins::Later},
                              tracked.wanted, view);
    }
}

// The way ends when the target sets, or at the last time for which its direction can be computed.
targets::SkyWay TargetTrack::wayOf(Tracked& tracked, UtcTime from) const
{
    const auto isClear = profile::clearSky(helm().view().profile, helm().view().antenna.inUse());
    tracked.terms = helm().view().antenna.terms();
    const UtcTime end = tracked.up.sets.value_or(from + targets::TargetPath::kSearched);
    const UtcTime::duration step =
        isPass(tracked.target) ? std::max<UtcTime::duration>(kPassStep, (end - from) / kMostSteps) : kSlowStep;
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

// How long the target is lost if the mount keeps its wrap and waits at the end of the cable.
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
    const bool waits = utc <= tracked.up.rises;  // the mount stands where the target rises
    const UtcTime from = waits ? tracked.up.rises : aimed(utc);
    return tracked.at(from).and_then([&](const SkyPointing& now) {
        return tracked.at(from + kApart).and_then([&](const SkyPointing& soon) {
            tracked.skyRate = rateBetween(now, soon, kApart);
            tracked.aimedAt = now;
            return point(tracked, {.now = now, .soon = waits ? now : soon, .apart = kApart, .near = tracked.place},
                         from);
        });
    });
}

// By the plan, unless the operator chose to wait at the end of the cable.
Result<AxisPosition> TargetTrack::point(const Tracked& tracked, Helm::Lead lead, UtcTime utc)
{
    const PassDrive& drive = tracked.drive;
    const bool keepsWrap = helm().current().keepsWrap();
    lead.isPlanned = drive.variant() && !keepsWrap;
    const bool unwraps = lead.isPlanned && drive.unwrapsAt(utc);
    const QString what =
        (unwraps ? Text::tr("unwrap the cable for %1") : Text::tr("track %1")).arg(tracked.target.name);
    if (!lead.isPlanned) {
        lead.near = keepsWrap ? std::optional(helm().heading()) : tracked.place;
        return helm().lead(lead, tracked.by, what);
    }
    if (const auto place = drive.placeAt(utc)) {
        const bool stands = lead.now == lead.soon;
        const AxisPosition next = stands ? *place : drive.variant()->placeAt(utc + kApart);
        return helm().leadAxes({.now = *place, .soon = next, .apart = kApart}, tracked.by, what);
    }
    lead.near = drive.sideAt(utc);
    if (helm().view().model.pointing().toSky(*lead.near).elevation > 90_deg) {
        lead.now = overTheTop(lead.now);
        lead.soon = overTheTop(lead.soon);
    }
    return helm().lead(lead, tracked.by, what);
}

void TargetTrack::takePlan(UtcTime utc)
{
    const std::optional<bool> isAsWanted = m_tracked->drive.hasArrived();
    if (!isAsWanted) {
        return;
    }
    helm().clearAlarm(alarmEntry("track.split-pass"));
    if (!m_tracked->drive.variant()) {
        return;
    }
    const plan::PlanVariant& variant = *m_tracked->drive.variant();
    m_tracked->place = variant.placeAt(std::max(utc, m_tracked->up.rises));
    if (!*isAsWanted && utc <= m_tracked->up.rises) {
        helm().note(Severity::Advisory, Text::tr("cannot take the way that was chosen any more: %1. It takes the best")
                                            .arg(plan::titleOf(m_tracked->wanted->way)));
    }
    if (const QString text = plan::planText(variant, m_tracked->target.name); !text.isEmpty()) {
        helm().note(Severity::Advisory, text);
    }
    if (!variant.isWhole()) {
        helm().raiseAlarm(alarmEntry("track.split-pass"),
                          {m_tracked->target.name, plan::splitText(variant), durationText(variant.forecast.beyond)});
    }
}

// Checks again in each tick, because the profile may have changed.
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
        forget();  // the tracking was ended, or another source moves the mount
        return;
    }
    if (current.motionId() != m_tracked->motionId) {
        end(Severity::Advisory, Text::tr("ends the tracking, because control was given away"));
        return;
    }
    const UtcTime utc = m_utc.now(helm().view().clock);
    watchClock();
    if (const Result<> may = m_utc.jump() != Seconds(0.0) ? planAgain(utc) : Result<>{}; !may) {
        end(Severity::Warning, Text::tr("ends the tracking, because the clock was set: %1").arg(may.error().text));
        return;
    }
    renewWay(utc);
    takePlan(utc);
    m_tracked->isUp = utc > m_tracked->up.rises;
    if (m_tracked->up.sets && utc > *m_tracked->up.sets) {
        end(Severity::Advisory, (isTable(m_tracked->target) ? Text::tr("the table of %1 has ended, and the mount holds")
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
    if (place.error().code == ErrorCode::NotAvailable) {  // comes from the path: no gate refuses with this code
        helm().raiseAlarm(alarmEntry("track.no-orbit"), {m_tracked->target.name, place.error().text});
    }
    end(Severity::Warning, Text::tr("ends the tracking: %1").arg(place.error().text));
}

void TargetTrack::profileChanged(const profile::Profile& before, const profile::Profile& after)
{
    const bool isSame = before.limits == after.limits && before.azimuth.limits == after.azimuth.limits &&
                        before.elevation.limits == after.elevation.limits;
    if (m_tracked && !isSame) {
        m_tracked->isWayOld = true;
    }
}

// The profile or the antenna may have changed. The way on the screen must match what the mount does.
void TargetTrack::renewWay(UtcTime utc)
{
    const ephemeris::RefractionRule rule = helm().view().profile.orbit.refraction;
    if (m_tracked->path.rule() != rule || m_tracked->terms != helm().view().antenna.terms() || m_tracked->isWayOld) {
        m_tracked->path.setRule(rule);
        setWay(*m_tracked, std::max(utc, m_tracked->up.rises));
    }
}

// After the clock was set. A pass that had begun may be ahead again, or over.
Result<> TargetTrack::planAgain(UtcTime utc)
{
    return permits(m_tracked->target, utc)
        .and_then([&] { return m_tracked->path.nextUp(utc); })
        .and_then([&](const targets::UpTime& up) {
            return targets::isSoon(m_tracked->target.name, up.rises, utc).map([&] {
                m_tracked->up = up;
                m_tracked->drive = {};
                helm().clearAlarm(alarmEntry("track.split-pass"));
                setWay(*m_tracked, std::max(utc, up.rises));
            });
        });
}

void TargetTrack::watchClock()
{
    const Clock& clock = helm().view().clock;
    const bool isKept = clock.ahead() != Seconds(0.0);  // another alarm reports this
    if (targets::stays(m_tracked->target) || isKept || clock.synchronised()) {
        helm().clearAlarm(alarmEntry("track.clock"));
    } else {
        helm().raiseAlarm(alarmEntry("track.clock"),
                          {m_tracked->target.name, degreesText(m_tracked->fastest * Seconds(1.0), 3)});
    }
}

void TargetTrack::forget()
{
    if (m_tracked && m_tracked->by.kind != SourceKind::Client) {
        helm().endTracking();
    }
    m_tracked.reset();
    helm().clearAlarm(alarmEntry("track.clock"));
    helm().clearAlarm(alarmEntry("track.split-pass"));
}

void TargetTrack::end(Severity severity, const QString& why)
{
    forget();
    helm().end(severity, why);
}

std::optional<SkyPointing> TargetTrack::targetAt(UtcTime utc)
{
    if (!m_tracked || targets::stays(m_tracked->target)) {
        return std::nullopt;
    }
    const Result<SkyPointing> direction = m_tracked->path.at(utc);
    return direction ? std::optional(*direction) : std::nullopt;
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
    status.tracked->plan = m_tracked->drive.variant();
    if (m_tracked->drive.variant() && m_tracked->drive.placeAt(aimed(helm().view().clock.utc()))) {
        status.target = m_tracked->aimedAt;  // the mount goes elsewhere, by the plan
    }
    if (!targets::stays(m_tracked->target)) {
        status.tracked->skyRate = m_tracked->skyRate;
    }
    if (status.cableEnd) {
        const bool isKnown = status.cableEnd->turningBack && m_tracked->place;
        status.cableEnd->lostByHolding = isKnown ? std::optional(lostByHolding()) : std::nullopt;
    }
}

}  // namespace boresight::sources
