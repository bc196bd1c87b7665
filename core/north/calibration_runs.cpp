// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/north/calibration_runs.h"

#include "core/base/text.h"
#include "core/control/calibration_source.h"
#include "core/cross_check/sensor_curve.h"

#include <algorithm>

namespace boresight {
namespace {

const QString kRunsSource = QStringLiteral("calibration");

// The sensor reads the elevation at the end of the time over which it averages the heading, and then sends both.
Seconds levelAge(const profile::SensorSettings& sensor)
{
    return std::max(sensor.latency - sensor.averaging / 2.0, Seconds(0.0));
}

SteadyTime before(SteadyTime time, Seconds age)
{
    return time - std::chrono::duration_cast<SteadyTime::duration>(age);
}

}  // namespace

CalibrationRuns::CalibrationRuns(StationControl& control, const profile::InForce& profile, const LiveSensor& sensor,
                                 const AxisObserver& axes, BodyFollower& follower, const Clock& clock, EventLog& log)
    : m_control(control),
      m_profile(profile),
      m_sensor(sensor),
      m_axes(axes),
      m_follower(follower),
      m_clock(clock),
      m_log(log),
      m_swing(control, profile, sensor, axes, clock, log),
      m_scan(control, follower, axes, clock)
{}

CalibrationRun CalibrationRuns::running() const
{
    return m_swing.run()  ? CalibrationRun::Swing
           : m_scan.run() ? CalibrationRun::CrossScan
           : m_offset     ? CalibrationRun::SensorOffset
                          : CalibrationRun::None;
}

Result<> CalibrationRuns::isIdle() const
{
    if (runs()) {
        return failure(ErrorCode::Busy, Text::tr("A calibration is running. End it first."));
    }
    return {};
}

// While a body is tracked the mount turns, and its motors would disturb the compass.
Result<> CalibrationRuns::followsNothing() const
{
    if (m_follower.following()) {
        return failure(ErrorCode::Refused,
                       Text::tr("The mount tracks the %1. Press Hold first.").arg(bodyName(*m_follower.body())));
    }
    return {};
}

Result<> CalibrationRuns::mayAverage() const
{
    return isIdle()
        .and_then([this] { return m_sensor.isTiedToNorth(); })
        .and_then([this] { return m_axes.standStill(); })
        .and_then([this] { return followsNothing(); })
        .and_then([this]() -> Result<> {
            const QString obstacle = compassObstacle(m_control.measured()->elevation);
            return obstacle.isEmpty() ? Result<>{} : failure(ErrorCode::Refused, obstacle);
        });
}

Result<> CalibrationRuns::startOffset()
{
    return mayAverage().map([this] { m_offset.emplace(m_clock.now()); });
}

Result<> CalibrationRuns::maySwing() const
{
    return isIdle().and_then([this] { return m_swing.mayStart(); });
}

Result<> CalibrationRuns::startSwing(const SwingWish& wish)
{
    m_swing.plan(wish);
    return maySwing().and_then([&]() -> Result<> {
        const SwingPlan plan = m_swing.planned();
        if (!plan.obstacle.isEmpty()) {
            return failure(ErrorCode::Refused, plan.obstacle);
        }
        m_follower.end();
        m_swing.start(plan);
        ended(m_swing.tick());
        return {};
    });
}

Result<> CalibrationRuns::mayScan(ephemeris::Body body) const
{
    return isIdle()
        .and_then([&] { return m_follower.mayFollow(body, m_follower.overTheTop()); })
        .and_then([&]() -> Result<> {
            return m_follower.following() && m_follower.body() == body
                       ? Result<>{}
                       : failure(ErrorCode::Refused, Text::tr("Track the %1 first.").arg(bodyName(body)));
        });
}

Result<> CalibrationRuns::startScan(ephemeris::Body body, Angle width)
{
    return endedBy(m_scan.start(body, width));
}

Result<> CalibrationRuns::givePower(double decibels)
{
    return ScanPilot::isPower(decibels).and_then([&]() -> Result<> {
        return wantsPower() ? endedBy(m_scan.give(decibels))
                            : failure(ErrorCode::Refused, Text::tr("No scan waits for a power value."));
    });
}

// A scan that cannot look at its next place is over.
Result<> CalibrationRuns::endedBy(const Result<>& scan)
{
    if (!scan && m_scan.run()) {
        ended(failedRun(scan.error().text));
    }
    return scan;
}

// A value of the sensor is an average and some time old. It is compared with the position of the axes at its own time.
void CalibrationRuns::take(const orientation::Orientation& value)
{
    const profile::SensorSettings& settings = m_profile->sensor;
    const auto about = m_axes.trace().about(before(value.arrival, settings.latency), settings.averaging);
    const auto level = m_axes.trace().about(before(value.arrival, levelAge(settings)), Seconds(0.0));
    if (!about || !level) {
        return;
    }
    if (m_swing.run()) {
        m_swing.take({.value = value, .about = *about, .level = *level});
    } else if (m_offset) {
        m_offset->take(value, *about, *m_profile, m_sensor.declination());
    }
}

bool CalibrationRuns::tick()
{
    if (m_swing.run()) {
        ended(m_swing.tick());
    } else if (m_scan.run()) {
        const ScanPilot::Step step = m_scan.tick();
        ended(step.end);
        return step.read;
    } else if (m_offset) {
        ended(stepOffset());
    }
    return false;
}

std::optional<RunEnd> CalibrationRuns::stepOffset() const
{
    if (const auto usable = m_sensor.isUsable(); !usable) {
        return failedRun(usable.error().text);
    }
    if (!m_offset->done(m_clock.now())) {
        return std::nullopt;
    }
    const auto offset = m_offset->outcome(m_profile->sensor, m_sensor.declination());
    if (!offset) {
        return failedRun(offset.error().text);
    }
    return RunEnd{.outcome = Text::tr("done, from %1 readings").arg(offset->used), .found = *offset};
}

void CalibrationRuns::ended(std::optional<RunEnd> end)
{
    if (!end) {
        return;
    }
    if (end->holds) {
        hold();
    }
    m_end = std::move(end);
}

void CalibrationRuns::hold()
{
    if (moves() && m_control.obeys(calibrationSource())) {
        [[maybe_unused]] const Result<> held = m_control.request(request::Hold{}, calibrationSource());
    }
}

void CalibrationRuns::close(const QString& outcome, bool failed)
{
    if (m_follower.looksBeside()) {
        m_follower.end();
    }
    m_scan.end();
    m_swing.end();
    m_offset.reset();
    m_outcome = outcome;
    m_failed = failed;
    m_log.add(failed ? Severity::Warning : Severity::Advisory, kRunsSource,
              failed ? Text::tr("ends without a result: %1").arg(outcome) : outcome);
}

void CalibrationRuns::breakOff(const QString& why)
{
    hold();
    close(why, true);
}

SwingPlan CalibrationRuns::swingPlan() const
{
    SwingPlan plan = m_swing.planned();
    if (const auto may = maySwing(); !may) {
        plan.obstacle = may.error().text;
    }
    return plan;
}

std::vector<calibration::SwingDot> CalibrationRuns::swingSoFar() const
{
    return m_swing.run() ? m_swing.run()->dots(mountingOf(m_profile->sensor).sense)
                         : std::vector<calibration::SwingDot>{};
}

bool CalibrationRuns::wantsPower() const
{
    return m_scan.run() && m_scan.run()->wantsPower(m_clock.now());
}

CalibrationProgress CalibrationRuns::progress() const
{
    const SteadyTime now = m_clock.now();
    CalibrationProgress progress{.run = running(), .outcome = m_outcome, .failed = m_failed};
    if (const auto& swing = m_swing.run()) {
        progress.done = swing->part(now);
        progress.left = swing->left(now);
        progress.text = swing->text(now);
    } else if (const auto& scan = m_scan.run()) {
        progress.done = scan->part();
        progress.text = scan->text(now);
    } else if (m_offset) {
        progress.done = m_offset->part(now);
        progress.left = m_offset->left(now);
        progress.text = m_offset->text();
    }
    return progress;
}

}  // namespace boresight
