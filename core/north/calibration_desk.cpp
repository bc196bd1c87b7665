// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/north/calibration_desk.h"

#include "core/base/text.h"
#include "core/profile/setting.h"
#include "core/units/angle_between.h"
#include "core/witness/sensor_curve.h"

#include <algorithm>

namespace boresight {
namespace {

const QString kDeskSource = QStringLiteral("calibration");
constexpr std::chrono::milliseconds kPublishPeriod{250};
// A body that is centred by hand, by shadow or sight tube.
constexpr Angle kCentred = Angle::fromDegrees(0.03);
// Where north was found, nothing that is centred is this far from where the model says; nor from three sigmas of it.
constexpr Angle kFarPoint = Angle::fromDegrees(5.0);
// A landmark from a map, and a hand that points the beam at it.
constexpr Angle kKnownPoint = Angle::fromDegrees(0.1);

}  // namespace

CalibrationDesk::CalibrationDesk(StationControl& control, const profile::Profile& profile, CalibrationFile& file,
                                 const Clock& clock, EventLog& log)
    : m_control(control),
      m_profile(profile),
      m_wanted(profile),
      m_clock(clock),
      m_log(log),
      m_file(file),
      m_sensor(m_profile, clock),
      m_axes(control, clock),
      m_mount(control, m_profile),
      m_model(file, m_profile, m_mount, clock),
      m_points(control, file, m_mount, m_model, clock, log),
      m_proposals(m_profile, m_sensor, m_model, m_points, log),
      m_follower(control, profile, clock, log),
      m_runs(control, m_profile, m_sensor, m_axes, m_follower, clock, log),
      m_alarms(control, m_profile, file, m_model, m_axes, m_follower)
{}

Result<> CalibrationDesk::carryOut(const CalibrationRequest& request)
{
    m_changed = true;
    noteDrives();
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
    m_changed = m_runs.tick() || m_changed;
    useWhatEnded();
    if (m_changed || m_clock.now() - m_published >= kPublishPeriod) {
        publish();
    }
}

// The outcome also says what Apply will leave. A peak becomes a point.
void CalibrationDesk::useWhatEnded()
{
    const std::optional<RunEnd> end = m_runs.takeEnd();
    if (!end) {
        return;
    }
    m_changed = true;
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
        addPoint(*point);
    }
}

void CalibrationDesk::setProfile(const profile::Profile& profile)
{
    const bool otherTerms = profile.pointing != m_profile.pointing;
    const bool otherSensor = !readAlike(profile.sensor, m_profile.sensor);
    const bool other = otherTerms || otherSensor;
    if ((otherTerms || (other && m_runs.running() != CalibrationRun::CrossScan)) && m_runs.runs()) {
        m_runs.breakOff(Text::tr("the terms or the sensor in the profile were changed"));
    }
    m_profile = profile;
    m_wanted = profile;
    m_follower.setProfile(profile);
    m_changed = true;
    if (other) {
        m_points.fit();
        m_proposals.profileChanged(otherSensor);
    }
}

Result<> CalibrationDesk::handle(const request::FollowBody& wanted)
{
    return m_runs.isIdle().and_then(
        [&] { return m_follower.follow(wanted.body, wanted.refraction, wanted.overTheTop); });
}

Result<> CalibrationDesk::mayTakePoint() const
{
    return m_runs.isIdle().and_then([this] { return m_axes.standStill(); }).and_then([this] {
        return m_points.hasRoom();
    });
}

Result<> CalibrationDesk::mayTakeBody()
{
    if (!m_follower.body()) {
        return failure(ErrorCode::Refused, Text::tr("follow the Sun or the Moon first, and centre it"));
    }
    return m_follower.direction(*m_follower.body()).and_then([&](const SkyPointing& place) -> Result<> {
        if (place.elevation < Angle{}) {
            return failure(ErrorCode::Refused,
                           Text::tr("the %1 is below the horizon").arg(bodyName(*m_follower.body())));
        }
        return mayTakePoint();
    });
}

// Where the axes are now, not where they were told to be, and where the body is now.
Result<> CalibrationDesk::handle(const request::TakePoint&)
{
    return mayTakeBody().map([&] {
        const ephemeris::Body body = *m_follower.body();
        const SkyPointing truth = *m_follower.direction(body);
        addPoint({.axes = m_axes.now()->place, .truth = truth, .sigma = kCentred, .label = bodyName(body)});
        warnOfFarPoint(truth);
    });
}

// The operator sees the shadow, the model does not: it is taken all the same.
void CalibrationDesk::warnOfFarPoint(const SkyPointing& truth)
{
    const std::optional<Angle> north = m_model.sheet().sigmas[calibration::indexOf(calibration::Term::AzimuthOffset)];
    const auto beam = m_control.direction();
    if (!north || !beam) {
        return;
    }
    if (const Angle distance = angleBetween(*beam, truth); distance > std::max(kFarPoint, 3.0 * *north)) {
        m_log.add(Severity::Warning, kDeskSource,
                  Text::tr("by the model in force the beam is %1° beside it: if it was not centred, drop point %2")
                      .arg(distance.degrees(), 0, 'f', 1)
                      .arg(m_points.book().points().size()));
    }
}

Result<> CalibrationDesk::handle(const request::TakeKnownPoint& wanted)
{
    if (!wanted.truth.azimuth.isFinite() || abs(wanted.truth.azimuth) > 360_deg ||
        !(abs(wanted.truth.elevation) <= 90_deg)) {
        return failure(ErrorCode::OutOfRange,
                       Text::tr("an azimuth within 360° and an elevation within 90° are expected"));
    }
    return mayTakePoint().map([&] {
        const QString label = wanted.label.trimmed();
        addPoint({.axes = m_axes.now()->place,
                  .truth = {wanted.truth.azimuth.wrapped360(), wanted.truth.elevation},
                  .sigma = kKnownPoint,
                  .label = label.isEmpty() ? Text::tr("landmark") : label});
    });
}

void CalibrationDesk::addPoint(const NewPoint& point)
{
    m_points.add(point);
    m_proposals.pointsChanged();
}

Result<> CalibrationDesk::handle(const request::DropPoint& wanted)
{
    return m_points.drop(wanted.index).map([this] { m_proposals.pointsChanged(); });
}

Result<> CalibrationDesk::handle(const request::UsePoint& wanted)
{
    return m_points.use(wanted.index, wanted.used).map([this] { m_proposals.pointsChanged(); });
}

Result<> CalibrationDesk::handle(const request::DropAllPoints&)
{
    m_points.clear();
    m_proposals.pointsChanged();
    return {};
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
        .and_then([&] { return m_runs.isIdle(); })
        .and_then([&] { return m_points.hasRoom(); })
        .and_then([&] { return m_runs.startScan(wanted.body, wanted.width); });
}

Result<> CalibrationDesk::handle(const request::GivePower& wanted)
{
    return m_runs.givePower(wanted.decibels);
}

Result<> CalibrationDesk::handle(const request::EndCalibration&)
{
    if (m_runs.runs()) {
        m_runs.breakOff(Text::tr("ended by the operator"));
    }
    m_follower.end();
    return {};
}

// A model that comes into force moves nothing that stands, but a stream of directions would be led elsewhere.
Result<> CalibrationDesk::mayChange() const
{
    return m_runs.isIdle().and_then([&]() -> Result<> {
        if (m_wanted.bus != m_profile.bus) {
            return failure(ErrorCode::Refused,
                           Text::tr("the mount at %1 waits for Reconnect, and this was found of the one at %2: "
                                    "reconnect first")
                               .arg(toQString(m_wanted.bus), toQString(m_profile.bus)));
        }
        if (m_control.followsClient()) {
            return failure(ErrorCode::Refused, Text::tr("the mount follows a client, which the change would move: hold "
                                                        "the mount first"));
        }
        return m_follower.following() ? Result<>{} : m_control.mayChangePointing();  // the body is let go
    });
}

// A horizon or keep-out that now lies elsewhere over the axes may forbid the place to park: such a profile would not
// even be loaded again.
Result<> CalibrationDesk::makesSense(const CalibrationChange& change) const
{
    for (profile::Profile wanted : {m_profile, m_wanted}) {
        change.applyTo(wanted);
        const auto problems = profile::problemsOf(wanted);
        if (!problems.empty() && problems.front().key.starts_with("park.")) {
            return failure(ErrorCode::Refused,
                           Text::tr("the place to park would then be forbidden, %1: set another one "
                                    "first (tab Mount, Profile, \"park\"), then apply")
                               .arg(toQString(problems.front().text)));
        }
        if (!problems.empty()) {
            return failure(ErrorCode::Refused,
                           Text::tr("with this the profile would not make sense, %1: change that first")
                               .arg(toQString(problems.front().key + ": " + problems.front().text)));
        }
    }
    return {};
}

Result<> CalibrationDesk::handle(const request::ApplyCalibration& wanted)
{
    m_proposals.dropStale();
    if (const Result<> same = m_proposals.isCurrent(wanted.proposal); !same) {
        return same;
    }
    const Proposal proposal = *m_proposals.current();
    const CalibrationChange change{.terms = proposal.terms, .sensor = proposal.sensor};
    return mayChange().and_then([&] { return makesSense(change); }).map([&] {
        calibration::CalibrationRecord record{.when = std::chrono::floor<std::chrono::milliseconds>(m_clock.utc()),
                                              .title = proposal.title.toStdString(),
                                              .mount = m_mount.today(),
                                              .terms = {.before = m_profile.pointing, .after = proposal.terms},
                                              .sigmas = proposal.sigmas,
                                              .points = proposal.points};
        if (proposal.sensor) {
            record.sensor = {.before = mountingOf(m_profile.sensor), .after = *proposal.sensor};
        }
        m_file.add(std::move(record));
        bringIntoForce(
            change,
            Text::tr("applies \"%1\": %2")
                .arg(proposal.title, changeText(m_profile.pointing, proposal.terms, proposal.sensor.has_value())),
            Proposals::Next::Nothing);
    });
}

Result<> CalibrationDesk::handle(const request::DiscardCalibration& wanted)
{
    return m_proposals.discard(wanted.proposal);
}

Result<> CalibrationDesk::handle(const request::UndoCalibration&)
{
    const calibration::CalibrationHistory& history = m_file.history();
    if (!history.canUndo()) {
        return failure(ErrorCode::Refused, Text::tr("there is no calibration to take back"));
    }
    const calibration::CalibrationRecord& record = history.entries()[history.inForce() - 1];
    CalibrationChange change{.terms = record.terms.before};
    std::optional<calibration::SensorMounting> now;
    if (record.sensor) {
        change.sensor = record.sensor->before;
        now = record.sensor->after;
    }
    const auto may = mayChange().and_then([&] { return stillInForce(record.terms.after, now); });
    return may.and_then([&] { return makesSense(change); }).map([&] {
        warnOfOtherMount(record);
        bringIntoForce(change, Text::tr("takes back \"%1\"").arg(toQString(m_file.undo().title)),
                       Proposals::Next::Points);
    });
}

Result<> CalibrationDesk::handle(const request::RedoCalibration&)
{
    const calibration::CalibrationHistory& history = m_file.history();
    if (!history.canRedo()) {
        return failure(ErrorCode::Refused, Text::tr("there is no calibration to bring back"));
    }
    const calibration::CalibrationRecord& record = history.entries()[history.inForce()];
    CalibrationChange change{.terms = record.terms.after};
    std::optional<calibration::SensorMounting> now;
    if (record.sensor) {
        change.sensor = record.sensor->after;
        now = record.sensor->before;
    }
    const auto may = mayChange().and_then([&] { return stillInForce(record.terms.before, now); });
    return may.and_then([&] { return makesSense(change); }).map([&] {
        warnOfOtherMount(record);
        bringIntoForce(change, Text::tr("applies \"%1\" again").arg(toQString(m_file.redo().title)),
                       Proposals::Next::Points);
    });
}

// Where `next` are the points, they are proposed as soon as the change is in force.
void CalibrationDesk::bringIntoForce(const CalibrationChange& change, const QString& what, Proposals::Next next)
{
    m_follower.end();  // the body would be followed elsewhere from now on
    m_proposals.clear(next);
    m_change = change;
    m_log.add(Severity::Advisory, QStringLiteral("operator"), what);
}

}  // namespace boresight
