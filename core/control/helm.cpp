// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/control/helm.h"

#include "core/base/text.h"
#include "core/mount/mount_service.h"
#include "core/pointing/nearest_permitted.h"
#include "core/units/direction_text.h"
#include "core/units/duration_text.h"

#include <utility>

namespace boresight {

QString Helm::directionText(const AxisPosition& place) const
{
    return boresight::directionText(view().model.pointing().toSky(place));
}

Result<> Helm::mayGoTo(const AxisPosition& place) const
{
    const pointing::Resolved resolved = view().model.resolve(place);
    if (const Result<> may = Gates(view()).mayBeAt(place); !may) {
        const auto nearest =
            resolved.limited ? std::nullopt : pointing::nearestPermitted(m_of.motion.region(), resolved.position);
        return nearest ? failure(ErrorCode::OutOfRange,
                                 Text::tr("%1. Nearest allowed: %2.")
                                     .arg(may.error().text,
                                          beamText(pointing::upright(view().model.pointing().toSky(*nearest)))))
                       : may;
    }
    return view().endSwitches.admitsWay(standing(), resolved.position).and_then([&] {
        return m_of.motion.route(standing(), resolved.position).map([](const auto&) {});
    });
}

Result<AxisPosition> Helm::placeOf(const SkyPointing& direction) const
{
    return placeNear(direction, view().stoppingPlace());
}

Result<AxisPosition> Helm::placeNear(const SkyPointing& direction, const AxisPosition& near) const
{
    const pointing::Resolved resolved = view().model.resolve(direction, near);
    if (resolved.limited) {
        return failure(ErrorCode::OutOfRange, resolved.reason);
    }
    return resolved.position;
}

Result<AxisPosition> Helm::aimOf(const SkyPointing& direction) const
{
    return placeOf(direction).and_then([&](const AxisPosition& place) {
        return Gates(view()).isElevation(direction.elevation).map([&] { return place; });
    });
}

Result<AxisPosition> Helm::placeAlong(Axis axis, Angle angle, const AxisPosition& from) const
{
    constexpr int kRounds = 3;  // with a skewed mast one beam angle depends on both axes, so repeat
    constexpr Angle kHalfTurn = Angle::fromDegrees(180.0);
    AxisPosition place = from;
    for (int i = 0; i < kRounds; ++i) {
        SkyPointing beam = view().model.pointing().toSky(place);
        const bool overTheTop = beam.elevation > Angle::fromDegrees(90.0);
        (axis == Axis::Azimuth ? beam.azimuth : beam.elevation) =
            axis == Axis::Azimuth && overTheTop ? angle + kHalfTurn : angle;
        auto found = placeNear(beam, from);
        if (!found || view().model.pointing().isXY()) {
            return found;  // X and Y both change with each angle of the beam
        }
        (axis == Axis::Azimuth ? place.azimuth : place.elevation) =
            axis == Axis::Azimuth ? found->azimuth : found->elevation;
    }
    return place;
}

Result<> Helm::reaches(const SkyPointing& direction) const
{
    return placeOf(direction).and_then([&](const AxisPosition& place) -> Result<> {
        constexpr Angle kZenith = Angle::fromDegrees(90.0);
        if (direction.elevation > kZenith && place.elevation <= kZenith) {
            return failure(
                ErrorCode::OutOfRange,
                Text::tr("The travel and the limits of the axes do not permit this direction over the top."));
        }
        return mayGoTo(place);
    });
}

Result<> Helm::mayAim(const SkyPointing& direction) const
{
    return aimOf(direction).and_then([this](const AxisPosition& place) { return mayGoTo(turnWithAWay(place)); });
}

// A short text, because the direction is shown beside it.
QString Helm::obstacleAt(const SkyPointing& direction) const
{
    const auto place = aimOf(direction);
    return place ? m_of.motion.region().obstacle(*place) : place.error().text;
}

std::optional<SkyPointing> Helm::nearestTo(const SkyPointing& direction) const
{
    const pointing::Resolved resolved = view().model.resolve(direction, view().stoppingPlace());
    const auto place = pointing::nearestPermitted(m_of.motion.region(), resolved.position);
    const auto beam = place ? std::optional(view().model.toSky(*place)) : std::nullopt;
    return beam && mayAim(*beam) ? beam : std::nullopt;
}

DirectionVerdict Helm::judge(const SkyPointing& direction) const
{
    const Result<> may = mayAim(direction);
    if (may) {
        return {};
    }
    const QString obstacle = obstacleAt(direction);
    if (obstacle.isEmpty()) {
        return {.whyNot = may.error().text};  // the direction itself is permitted, but no way leads to it
    }
    return {.whyNot = obstacle, .nearest = nearestTo(direction)};
}

Result<> Helm::goTo(const AxisPosition& place, Activity activity, const Source& by, const QString& what)
{
    const Gates gates(view());
    const Result<> may = activity == Activity::Parking ? gates.mayPark(by) : gates.mayPoint(by);
    return may.and_then([&] { return mayGoTo(place); }).map([&] {
        const AxisPosition end = view().model.resolve(place).position;
        begin(activity, by, what, arrivalText(end));
        commanded(by);
        m_of.motion.goTo(end);
    });
}

// The calculation begins where the axes stand, because Boresight will take them over from there.
QString Helm::arrivalText(const AxisPosition& place) const
{
    Motion ahead = m_of.motion;
    if (!m_of.mount.follows()) {
        ahead.start(Axis::Azimuth, standing().azimuth);
        ahead.start(Axis::Elevation, standing().elevation);
    }
    ahead.enforceRegion(true);
    ahead.goTo(place);
    const auto course = Course::of(std::move(ahead), now());
    return course ? Text::tr("there in %1").arg(durationText(course->duration())) : QString();
}

Result<> Helm::goToAnyTurn(const AxisPosition& place, Activity activity, const Source& by, const QString& what)
{
    const AxisPosition other = turnWithAWay(place);
    const auto back = turnBackTo(other, by);
    return goTo(other, activity, by, what).map([&] { beginTurnBack(back); });
}

// The nearest wrap of this place that the axes can reach. If they can reach none, the place itself.
AxisPosition Helm::turnWithAWay(const AxisPosition& place) const
{
    const TravelRange& range = m_of.motion.region().ranges().azimuth;
    for (const double turns : {0.0, -1.0, 1.0, -2.0, 2.0}) {
        const AxisPosition other{.azimuth = place.azimuth + Angle::fromTurns(turns), .elevation = place.elevation};
        if (range.contains(other.azimuth) && m_of.motion.route(standing(), other)) {
            return other;
        }
    }
    return place;
}

Result<> Helm::streamTo(const SkyPointing& direction, const Source& by, const QString& what, bool anew)
{
    return mayPoint(by).and_then([&] {
        const AxisPosition near = anew ? view().stoppingPlace() : nearestWrapOf(direction, by);
        if (anew) {
            m_of.motion.rest();
        }
        return follow(view().model.resolve(direction, near), direction, by, what).map([&] {
            m_of.current.ask(direction);
        });
    });
}

// A point that continues a stream is on the wrap nearest to the last point, also while the axes lag behind. A point far
// from the last one is a new target, unless the points are a path in the sky.
AxisPosition Helm::nearestWrapOf(const SkyPointing& point, const Source& by) const
{
    constexpr Angle kElsewhere = Angle::fromDegrees(90.0);
    const AxisPosition last = heading();
    const Angle leap = abs(view().model.resolve(point, last).position.azimuth - last.azimuth);
    const bool goesOn = continuesStream(by) && (leap < kElsewhere || m_of.motion.streaming(now()));
    return goesOn ? last : view().stoppingPlace();
}

Result<> Helm::streamTo(const AxisPosition& place, const Source& by)
{
    return mayPoint(by).and_then([&] {
        const pointing::MountModel& model = view().model;
        return follow(model.resolve(place), model.toSky(place), by, {}).map([&] {
            m_of.current.ask(model.pointing().toSky(place));
        });
    });
}

Result<AxisPosition> Helm::lead(const Lead& lead, const Source& by, const QString& what)
{
    const AxisPosition before = continuesStream(by) ? heading() : view().stoppingPlace();
    const pointing::Resolved aim = view().model.resolve(lead.now, lead.near.value_or(before));
    return mayPoint(by).and_then([&] { return view().endSwitches.admitsWay(standing(), aim.position); }).map([&] {
        const pointing::MountModel& model = view().model;
        pointing::Resolved here = aim;
        const bool goesOn = continuesStream(by);
        const bool onWrap = lead.near && abs(here.position.azimuth - lead.near->azimuth) < 180_deg;
        auto back = goesOn && onWrap ? std::nullopt : turnBackTo(here.position, by);
        if (waitsAtEnd(back, by)) {
            here = endOf(*std::exchange(back, std::nullopt), here.position);
        }
        const pointing::Resolved there = model.resolve(lead.soon, here.position);
        const bool limited = here.limited || !m_of.motion.region().permits(here.position);
        begin(Activity::Streaming, by, what);
        beginTurnBack(back);
        if (lead.isPlanned) {
            m_of.current.setPlanned();
        }
        if (limited) {
            m_of.current.limit(here.limited ? here.reason : m_of.motion.region().reason(here.position), lead.now);
        }
        // At an end of the travel the next place can be on another wrap. Then the difference is no rate.
        const auto rate = [&](Angle from, Angle to) {
            return abs(to - from) < 90_deg ? (to - from) / lead.apart : AngularRate{};
        };
        m_of.motion.lead(here.position,
                         {.azimuth = rate(here.position.azimuth, there.position.azimuth),
                          .elevation = rate(here.position.elevation, there.position.elevation)},
                         now());
        return here.position;
    });
}

Result<AxisPosition> Helm::leadAxes(const AxisLead& lead, const Source& by, const QString& what)
{
    return mayPoint(by).and_then([&] { return view().endSwitches.admitsWay(standing(), lead.now); }).map([&] {
        begin(Activity::Streaming, by, what);
        m_of.current.setPlanned();
        if (const pointing::PermittedRegion& region = m_of.motion.region(); !region.permits(lead.now)) {
            m_of.current.limit(region.reason(lead.now), view().model.pointing().toSky(lead.now));
        }
        m_of.motion.lead(lead.now,
                         {.azimuth = (lead.soon.azimuth - lead.now.azimuth) / lead.apart,
                          .elevation = (lead.soon.elevation - lead.now.elevation) / lead.apart},
                         now());
        return lead.now;
    });
}

Result<> Helm::follow(pointing::Resolved resolved, const SkyPointing& asked, const Source& by, const QString& what)
{
    if (const QString why = m_of.motion.region().reason(resolved.position); !resolved.limited && !why.isEmpty()) {
        resolved.limited =
            true;  // Motion finds the nearest permitted place, and continues when the stream is permitted again
        resolved.reason = why;
    }
    if (resolved.limited && view().profile.rotctld.outsideLimits == profile::OutsideLimits::Refuse) {
        return failure(ErrorCode::OutOfRange, resolved.reason);
    }
    if (Result<> may = view().endSwitches.admitsWay(standing(), resolved.position); !may) {
        return may;
    }
    const bool wasLimited = !current().limitedReason().isEmpty();
    const bool newStream = !current().is(Activity::Streaming) || !current().isFor(by);
    auto back = turnBackTo(resolved.position, by);
    if (waitsAtEnd(back, by)) {
        resolved = endOf(*std::exchange(back, std::nullopt), resolved.position);
    }
    begin(Activity::Streaming, by, what.isEmpty() ? Text::tr("go to %1").arg(boresight::directionText(asked)) : what);
    commanded(by);
    beginTurnBack(back);
    if (newStream) {
        m_of.motion.rest();  // the stream of another client does not continue the earlier points
    }
    if (resolved.limited) {
        m_of.current.limit(resolved.reason, asked);
        if (newStream || !wasLimited) {
            m_of.log.add(
                Severity::Warning, by,
                Text::tr("goes to the nearest permitted point because of a limit (%1)").arg(current().limitedReason()));
        }
    }
    m_of.current.aim(resolved.position);
    m_of.motion.follow(resolved.position, now());
    return {};
}

std::optional<CableGuard::TurnBack> Helm::turnBackTo(const AxisPosition& place, const Source& by) const
{
    if (view().model.pointing().isXY()) {
        return std::nullopt;
    }
    const bool follows = current().is(Activity::Streaming) && current().isFor(by);
    const AxisPosition chosen = follows ? heading() : view().stoppingPlace();
    return CableGuard::turnBackTo(place.azimuth,
                                  {.here = standing().azimuth, .heading = chosen.azimuth, .follows = follows},
                                  m_of.motion.region().ranges().azimuth);
}

bool Helm::waitsAtEnd(const std::optional<CableGuard::TurnBack>& back, const Source& by) const
{
    return back && current().keepsWrap() && continuesStream(by);
}

pointing::Resolved Helm::endOf(const CableGuard::TurnBack& back, const AxisPosition& place)
{
    return {
        .position = {.azimuth = back.end, .elevation = place.elevation},
        .limited = true,
        .reason =
            Text::tr("the cable ends at axis %1, and the operator chose to hold there").arg(degreesText(back.end, 1))};
}

void Helm::keepWrap(const Source& by)
{
    m_of.current.keepWrap();
    m_of.log.insist(Severity::Advisory, by, Text::tr("chooses to hold at the cable end instead of unwrapping"));
}

// The log names the unwrapping as a motion of its own, because the mount leaves its target meanwhile.
void Helm::beginTurnBack(const std::optional<CableGuard::TurnBack>& back)
{
    if (back) {
        m_of.log.add(Severity::Advisory, current().commander(),
                     m_of.cable.begin(*back, m_of.motion.limits(Axis::Azimuth)), LogKind::MotionStart);
    }
}

Result<> Helm::runAt(const AxisRates& rates, Activity activity, const Source& by, const QString& what)
{
    return mayRun(rates, activity, by).and_then([&] { return m_of.firstMoves.admits(view(), rates); }).map([&] {
        begin(activity, by, what);
        commanded(by);
        m_of.motion.run(rates);
    });
}

Result<> Helm::mayRun(const AxisRates& rates, Activity activity, const Source& by) const
{
    const Gates gates(view());
    if (activity == Activity::Jogging) {
        return gates.mayJog(rates, by);
    }
    return gates.mayMove(by)
        .and_then([&] { return view().endSwitches.admits(rates); })
        .and_then([&] { return gates.axesPlaced(); })
        .and_then([&] { return gates.mayLeaveSunBand({}, {}); });
}

void Helm::setTrim(const AxisPosition& trim, const Source& by)
{
    m_of.motion.setTrim(trim);
    const QString what = view().model.pointing().isXY()
                             ? Text::tr("trims the tracked target by %1 in X, %2 in Y")
                             : Text::tr("trims the tracked target by %1 in azimuth, %2 in elevation");
    m_of.log.insist(Severity::Advisory, by, what.arg(degreesText(trim.azimuth, 2), degreesText(trim.elevation, 2)));
}

void Helm::settleStream(const Source& by)
{
    if (current().is(Activity::Streaming) && current().isFor(by)) {
        m_of.motion.settleStream();
        m_of.current.settleStream();
    }
}

void Helm::commanded(const Source& by)
{
    if (by.kind == SourceKind::Client) {
        m_of.clientControl.moved(by, now());
    }
}

void Helm::confirmStream(std::uint64_t clientId)
{
    if (current().is(Activity::Streaming) && current().isForClient(clientId)) {
        m_of.motion.confirmStream(now());
        m_of.clientControl.followed(clientId, now());
    }
}

void Helm::hold(Activity left)
{
    if (m_of.mount.proofRunning()) {
        m_of.mount.service()->endProof(Text::tr("ended before it was done"));
    }
    m_of.current.end(left);
    m_of.motion.rest();
}

void Helm::end(Severity severity, const QString& why)
{
    m_of.log.insist(severity, current().commander(), why);
    hold(Activity::Holding);
}

void Helm::takeOver(const Source& by, Taking how)
{
    if (by.kind != SourceKind::Operator) {
        return;
    }
    if (m_of.arming.authority() == Authority::Clients) {
        const QString from = m_of.clientControl.taken(now());
        m_of.log.add(
            Severity::Advisory, by,
            from.isEmpty()
                ? Text::tr("takes control, and Boresight refuses motion commands of clients")
                : Text::tr("takes control from %1, and Boresight refuses motion commands of clients").arg(from));
    }
    m_of.arming.takeAuthority(how);
}

Result<> Helm::beginOwn(Activity activity, const Source& by, const QString& what)
{
    return mayPoint(by).map([&] { begin(activity, by, what); });
}

void Helm::begin(Activity activity, const Source& by, const QString& what, const QString& detail)
{
    takeOver(by);
    if (!current().continues(activity, by)) {
        m_of.cable.forgetTurnBack();
        const QString line = Text::tr("moves the mount from %1: %2").arg(directionText(standing()), what);
        m_of.log.add(Severity::Advisory, by, detail.isEmpty() ? line : line + QStringLiteral(", ") + detail,
                     LogKind::MotionStart);
    }
    m_of.current.begin(activity, by, what);
    m_of.mount.engage();
}

}  // namespace boresight
