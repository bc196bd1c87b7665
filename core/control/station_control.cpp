// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/control/station_control.h"

#include "core/base/text.h"
#include "core/profile/setting.h"

namespace boresight {
namespace {

constexpr std::chrono::seconds kOldestPosition{1};

Result<> makesSense(const profile::Profile& profile)
{
    const auto problems = profile::problemsOf(profile);
    if (!problems.empty()) {
        return failure(ErrorCode::InvalidInput, problems.front().key + ": " + problems.front().text);
    }
    return {};
}

}  // namespace

StationControl::StationControl(const profile::Profile& profile, const Clock& clock, EventLog& log,
                               const MakeSources& sources, TurnKeeper::Start start)
    : m_profile(profile),
      m_clock(clock),
      m_log(log),
      m_model(profile.azimuth.geometry, profile.elevation.geometry, pointing::PointingModel(profile.pointing)),
      m_drives(profile),
      m_motion(profile),
      m_arming(profile, m_drives, log),
      m_alarms(log, clock),
      m_watches{DriveWatch(Axis::Azimuth, profile, m_alarms), DriveWatch(Axis::Elevation, profile, m_alarms)},
      m_turns(profile, clock, log, std::move(start)),
      m_turnWatch(m_turns, m_drives, m_watches, m_alarms),
      m_stall(m_drives, m_watches, m_turns, m_alarms, log),
      m_proof(m_drives, m_motion, m_turns, m_turnWatch, log),
      m_cable(m_alarms, clock),
      m_sourceLog(log, clock),
      m_helm({.motion = m_motion,
              .drives = m_drives,
              .current = m_current,
              .arming = m_arming,
              .lead = m_lead,
              .cable = m_cable,
              .proof = m_proof,
              .firstMoves = m_firstMoves,
              .log = m_sourceLog},
             [this] { return parts(); }),
      m_region({.profile = m_profile,
                .clock = clock,
                .model = m_model,
                .motion = m_motion,
                .helm = m_helm,
                .alarms = m_alarms,
                .log = log}),
      m_clientDesk(m_helm, m_arming, m_lead, log),
      m_targetAlarm(m_alarms),
      m_adviceAlarms(m_alarms),
      m_started(clock.now()),
      m_now(m_started),
      m_sources(sources(m_helm))
{
    m_region.begin();
    m_adviceAlarms.update(profile);
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
            .sun = m_region.sun(),
            .alarms = m_alarms,
            .now = m_now,
            .tick = m_tick};
}

Result<> StationControl::request(const Request& request, const Source& source)
{
    const auto ownOrSource = [&](const auto& wanted) -> Result<> {
        if constexpr (requires { handle(wanted, source); }) {
            return handle(wanted, source);
        } else if constexpr (requires { m_clientDesk.ask(wanted, source); }) {
            return m_clientDesk.ask(wanted, source);
        } else {
            return askSources(request, source);
        }
    };
    return std::visit(ownOrSource, request);
}

Result<> StationControl::askSources(const Request& request, const Source& source)
{
    if (source.kind == SourceKind::Client) {
        clientAsked(source);
    }
    for (const auto& one : m_sources) {
        if (auto answer = one->take(request, source)) {
            return *std::move(answer);
        }
    }
    return failure(ErrorCode::NotAvailable, "no source of motion takes this request");
}

void StationControl::stepSources()
{
    for (const auto& one : m_sources) {
        one->step(m_now);
    }
}

void StationControl::sourceGone(const Source& source)
{
    m_lead.gone(source);
    for (const auto& one : m_sources) {
        one->gone(source);
    }
}

void StationControl::positionRead(std::uint64_t clientId)
{
    for (const auto& one : m_sources) {
        one->positionRead(clientId);
    }
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

Result<> StationControl::handle(const request::ClearTrim&, const Source& source)
{
    return operatorOnly(source).map([&] {
        if (m_motion.trim() != AxisPosition{}) {
            m_helm.setTrim({}, source);
        }
    });
}

Result<> StationControl::handle(const request::AcknowledgeAlarms&, const Source&)
{
    m_alarms.acknowledgeAll();
    return {};
}

Result<> StationControl::handle(const request::AcknowledgeAlarm& wanted, const Source&)
{
    m_alarms.acknowledge(wanted.alarmId);
    return {};
}

// The station puts it into force; see setProfile().
Result<> StationControl::handle(const request::ApplyProfile& wanted, const Source& source)
{
    return operatorOnly(source).and_then([&] { return makesSense(wanted.profile); }).and_then([&] {
        return wanted.profile.pointing == m_profile.pointing ? Result<>{} : mayChangePointing();
    });
}

Result<> StationControl::handle(const request::Reconnect& wanted, const Source& source)
{
    return operatorOnly(source).and_then([this] { return gates().drivesRest(); }).and_then([&] {
        return makesSense(wanted.profile);
    });
}

// The calibration desk carries it out, and asks for the motions that it needs like everybody else.
Result<> StationControl::handle(const CalibrationRequest&, const Source& source)
{
    return operatorOnly(source);
}

void StationControl::setProfile(const profile::Profile& profile)
{
    const bool redrawn = profile.limits != m_profile.limits || profile.pointing != m_profile.pointing;
    if (profile.mount.directions != m_profile.mount.directions) {
        m_firstMoves.beginAnew();  // the small way begins where the mount stands now
    }
    m_profile = profile;
    m_region.profileChanged(redrawn);
    for (const Axis axis : kAxes) {
        m_motion.setLimits(axis, profile.axis(axis).limits);
    }
    m_drives.setProfile(profile);
    m_arming.setProfile(profile);
    for (DriveWatch& watch : m_watches) {
        watch.setProfile(profile);
    }
    m_adviceAlarms.update(profile);
}

void StationControl::watchFirstMoves()
{
    if (m_firstMoves.exceeded(parts())) {
        m_helm.end(Severity::Advisory,
                   Text::tr("jog ends: no farther than 2° until the directions of the axes are confirmed"));
    }
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

void StationControl::setSilenceAdvice(const QString& advice)
{
    for (DriveWatch& watch : m_watches) {
        watch.setSilenceAdvice(advice);
    }
}

}  // namespace boresight
