// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/north/swing_pilot.h"

#include "core/alarms/catalogue.h"
#include "core/base/text.h"
#include "core/base/time_of_day.h"
#include "core/control/calibration_source.h"

#include <utility>

namespace boresight {
namespace {

const QString kSwingSource = QStringLiteral("calibration");
// A swing continues this long without a known position. A stall of this computer is over by then, and the drives have
// their own watchdog.
constexpr Seconds kUnseen{1.0};

QString usedText(const calibration::SwingTally& tally, const calibration::SwingLimits& limits)
{
    if (tally.leftOut() == 0) {
        return Text::tr("done, from %1 readings").arg(tally.all());
    }
    return Text::tr("done, from %1 of %2 readings. Left out: %3")
        .arg(tally.of(calibration::SampleFate::Used))
        .arg(tally.all())
        .arg(tally.whyLeftOut(limits));
}

}  // namespace

SwingPilot::SwingPilot(StationControl& control, const profile::InForce& profile, const LiveSensor& sensor,
                       const AxisObserver& axes, const Clock& clock, EventLog& log)
    : m_control(control), m_profile(profile), m_sensor(sensor), m_axes(axes), m_clock(clock), m_log(log)
{}

SwingPlan SwingPilot::planned() const
{
    const auto here = m_control.measured();
    if (!here) {
        SwingPlan plan{.rate = m_wish.rate, .headings = m_wish.headings};
        plan.obstacle = here.error().text;
        return plan;
    }
    return planSwing(m_wish, *here, m_control.region(), m_control.limits(Axis::Azimuth));
}

Result<> SwingPilot::mayStart() const
{
    return m_control.mayPoint(calibrationSource())
        .and_then([this] { return m_sensor.isUsable(); })
        .and_then([this]() -> Result<> {
            if (m_control.authority() == Authority::Clients) {
                return failure(ErrorCode::Refused, Text::tr("Clients have control. Take control before the swing."));
            }
            return m_control.measured().map([](const auto&) {});
        });
}

void SwingPilot::start(const SwingPlan& plan)
{
    m_restarts = m_sensor.restarts();
    m_run.emplace(plan, *m_control.measured(), m_control.limits(Axis::Azimuth), m_profile->sensor, m_clock.now());
    m_log.add(Severity::Advisory, kSwingSource, Text::tr("swings the compass: %1").arg(plan.text));
}

void SwingPilot::take(const SwingReading& reading)
{
    m_run->take(reading);
}

std::optional<RunEnd> SwingPilot::tick()
{
    if (const QString reason = ending(); !reason.isEmpty()) {
        return brokenOff(reason);
    }
    if (const auto axes = m_axes.now()) {
        if (const auto refused = askForMotion(*axes)) {
            return refused;
        }
    }
    return m_run->done() ? std::optional(finish()) : std::nullopt;
}

void SwingPilot::end()
{
    m_control.alarms().clear(alarmEntry("swing.waits"));
    m_run.reset();
}

// A silent sensor may come back, so the swing waits for it, standing still.
QString SwingPilot::ending() const
{
    const SteadyTime now = m_clock.now();
    const auto usable = m_sensor.isUsable();
    if (!usable && (m_sensor.isHeard() || !m_run->begun() || m_run->waitedInVain(now))) {
        return usable.error().text;
    }
    if (m_axes.unseenFor() > kUnseen) {
        return Text::tr("The position of the mount is unknown.");
    }
    if (m_sensor.restarts() != m_restarts) {
        return Text::tr("The sensor restarted during the swing. Its compass may have another zero now.");
    }
    if (m_run->late(now)) {
        return Text::tr("The mount is not moving. Something is blocking it.");
    }
    return m_run->begun() && !m_control.obeys(calibrationSource()) ? whoEnded(m_control) : QString();
}

std::optional<RunEnd> SwingPilot::askForMotion(const AxesThen& axes)
{
    const auto heard = m_sensor.isHeard();
    const bool waited = m_run->waits();
    const auto wanted = m_run->step(m_clock.now(), axes, heard.has_value());
    reportWait(waited, heard);
    if (!wanted) {
        return std::nullopt;
    }
    const auto admitted = m_control.request(*wanted, calibrationSource());
    return admitted ? std::nullopt : std::optional(brokenOff(admitted.error().text));
}

void SwingPilot::reportWait(bool waited, const Result<>& heard)
{
    if (m_run->waits() && !waited) {
        warnOfWait(heard.error().text);
    } else if (waited && !m_run->waits()) {
        m_control.alarms().clear(alarmEntry("swing.waits"));
        m_log.add(Severity::Advisory, kSwingSource, Text::tr("sensor data is back, and the swing continues"));
    }
}

// A person at the mast sees the mount stand. It must not start again without a warning.
void SwingPilot::warnOfWait(const QString& why)
{
    const QString left = QString::number(m_run->waitLeft(m_clock.now()).count(), 'f', 0);
    m_log.add(Severity::Warning, kSwingSource, Text::tr("the swing pauses for at most %1 s: %2").arg(left, why));
    const UtcTime until = m_clock.utc() + std::chrono::round<UtcTime::duration>(m_run->waitLeft(m_clock.now()));
    m_control.alarms().raise(alarmEntry("swing.waits"), {timeOfDayText(until)});
}

RunEnd SwingPilot::finish() const
{
    auto outcome = m_run->outcome(m_clock.utc(), m_sensor.declination());
    if (!outcome) {
        return failedRun(outcome.error().text);
    }
    const SwungCompass swung{
        .outcome = std::make_shared<const SwingOutcome>(std::move(*outcome)),
        .doubt =
            m_run->heardAllAlong()
                ? QString()
                : Text::tr(
                      "The sensor was silent and does not report its calibration. If it restarted, repeat the swing.")};
    const calibration::CompassSwing& fit = swung.outcome->fit;
    if (!fit.isUsable()) {
        const QString why = Text::tr("A compass does not work here. %1").arg(fit.hopeless.front());
        return {.outcome = why, .failed = true, .found = swung};
    }
    return {.outcome = usedText(calibration::SwingTally(fit.samples), m_run->limits()), .found = swung};
}

}  // namespace boresight
