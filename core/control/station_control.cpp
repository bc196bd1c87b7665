// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/control/station_control.h"

#include "core/base/text.h"
#include "core/pointing/sun_keep_out.h"
#include "core/units/degrees_text.h"

#include <algorithm>

namespace boresight {
namespace {

constexpr int kClientLinesPerSecond = 4;

QString text(const AxisPosition& place)
{
    return degreesText(place.azimuth, 2) + QStringLiteral(" ") + degreesText(place.elevation, 2);
}

QString text(const SkyPointing& direction)
{
    return degreesText(direction.azimuth, 2) + QStringLiteral(" ") + degreesText(direction.elevation, 2);
}

// As far as clients ask for one.
bool asksForMotion(const Request& request)
{
    return std::holds_alternative<request::PointSky>(request) || std::holds_alternative<request::PointAxes>(request) ||
           std::holds_alternative<request::Move>(request) || std::holds_alternative<request::Park>(request);
}

bool isZero(const AxisRates& rates)
{
    return rates == AxisRates{};
}

}  // namespace

StationControl::StationControl(const profile::Profile& profile, const Clock& clock, EventLog& log,
                               TurnKeeper::Start start)
    : m_profile(profile),
      m_clock(clock),
      m_log(log),
      m_model(profile.azimuth.geometry, profile.elevation.geometry, pointing::PointingModel(profile.pointing)),
      m_drives(profile),
      m_motion(profile),
      m_sun(profile),
      m_arming(profile, m_drives, log),
      m_alarms(log, clock),
      m_sunAlarms(m_alarms),
      m_watches{DriveWatch(Axis::Azimuth, profile, m_alarms), DriveWatch(Axis::Elevation, profile, m_alarms)},
      m_turns(profile, clock, log, std::move(start)),
      m_turnWatch(m_turns, m_drives, m_watches, m_alarms),
      m_stall(m_drives, m_watches, m_turns, m_alarms, log),
      m_proof(m_drives, m_motion, m_turns, m_turnWatch, log),
      m_cable(m_alarms, clock),
      m_clientLines(log, clock, kClientLinesPerSecond),
      m_started(clock.now()),
      m_now(m_started)
{
    (void)m_sun.update(clock);
    enforceRegion();
    tellAdvice();
}

ControlParts StationControl::parts() const
{
    return {.profile = m_profile,
            .clock = m_clock,
            .model = m_model,
            .drives = m_drives,
            .motion = m_motion,
            .current = m_current,
            .arming = m_arming,
            .lead = m_lead,
            .turns = m_turns,
            .facts = m_turnWatch,
            .proof = m_proof,
            .cable = m_cable,
            .sun = m_sun,
            .alarms = m_alarms,
            .now = m_now,
            .tick = m_tick};
}

Result<> StationControl::request(const Request& request, const Source& source)
{
    if (source.kind == SourceKind::Client && asksForMotion(request)) {
        clientAsked(source);
    }
    return std::visit([&](const auto& wanted) { return handle(wanted, source); }, request);
}

void StationControl::takeOver(const Source& source)
{
    if (source.kind == SourceKind::Operator && m_arming.authority() == Authority::Clients) {
        m_arming.setAuthority(Authority::Operator);
        tell(Severity::Advisory, source, Text::tr("takes over: motion commands of clients are refused"));
    }
}

void StationControl::tell(Severity severity, const Source& source, const QString& what, LogKind kind)
{
    if (source.kind == SourceKind::Client) {
        m_clientLines.add(severity, source.name, what, kind);
    } else {
        m_log.add(severity, source.name, what, kind);
    }
}

void StationControl::begin(Activity activity, const Source& source, const QString& what)
{
    takeOver(source);
    if (!m_current.continues(activity, source)) {
        m_cable.forgetTurnBack();
        tell(Severity::Advisory, source, Text::tr("moves the mount from %1: %2").arg(directionText(heading()), what),
             LogKind::MotionStart);
    }
    if (source.kind == SourceKind::Client) {
        m_lead.moved(source, m_now);
    }
    m_current.begin(activity, source, what);
    m_drives.engage();
}

void StationControl::holdHere(Activity left)
{
    if (m_proof.running()) {
        m_proof.end(Text::tr("ended before it was done"));
    }
    m_current.end(left);
    m_motion.rest();
}

Result<> StationControl::goTo(const AxisPosition& place, Activity activity, const Source& source, const QString& what)
{
    return mayPoint(source).and_then([&] { return mayGoTo(place); }).map([&] {
        begin(activity, source, what);
        m_motion.goTo(m_model.resolve(place).position);
    });
}

Result<> StationControl::mayGoTo(const AxisPosition& place) const
{
    const pointing::Resolved resolved = m_model.resolve(place);
    if (const Result<> may = gates().mayBeAt(place); !may) {
        const auto nearest = resolved.limited ? std::nullopt : m_motion.region().nearest(resolved.position);
        return nearest ? failure(ErrorCode::OutOfRange, Text::tr("%1; permitted nearest to it: %2")
                                                            .arg(toQString(may.error().text), directionText(*nearest)))
                       : may;
    }
    return m_motion.route(standing(), resolved.position).map([](const auto&) {});
}

// Of the turns of a direction the one nearest to where it is sought that can be reached; if none can, the place itself.
AxisPosition StationControl::turnWithAWay(const AxisPosition& place) const
{
    const TravelRange& range = m_motion.region().ranges().azimuth;
    for (const double turns : {0.0, -1.0, 1.0, -2.0, 2.0}) {
        const AxisPosition other{.azimuth = place.azimuth + Angle::fromTurns(turns), .elevation = place.elevation};
        if (range.contains(other.azimuth) && m_motion.route(standing(), other)) {
            return other;
        }
    }
    return place;
}

Result<> StationControl::streamTo(pointing::Resolved resolved, const SkyPointing& asked, const Source& source,
                                  const QString& what)
{
    if (const std::string why = m_motion.region().reason(resolved.position); !resolved.limited && !why.empty()) {
        resolved.limited = true;  // Motion finds the nearest permitted place, and goes on when the stream comes out
        resolved.reason = why;
    }
    if (resolved.limited && m_profile.rotctld.outsideLimits == profile::OutsideLimits::Refuse) {
        return failure(ErrorCode::OutOfRange, resolved.reason);
    }
    const bool wasLimited = !m_current.limitedReason().isEmpty();
    const bool newStream = !m_current.is(Activity::Streaming) || !m_current.isFor(source);
    const auto back = turnBackTo(resolved.position, source);
    begin(Activity::Streaming, source, what.isEmpty() ? QStringLiteral("P ") + text(asked) : what);
    beginTurnBack(back);
    if (newStream) {
        m_motion.rest();  // the points of another client say nothing about this one's
    }
    if (resolved.limited) {
        m_current.limit(toQString(resolved.reason), asked);
        if (newStream || !wasLimited) {
            tell(Severity::Warning, source,
                 Text::tr("LIMITED: %1; driven to the nearest permitted point").arg(m_current.limitedReason()));
        }
    }
    m_motion.follow(resolved.position, m_now);
    return {};
}

std::optional<CableGuard::TurnBack> StationControl::turnBackTo(const AxisPosition& place, const Source& source) const
{
    const bool follows = m_current.is(Activity::Streaming) && m_current.isFor(source);
    return CableGuard::turnBackTo(place.azimuth,
                                  {.here = standing().azimuth, .heading = heading().azimuth, .follows = follows},
                                  m_motion.region().ranges().azimuth);
}

// The log names it as a motion of its own: the mount leaves a target that it seemed to follow.
void StationControl::beginTurnBack(const std::optional<CableGuard::TurnBack>& back)
{
    if (back) {
        tell(Severity::Advisory, m_current.commander(), m_cable.begin(*back, m_profile.azimuth.limits),
             LogKind::MotionStart);
    }
}

Result<> StationControl::handle(const request::PointSky& wanted, const Source& source)
{
    return mayPoint(source).and_then([&]() -> Result<> {
        const pointing::Resolved resolved = m_model.resolve(wanted.direction, heading());
        if (source.kind == SourceKind::Client) {
            return streamTo(resolved, wanted.direction, source);
        }
        if (resolved.limited) {
            return failure(ErrorCode::OutOfRange, resolved.reason);
        }
        if (const Angle top = std::max(90_deg, m_model.elevation().travel.max); wanted.direction.elevation > top) {
            // To a client 95° is the equal direction behind the zenith; an operator who types it has slipped.
            return failure(ErrorCode::OutOfRange,
                           Text::tr("elevation %1 above limit %2")
                               .arg(degreesText(wanted.direction.elevation, 2), degreesText(top, 2)));
        }
        const AxisPosition place = turnWithAWay(resolved.position);
        const auto back = turnBackTo(place, source);
        return goTo(place, Activity::Pointing, source, Text::tr("go to %1").arg(text(wanted.direction))).map([&] {
            beginTurnBack(back);
        });
    });
}

Result<> StationControl::handle(const request::PointAxes& wanted, const Source& source)
{
    if (source.kind == SourceKind::Client) {
        return mayPoint(source).and_then(
            [&] { return streamTo(m_model.resolve(wanted.position), m_model.toSky(wanted.position), source); });
    }
    return goTo(wanted.position, Activity::Pointing, source, Text::tr("go to axes %1").arg(text(wanted.position)));
}

Result<> StationControl::handle(const request::Step& wanted, const Source& source)
{
    const AxisPosition from = heading();
    const AxisPosition place{.azimuth = from.azimuth + wanted.azimuth, .elevation = from.elevation + wanted.elevation};
    const std::uint64_t errand = m_current.errand();
    return goTo(place, Activity::Pointing, source, Text::tr("step to %1").arg(directionText(place))).map([&] {
        m_current.setErrand(errand);  // by hand, like a jog
    });
}

Result<> StationControl::handle(const request::Park&, const Source& source)
{
    return goTo(m_profile.park, Activity::Parking, source, Text::tr("park at %1").arg(directionText(m_profile.park)));
}

Result<> StationControl::handle(const request::Unwind&, const Source& source)
{
    return mayPoint(source).and_then([&] { return gates().unwound(); }).and_then([&](const AxisPosition& place) {
        return goTo(place, Activity::Pointing, source,
                    Text::tr("unwind the cable, azimuth to %1").arg(degreesText(place.azimuth, 1)));
    });
}

Result<> StationControl::handle(const request::Home&, const Source& source)
{
    const AxisPosition home = gates().home();
    return goTo(home, Activity::Pointing, source, Text::tr("home to %1").arg(directionText(home)));
}

// Down to 0°, or as far as it goes.
Result<> StationControl::handle(const request::Horizon&, const Source& source)
{
    const AxisPosition here = standing();
    AxisPosition low{.azimuth = here.azimuth, .elevation = 0_deg};
    if (!m_motion.region().permits(low)) {
        low.elevation = std::max(0_deg, m_motion.region().elevationsAround(pointing::AxisBox::at(here)).min);
    }
    return goTo(low, Activity::Pointing, source, Text::tr("horizon at %1").arg(directionText(low)));
}

Result<> StationControl::runAt(const AxisRates& rates, Activity activity, const Source& source, const QString& what)
{
    const Gates gates = this->gates();
    const auto mayRun = [&] {
        return gates.mayMove(source).and_then([&] { return gates.axesPlaced(); }).and_then([&] {
            return gates.mayLeaveSunBand({}, {});
        });
    };
    const Result<> may = activity == Activity::Jogging ? gates.mayJog(rates, source) : mayRun();
    return may.and_then([&] { return mayMoveFirst(rates); }).map([&] {
        begin(activity, source, what);
        m_motion.run(rates);
    });
}

Result<> StationControl::handle(const request::Jog& wanted, const Source& source)
{
    if (isZero(wanted.rates)) {
        if (m_current.is(Activity::Jogging) && m_current.isFor(source)) {
            holdHere(Activity::Holding);
        }
        return {};
    }
    return runAt(wanted.rates, Activity::Jogging, source, Text::tr("jog")).map([&] {
        m_current.keepAliveUntil(m_now + kJogKeepAlive);
    });
}

Result<> StationControl::handle(const request::Move& wanted, const Source& source)
{
    return runAt(wanted.rates, Activity::Running, source, Text::tr("move"));
}

Result<> StationControl::handle(const request::Hold&, const Source& source)
{
    takeOver(source);  // else the next target of a client would undo it
    if (moves()) {
        tell(Severity::Advisory, source, Text::tr("ends the motion: hold"));
        holdHere(Activity::Holding);
    }
    return {};
}

Result<> StationControl::handle(const request::Stop&, const Source& source)
{
    if (!m_arming.stopLatched()) {
        m_log.add(Severity::Warning, source.name, Text::tr("STOP: both axes decelerate and hold; latched"));
    }
    m_arming.latchStop();
    keepStopped();
    holdHere(Activity::None);
    return {};
}

Result<> StationControl::handle(const request::ResetStop&, const Source& source)
{
    if (m_drives.anyUnderOrders() && !m_motion.atRest()) {
        return failure(ErrorCode::Refused, Text::tr("the mount is still braking: reset STOP when it stands"));
    }
    return m_arming.resetStop().map([&] {
        m_log.add(Severity::Advisory, source.name, Text::tr("resets STOP: nothing moves until the next command"));
    });
}

// A client re-arms only with the authority to move, and only for itself: the others that kept sending wait.
Result<> StationControl::handle(const request::Rearm&, const Source& source)
{
    if (source.kind != SourceKind::Client) {
        return m_arming.rearm(source);
    }
    return m_lead.mayAct(m_profile.rotctld, source, m_now).and_then([&]() -> Result<> {
        if (!faultLatched() && m_lead.waits(source.clientId)) {
            m_lead.acted(source);
            return {};
        }
        return m_arming.rearm(source).map([&] { m_lead.rearmed(source, m_now); });
    });
}

Result<AxisPosition> StationControl::measured() const
{
    for (const Axis axis : kAxes) {
        const auto& place = m_drives.drive(axis).place();
        if (!place || m_clock.now() - place->received > kOldestPosition) {
            return failure(ErrorCode::NoAnswer,
                           Text::tr("no fresh position from the %1").arg(m_drives.drive(axis).label()));
        }
    }
    if (!turnsKnown()) {
        return failure(ErrorCode::NoAnswer, Text::tr("it is not known on which turn an axis stands"));
    }
    return *m_drives.measured();
}

std::optional<SkyPointing> StationControl::direction() const
{
    const auto place = measured();
    return place ? std::optional(m_model.toSky(*place)) : std::nullopt;
}

void StationControl::setSensor(const std::optional<Angle>& azimuth, const std::optional<Angle>& elevation,
                               const std::optional<memory::SensorCourse>& course)
{
    m_turns.setCourse(course);
    const SkyPointing beam{.azimuth = azimuth.value_or(Angle{}), .elevation = elevation.value_or(Angle{})};
    const AxisPosition axes = m_model.pointing().toAxes(beam).axes;
    m_turns.setSensor(Axis::Azimuth, azimuth ? std::optional(axes.azimuth) : std::nullopt);
    m_turns.setSensor(Axis::Elevation, elevation ? std::optional(axes.elevation) : std::nullopt);
}

std::optional<AxisPosition> StationControl::trimInUse() const
{
    return m_current.is(Activity::Streaming) && followsClient() ? std::optional(m_motion.trim()) : std::nullopt;
}

void StationControl::driveRestarted(Axis axis)
{
    m_log.add(Severity::Warning, QString::fromStdString(m_drives.drive(axis).name()),
              Text::tr("was power-cycled: its turn must be judged anew"));
    m_turnWatch.forget(axis);
    holdHere(Activity::None);
}

// The direction that the beam has there; on the turn of the axes.
QString StationControl::directionText(const AxisPosition& place) const
{
    return text(m_model.pointing().toSky(place));
}

// What is permitted, and what a place of the axes looks at: neither moves anything.
void StationControl::enforceRegion()
{
    // A client's target that nobody moves any more is a place as well, unless the nearest permitted one is held for it.
    const bool standing = m_current.is(Activity::Streaming) && !m_motion.streaming(m_now) && !m_motion.limited();
    m_model.setPointing(pointing::PointingModel(m_profile.pointing));
    m_motion.setRegion(pointing::withSun(m_profile.limits, m_sun.keepOuts()), m_model.pointing());
    const pointing::AxisBox& ranges = m_motion.region().ranges();
    m_model.limitTo(ranges.azimuth, ranges.elevation);
    const auto target = m_motion.target(m_now);
    const bool going = m_current.goesToAPlace() || standing;
    if (const std::string why = going && target ? m_motion.region().reason(*target) : ""; !why.empty()) {
        m_log.add(Severity::Warning, QStringLiteral("station"), Text::tr("ends the motion: %1").arg(toQString(why)));
        holdHere(Activity::Holding);  // else a mount that stands would set off by itself
    }
}

void StationControl::setSilenceAdvice(const QString& advice)
{
    for (DriveWatch& watch : m_watches) {
        watch.setSilenceAdvice(advice);
    }
}

}  // namespace boresight
