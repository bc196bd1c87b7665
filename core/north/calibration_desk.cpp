// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/north/calibration_desk.h"

#include "core/base/text.h"
#include "core/cross_check/sensor_curve.h"
#include "core/north/calibration_gates.h"

namespace boresight {

CalibrationDesk::CalibrationDesk(StationControl& control, const profile::InForce& profile, CalibrationFile& file,
                                 const Clock& clock, EventLog& log)
    : m_profile(profile),
      m_sensor(profile, clock),
      m_axes(control, clock),
      m_mount(control, profile),
      m_model(file, profile, m_mount, clock),
      m_points(control, file, m_mount, m_model, clock, log),
      m_proposals(profile, m_sensor, m_model, m_points, log),
      m_follower(control, profile, clock, log),
      m_runs(control, profile, m_sensor, m_axes, m_follower, clock, log),
      m_taker(control, m_runs, m_axes, m_model, m_follower, m_points, log),
      m_changes(control, profile, file, m_mount, m_runs, m_follower, clock, log),
      m_alarms(control, profile, file, m_model, m_axes, m_follower),
      m_report({.profile = profile,
                .file = file,
                .sensor = m_sensor,
                .mount = m_mount,
                .model = m_model,
                .points = m_points,
                .proposals = m_proposals,
                .runs = m_runs,
                .taker = m_taker,
                .changes = m_changes,
                .alarms = m_alarms,
                .follower = m_follower},
               clock)
{}

Result<> CalibrationDesk::carryOut(const CalibrationRequest& request)
{
    m_report.expire();
    noteDrives();
    if (const QString why = whyNoCalibration(*m_profile); !why.isEmpty()) {
        return failure(ErrorCode::NotAvailable, why);
    }
    const Result<> done = std::visit([this](const auto& wanted) { return handle(wanted); }, request);
    useWhatEnded();
    return done;
}

void CalibrationDesk::take(const SensorStatus& sensor)
{
    if (const orientation::Orientation* const value = m_sensor.take(sensor)) {
        m_runs.take(*value);
    }
}

void CalibrationDesk::tick()
{
    noteDrives();
    m_axes.tick();
    m_follower.tick();
    if (m_runs.tick()) {
        m_report.expire();
    }
    useWhatEnded();
    if (m_report.isDue()) {
        m_alarms.update();
        m_proposals.dropStale();
        watchPoints();
        m_report.renew();
    }
}

void CalibrationDesk::clockWasSet()
{
    m_follower.clockWasSet();
    m_points.clockWasSet();
    m_report.expire();
}

// The outcome also names the terms that Apply will leave unchanged. A peak becomes a point.
void CalibrationDesk::useWhatEnded()
{
    const std::optional<RunEnd> end = m_runs.takeEnd();
    if (!end) {
        return;
    }
    m_report.expire();
    QString stays;
    if (const auto* const offset = std::get_if<calibration::SensorOffset>(&end->found)) {
        m_proposals.propose(*offset);
        stays = m_proposals.stays();
    } else if (const auto* const swung = std::get_if<SwungCompass>(&end->found)) {
        m_proposals.propose(*swung);
        stays = end->failed ? QString() : m_proposals.stays();
    }
    m_runs.close(stays.isEmpty() ? end->outcome : QStringLiteral("%1; %2").arg(end->outcome, stays), end->failed);
    if (const auto* const point = std::get_if<NewPoint>(&end->found)) {
        m_points.add(*point);
        m_proposals.pointsChanged();
    }
}

void CalibrationDesk::fill(StationStatus& status) const
{
    status.calibration = m_report.status();
    for (const BodyNow& one : status.calibration->bodies) {
        status.bodies.push_back({.body = one.body, .direction = one.direction});
    }
    const bool inMotion = status.state == StationState::Hold || status.state == StationState::Slew ||
                          status.state == StationState::Jog || status.state == StationState::Track;
    if (moves() && inMotion) {
        status.state = StationState::Calibrate;
        if (m_runs.swing().run()) {
            status.targetText = Text::tr("compass swing");
        }
    }
}

void CalibrationDesk::profileChanged(const profile::Profile& before, const profile::Profile& after)
{
    const bool otherTerms = before.pointing != after.pointing;
    const bool otherSensor = !readAlike(after.sensor, before.sensor);
    const bool other = otherTerms || otherSensor;
    if ((otherTerms || (other && m_runs.running() != CalibrationRun::CrossScan)) && m_runs.runs()) {
        m_runs.breakOff(Text::tr("The terms or the sensor in the profile were changed."));
    }
    m_follower.profileChanged(before, after);
    m_report.expire();
    if (other) {
        m_points.fit();
        m_proposals.profileChanged(otherSensor);
    }
}

// Points that waited for the identity of both drives may count from this tick on.
void CalibrationDesk::noteDrives()
{
    if (m_mount.update()) {
        m_report.expire();
        if (m_points.leaveOutOthers()) {
            m_proposals.pointsChanged();
        }
        if (m_points.countRestored()) {
            m_proposals.pointsRestored();
        }
    }
}

void CalibrationDesk::watchPoints()
{
    if (m_points.leaveOutOthers()) {
        m_proposals.pointsChanged();
    }
    if (m_points.noteTurns()) {
        m_proposals.renewPoints();
    }
}

Result<> CalibrationDesk::handle(const request::FollowBody& wanted)
{
    return m_runs.isIdle().and_then(
        [&] { return m_follower.follow(wanted.body, wanted.refraction, wanted.overTheTop); });
}

Result<> CalibrationDesk::handle(const request::TakePoint&)
{
    return m_taker.takeBody().map([this] { m_proposals.pointsChanged(); });
}

Result<> CalibrationDesk::handle(const request::TakeKnownPoint& wanted)
{
    return m_taker.takeKnown(wanted.truth, wanted.label).map([this] { m_proposals.pointsChanged(); });
}

Result<> CalibrationDesk::mayChangePoints() const
{
    return m_points.book().points().empty() ? failure(ErrorCode::Refused, Text::tr("There are no points."))
                                            : m_runs.isIdle();
}

Result<> CalibrationDesk::handle(const request::DropPoint& wanted)
{
    return mayChangePoints().and_then([&] { return m_points.drop(wanted.index); }).map([this] {
        m_proposals.pointsChanged();
    });
}

Result<> CalibrationDesk::handle(const request::UsePoint& wanted)
{
    return mayChangePoints().and_then([&] { return m_points.use(wanted.index, wanted.used); }).map([this] {
        m_proposals.pointsChanged();
    });
}

Result<> CalibrationDesk::handle(const request::DropAllPoints&)
{
    return mayChangePoints().map([this] {
        m_points.clear();
        m_proposals.pointsChanged();
    });
}

Result<> CalibrationDesk::handle(const request::MeasureSensorOffset&)
{
    return m_runs.startOffset();
}

Result<> CalibrationDesk::handle(const request::PlanSwing& wanted)
{
    m_runs.planSwing({.rate = wanted.rate, .headings = wanted.headings});
    return {};
}

Result<> CalibrationDesk::handle(const request::StartSwing& wanted)
{
    return m_runs.startSwing({.rate = wanted.rate, .headings = wanted.headings});
}

Result<> CalibrationDesk::handle(const request::StartCrossScan& wanted)
{
    return ScanPilot::isWidth(wanted.width)
        .and_then([&] { return m_runs.mayScan(wanted.body); })
        .and_then([&] { return m_points.hasRoom(); })
        .and_then([&] { return m_runs.startScan(wanted.body, wanted.width); });
}

Result<> CalibrationDesk::handle(const request::GivePower& wanted)
{
    return m_runs.givePower(wanted.decibels);
}

Result<> CalibrationDesk::handle(const request::ProposeTerms& wanted)
{
    return m_runs.isIdle().and_then([&] {
        return m_proposals.propose(
            {.title = Text::tr("Typed terms"), .reason = Text::tr("typed"), .terms = wanted.terms});
    });
}

Result<> CalibrationDesk::handle(const request::ImportTerms& wanted)
{
    const auto read = calibration::parseTerms(wanted.text, wanted.name);
    if (!read) {
        return tl::unexpected(read.error());
    }
    return m_runs.isIdle().and_then([&] {
        return m_proposals.propose({.title = Text::tr("Terms from %1").arg(wanted.name),
                                    .reason = Text::tr("from a file"),
                                    .terms = read->terms,
                                    .sigmas = read->sigmas,
                                    .warnings = otherMountWarnings(*read, m_model.sheet())});
    });
}

Result<> CalibrationDesk::handle(const request::EndCalibration&)
{
    if (m_runs.runs()) {
        m_runs.breakOff(Text::tr("ended by the operator"));
    }
    m_follower.end();
    return {};
}

Result<> CalibrationDesk::handle(const request::ApplyCalibration& wanted)
{
    m_proposals.dropStale();
    return m_proposals.mayApply(wanted).and_then([&] { return m_changes.apply(*m_proposals.current()); }).map([&] {
        m_proposals.clear(Proposals::Next::Nothing);
    });
}

Result<> CalibrationDesk::handle(const request::DiscardCalibration& wanted)
{
    return m_proposals.discard(wanted.proposal);
}

Result<> CalibrationDesk::handle(const request::UndoCalibration&)
{
    return m_changes.undo().map([&] { m_proposals.clear(Proposals::Next::Points); });
}

Result<> CalibrationDesk::handle(const request::RedoCalibration&)
{
    return m_changes.redo().map([&] { m_proposals.clear(Proposals::Next::Points); });
}

}  // namespace boresight
