// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/sources/target_track.h"

#include "core/alarms/catalogue.h"
#include "core/base/text.h"
#include "core/base/time_of_day.h"
#include "core/elements/julian_date.h"
#include "core/passes/pass_finder.h"
#include "core/units/duration_text.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace boresight::sources {
namespace {

using Days = std::chrono::duration<double, std::chrono::days::period>;

constexpr std::chrono::hours kSearched{24};
// The rate of a set-point is taken from where the satellite is this much later.
constexpr std::chrono::milliseconds kApart{20};
// Of the points by which the wrap for a pass is chosen.
constexpr std::chrono::seconds kPlanStep{5};

QString nameOf(const orbit::ElementSet& elements)
{
    return elements.name.empty() ? QString::number(elements.number) : toQString(elements.name);
}

Result<> isFresh(const orbit::ElementSet& elements, UtcTime now, double oldestDays)
{
    const double age = std::abs(Days(now - orbit::utcTime(elements.epoch)).count());
    return age <= oldestDays ? Result<>{}
                             : failure(ErrorCode::Refused,
                                       Text::tr("The elements of %1 are %2 days old. The setting oldest_days permits "
                                                "%3. Load newer elements.")
                                           .arg(nameOf(elements))
                                           .arg(age, 0, 'f', 1)
                                           .arg(oldestDays, 0, 'f', 0));
}

Result<passes::Pass> nextPass(const orbit::Sgp4& orbit, const QString& name, const Site& site, UtcTime now)
{
    const passes::PassList list =
        passes::findPasses(orbit, {.site = site, .from = now, .to = now + kSearched, .isClear = {}});
    if (list.passes.empty()) {
        return failure(
            ErrorCode::Refused,
            list.end ? Text::tr("The orbit of %1 cannot be computed: %2").arg(name, orbit::describe(list.end->fault))
                     : Text::tr("%1 does not rise within a day.").arg(name));
    }
    const passes::Pass& pass = list.passes.front();
    if (pass.aos.utc - now > TargetTrack::kLongestWait) {
        return failure(ErrorCode::Refused,
                       Text::tr("%1 rises at %2, in %3. Track it in the last %4 minutes before that.")
                           .arg(name, timeOfDayText(pass.aos.utc), durationText(pass.aos.utc - now))
                           .arg(TargetTrack::kLongestWait.count()));
    }
    return pass;
}

}  // namespace

Result<SkyPointing> TargetTrack::Tracked::at(UtcTime utc) const
{
    const orbit::JulianDate date = orbit::julianDate(utc);
    const orbit::OrbitResult state = orbit.propagate(date);
    if (!state) {
        return failure(ErrorCode::NotAvailable, orbit::describe(state.error()));
    }
    SkyPointing direction = observer.look(orbit::groundState(*state, date)).direction;
    direction.elevation = std::max(direction.elevation, Angle{});  // at its rise, by a hair
    return direction;
}

// Seen a little ahead, so that the drives are there in time.
UtcTime TargetTrack::aimed(UtcTime utc) const
{
    return utc + std::chrono::round<UtcTime::duration>(helm().view().profile.orbit.lead);
}

Result<TargetTrack::Tracked> TargetTrack::plan(const request::Track& wanted, const Source& by) const
{
    const ControlParts view = helm().view();
    const profile::SiteSettings& site = view.profile.site;
    const UtcTime now = view.clock.utc();
    if (!site.known) {
        return failure(ErrorCode::Refused, Text::tr("The site of the mount is not set. Enter it in the profile."));
    }
    const Site here{.latitude = site.latitude, .longitude = site.longitude, .heightMetres = site.heightMetres};
    const orbit::Sgp4 orbit(wanted.elements);
    const QString name = nameOf(wanted.elements);
    return isFresh(wanted.elements, now, view.profile.orbit.oldestDays)
        .and_then([&] { return nextPass(orbit, name, here, now); })
        .map([&](const passes::Pass& pass) {
            return Tracked{.name = name,
                           .number = wanted.elements.number,
                           .orbit = orbit,
                           .observer = orbit::Observer(here),
                           .by = by,
                           .rises = pass.aos.utc,
                           .sets = pass.isUpAtEnd ? std::nullopt : std::optional(pass.los.utc),
                           .isUp = pass.aos.utc <= now};
        });
}

Result<> TargetTrack::ask(const request::Track& wanted, const Source& by)
{
    return operatorOnly(by)
        .and_then([&] { return helm().mayPoint(by); })
        .and_then([&] { return plan(wanted, by); })
        .and_then([&](Tracked tracked) {
            m_utc = {};
            const UtcTime now = m_utc.now(helm().view().clock);
            const UtcTime from = std::max(now, tracked.rises);
            tracked.place = roomyStart(tracked, from);
            return follow(tracked, from).map([&](const AxisPosition& place) {
                tracked.place = place;
                tracked.errand = helm().current().errand();
                m_tracked = std::move(tracked);
                helm().clearAlarm(alarmEntry("track.no-orbit"));
            });
        });
}

// On the wrap nearest to where the axes are going that has room for the rest of the pass.
std::optional<AxisPosition> TargetTrack::roomyStart(const Tracked& tracked, UtcTime from) const
{
    const ControlParts view = helm().view();
    std::optional<AxisPosition> first;
    TravelRange swept;
    Angle last;
    for (UtcTime utc = from; utc <= tracked.sets.value_or(from + kSearched); utc += kPlanStep) {
        const Result<SkyPointing> direction = tracked.at(utc);
        if (!direction) {
            break;
        }
        const AxisPosition axes = view.model.pointing().toAxes(*direction).axes;
        last = first ? axes.azimuth.nearestTo(last) : axes.azimuth;
        first = first.value_or(axes);
        swept =
            utc == from ? TravelRange{last, last} : TravelRange{std::min(swept.min, last), std::max(swept.max, last)};
    }
    if (!first) {
        return std::nullopt;
    }
    const TravelRange& range = view.motion.region().ranges().azimuth;
    std::optional<AxisPosition> best;
    const auto mostTurns = static_cast<int>(std::floor((range.max - swept.max).turns()));
    for (int turns = static_cast<int>(std::ceil((range.min - swept.min).turns())); turns <= mostTurns; ++turns) {
        const AxisPosition start{first->azimuth + Angle::fromTurns(turns), first->elevation};
        const auto way = [&](const AxisPosition& to) { return abs(to.azimuth - helm().heading().azimuth); };
        if (!best || way(start) < way(*best)) {
            best = start;
        }
    }
    return best;
}

Result<AxisPosition> TargetTrack::follow(const Tracked& tracked, UtcTime utc)
{
    const bool waits = utc <= tracked.rises;  // where it rises, standing
    const UtcTime from = waits ? tracked.rises : aimed(utc);
    return tracked.at(from).and_then([&](const SkyPointing& now) {
        return tracked.at(from + kApart).and_then([&](const SkyPointing& soon) {
            return helm().lead({.now = now, .soon = waits ? now : soon, .apart = kApart, .near = tracked.place},
                               tracked.by, Text::tr("track %1").arg(tracked.name));
        });
    });
}

void TargetTrack::step(SteadyTime)
{
    if (!m_tracked) {
        return;
    }
    const CurrentMotion& current = helm().current();
    if (!current.is(Activity::Streaming) || !current.isFor(m_tracked->by)) {
        m_tracked.reset();  // somebody has ended it, or moves the mount
        return;
    }
    if (current.errand() != m_tracked->errand) {
        end(Severity::Advisory, Text::tr("ends the tracking, because control was given away"));
        return;
    }
    const UtcTime utc = m_utc.now(helm().view().clock);
    if (m_utc.jump() != Seconds(0.0)) {
        helm().note(Severity::Warning, Text::tr("the clock of this computer was set by %1 s while %2 is tracked")
                                           .arg(m_utc.jump().count(), 0, 'f', 1)
                                           .arg(m_tracked->name));
    }
    m_tracked->isUp = utc > m_tracked->rises;
    if (m_tracked->sets && utc > *m_tracked->sets) {
        end(Severity::Advisory, Text::tr("%1 has set, and the mount holds").arg(m_tracked->name));
        return;
    }
    const Result<AxisPosition> place = follow(*m_tracked, std::max(utc, m_tracked->rises));
    if (place) {
        m_tracked->place = *place;
        return;
    }
    if (place.error().code == ErrorCode::NotAvailable) {  // no gate refuses it so
        helm().raiseAlarm(alarmEntry("track.no-orbit"), {m_tracked->name, place.error().text});
    }
    end(Severity::Warning, Text::tr("ends the tracking: %1").arg(place.error().text));
}

void TargetTrack::end(Severity severity, const QString& why)
{
    m_tracked.reset();
    helm().end(severity, why);
}

void TargetTrack::describe(StationStatus& status) const
{
    if (m_tracked) {
        status.tracked = TrackedSatellite{.name = m_tracked->name,
                                          .number = m_tracked->number,
                                          .isUp = m_tracked->isUp,
                                          .next = m_tracked->isUp ? m_tracked->sets : std::optional(m_tracked->rises)};
    }
}

}  // namespace boresight::sources
