// SPDX-License-Identifier: GPL-3.0-or-later
// The part of CalibrationDesk that runs once per tick: notes the axes, leads what runs, sees what ends it.
#include "core/base/text.h"
#include "core/north/calibration_desk.h"
#include "core/witness/sensor_curve.h"

#include <algorithm>
#include <cmath>

namespace boresight {
namespace {

const QString kRunsSource = QStringLiteral("calibration");
const QString kWait = QStringLiteral("swing");  // cause of the alarm
constexpr std::chrono::milliseconds kPublishPeriod{250};
// For how long a swing goes on unseen: a stall of this computer is over by then, and the drives have their own watch.
constexpr Seconds kUnseen{1.0};
// The heading's mean ends when the elevation is read, just before the sensor sends both.
Seconds levelAge(const profile::SensorSettings& sensor)
{
    return std::max(sensor.latency - sensor.averaging / 2.0, Seconds(0.0));
}

SteadyTime before(SteadyTime time, Seconds age)
{
    return time - std::chrono::duration_cast<SteadyTime::duration>(age);
}

// How it ended, with what Apply will leave.
QString outcomeText(const QString& used, const QString& stays)
{
    return stays.isEmpty() ? used : QStringLiteral("%1; %2").arg(used, stays);
}

QString usedText(const calibration::SwingTally& tally, const calibration::SwingLimits& limits)
{
    if (tally.leftOut() == 0) {
        return Text::tr("done, from %1 readings").arg(tally.all());
    }
    return Text::tr("done, from %1 of %2 readings; left out: %3")
        .arg(tally.of(calibration::SampleFate::Used))
        .arg(tally.all())
        .arg(tally.whyLeftOut(limits));
}

}  // namespace

CalibrationRun CalibrationDesk::run() const
{
    return m_swing       ? CalibrationRun::Swing
           : m_scan      ? CalibrationRun::CrossScan
           : m_offsetRun ? CalibrationRun::SensorOffset
                         : CalibrationRun::None;
}

Result<> CalibrationDesk::nothingRuns() const
{
    if (run() != CalibrationRun::None) {
        return failure(ErrorCode::Busy, Text::tr("a calibration is running: end it first"));
    }
    return {};
}

Result<> CalibrationDesk::maySwing() const
{
    return nothingRuns()
        .and_then([this] { return m_sensor.isUsable(); })
        .and_then([this] { return m_control.mayPoint(calibrationSource()); })
        .and_then([this]() -> Result<> {
            if (m_control.authority() == Authority::Clients) {
                return failure(ErrorCode::Refused,
                               Text::tr("the clients have the control: take it before the mount is swung"));
            }
            return m_control.measured().map([](const auto&) {});
        });
}

SwingPlan CalibrationDesk::planned(const SwingWish& wish) const
{
    const auto here = m_control.measured();
    if (!here) {
        SwingPlan plan{.rate = wish.rate, .headings = wish.headings};
        plan.obstacle = toQString(here.error().text);
        return plan;
    }
    return planSwing(wish, *here, m_control.region(), m_profile.azimuth.limits);
}

// The sensor's value is old and a mean when it arrives: it is laid beside where the axes were then.
void CalibrationDesk::take(const SensorStatus& sensor)
{
    const orientation::Orientation* const value = m_sensor.take(sensor);
    if (value == nullptr) {
        return;
    }
    const profile::SensorSettings& settings = m_profile.sensor;
    const auto about = m_axes.trace().about(before(value->arrival, settings.latency), settings.averaging);
    const auto level = m_axes.trace().about(before(value->arrival, levelAge(settings)), Seconds(0.0));
    if (!about || !level) {
        return;
    }
    if (m_swing) {
        m_swing->take({.value = *value, .about = *about, .level = *level});
    } else if (m_offsetRun) {
        takeForOffset(*value, *about);
    }
}

void CalibrationDesk::takeForOffset(const orientation::Orientation& value, const AxesThen& about)
{
    calibration::SensorReading reading{
        .axisAzimuth = about.place.azimuth, .axisRate = about.rates.azimuth, .motorCurrent = about.current};
    // Without a swing there is no curve for the fit to be told, only a mounting to be dealt with.
    reading.heading = wasSwung(m_profile.sensor)
                          ? value.heading
                          : orientation::SensorHeading::folded(
                                curveOf(m_profile.sensor, m_sensor.declination()).corrected(value.heading));
    reading.axisElevation = about.place.elevation;
    if (value.calibration) {
        reading.systemCalibration = value.calibration->system;
        reading.magnetometerCalibration = value.calibration->magnetometer;
    }
    m_offsetRun->readings.push_back(reading);
}

void CalibrationDesk::tick()
{
    noteDrives();
    m_axes.tick();
    m_follower.tick();
    if (m_swing) {
        stepSwing();
    } else if (m_scan) {
        stepScan();
    } else if (m_offsetRun) {
        stepOffset();
    }
    if (m_changed || m_clock.now() - m_published >= kPublishPeriod) {
        publish();
    }
}

void CalibrationDesk::stepOffset()
{
    if (const auto tells = m_sensor.isUsable(); !tells) {
        endRun(toQString(tells.error().text), true);
        return;
    }
    if (Seconds(m_clock.now() - m_offsetRun->started) < kOffsetTime) {
        return;
    }
    const auto curve = wasSwung(m_profile.sensor) ? std::optional(curveOf(m_profile.sensor, m_sensor.declination()))
                                                  : std::optional<calibration::DeviationCurve>();
    const calibration::SensorOffsetLimits limits{.motorCurrent = m_profile.sensor.stillCurrent};
    const auto offset = calibration::sensorOffset(m_offsetRun->readings, limits, curve);
    if (!offset) {
        endRun(toQString(offset.error().text), true);
        return;
    }
    m_proposals.propose(*offset);
    endRun(outcomeText(Text::tr("done, from %1 readings").arg(offset->used), m_proposals.stays()), false);
}

void CalibrationDesk::stepSwing()
{
    if (const QString reason = endOfSwing(); !reason.isEmpty()) {
        holdMount();
        endRun(reason, true);
        return;
    }
    if (const auto axes = m_axes.now()) {
        leadSwing(*axes);
    }
    if (m_swing && m_swing->done()) {
        finishSwing();
    }
}

// A sensor that is silent may come back: that is waited for, standing still.
QString CalibrationDesk::endOfSwing() const
{
    const SteadyTime now = m_clock.now();
    const auto tells = m_sensor.isUsable();
    if (!tells && (m_sensor.isHeard() || !m_swing->begun() || m_swing->waitedInVain(now))) {
        return toQString(tells.error().text);
    }
    if (m_axes.unseenFor() > kUnseen) {
        return Text::tr("where the mount stands is not known any more");
    }
    if (m_sensor.restarts() != m_swingRestarts) {
        return Text::tr("the sensor was started anew meanwhile: its compass may count otherwise now");
    }
    if (m_swing->late(now)) {
        return Text::tr("the mount does not get on: something holds it");
    }
    return m_swing->begun() && !m_control.obeys(calibrationSource()) ? whoEnded() : QString();
}

void CalibrationDesk::leadSwing(const AxesThen& axes)
{
    const auto speaks = m_sensor.isHeard();
    const bool waited = m_swing->waits();
    const auto wanted = m_swing->step(m_clock.now(), axes, speaks.has_value());
    if (m_swing->waits() && !waited) {
        tellOfWait(toQString(speaks.error().text));
    } else if (waited && !m_swing->waits()) {
        m_control.alarms().clear(kWait);
        m_log.add(Severity::Advisory, kRunsSource, Text::tr("the sensor is heard again: the swing goes on"));
    }
    if (!wanted) {
        return;
    }
    if (const auto admitted = m_control.request(*wanted, calibrationSource()); !admitted) {
        holdMount();
        endRun(toQString(admitted.error().text), true);
    }
}

// Who stands at the mast sees it stand: it shall not set off again without a word.
void CalibrationDesk::tellOfWait(const QString& why)
{
    const QString left = QString::number(m_swing->waitLeft(m_clock.now()).count(), 'f', 0);
    m_log.add(Severity::Warning, kRunsSource, Text::tr("the swing stands still for %1 s at most: %2").arg(left, why));
    m_control.alarms().raise(
        kWait, Severity::Warning,
        {.what = Text::tr("the swing of the compass waits for its sensor"),
         .action =
             Text::tr("The mount stands still and goes on BY ITSELF when the sensor is heard within %1 s").arg(left),
         .remedy = Text::tr("Keep clear of the mount; STOP or Hold ends the swing")});
}

void CalibrationDesk::finishSwing()
{
    const calibration::SwingLimits limits = m_swing->limits();
    auto outcome = m_swing->outcome(m_clock.utc(), m_sensor.declination());
    if (!outcome) {
        endRun(toQString(outcome.error().text), true);
        return;
    }
    const SwungCompass swung{.outcome = std::make_shared<const SwingOutcome>(std::move(*outcome)),
                             .doubt = m_swing->heardAllAlong()
                                          ? QString()
                                          : Text::tr("the sensor was silent meanwhile and does not tell how it is "
                                                     "calibrated: if it was started anew, repeat the swing")};
    m_proposals.propose(swung);
    const calibration::CompassSwing& fit = swung.outcome->fit;
    if (fit.isUsable()) {
        endRun(outcomeText(usedText(calibration::SwingTally(fit.samples), limits), m_proposals.stays()), false);
    } else {
        endRun(Text::tr("a compass is of no use here: %1").arg(toQString(fit.hopeless.front())), true);
    }
}

// The mount does not do any more what the run asked of it.
QString CalibrationDesk::whoEnded() const
{
    switch (m_control.state()) {
        case StationState::Stopped:
            return Text::tr("STOP ended it: there is no result");
        case StationState::Fault:
            return Text::tr("a fault ended it: there is no result");
        default:
            return Text::tr("another command to the mount ended it: there is no result");
    }
}

void CalibrationDesk::holdMount()
{
    if (moves() && m_control.obeys(calibrationSource())) {
        [[maybe_unused]] const Result<> held = m_control.request(request::Hold{}, calibrationSource());
    }
}

void CalibrationDesk::endRun(const QString& outcome, bool failed)
{
    if (m_follower.looksBeside()) {
        m_follower.end();
    }
    if (m_scan) {
        m_follower.setRefraction(m_beforeScan);
    }
    m_control.alarms().clear(kWait);
    m_swing.reset();
    m_scan.reset();
    m_offsetRun.reset();
    m_outcome = outcome;
    m_failed = failed;
    m_changed = true;
    m_log.add(failed ? Severity::Warning : Severity::Advisory, kRunsSource,
              failed ? Text::tr("ends without a result: %1").arg(outcome) : outcome);
}

}  // namespace boresight
