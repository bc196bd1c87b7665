// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/north/swing_run.h"

#include "core/base/text.h"

#include <algorithm>

namespace boresight {
namespace {

using calibration::Turning;

constexpr Angle kSwingRunThere = Angle::fromDegrees(0.3);
constexpr AngularRate kSwingRunStanding = AngularRate::fromDegrees(0.05);
// The swing does not wait longer for a mount that is blocked or creeps.
constexpr double kSwingRunPatience = 1.5;
constexpr Seconds kMorePatience{15.0};
// A sweep turns round at its end without stopping. The next tick of the way is included.
constexpr Seconds kReaction{0.1};
// More dots would cover each other in the plot, and they pass the queue to the window four times a second.
constexpr std::size_t kMostDots = 400;

}  // namespace

SwingRun::SwingRun(const SwingPlan& plan, const AxisPosition& here, const tracking::MotionLimits& limits,
                   const profile::SensorSettings& sensor, SteadyTime now)
    : m_plan(plan),
      m_limits(limits),
      m_inSensor(sensor.declinationInSensor),
      m_fit({.motorCurrent = sensor.swingCurrent}),
      m_settling(sensor.latency + sensor.averaging / 2.0),
      m_started(now),
      m_deadline(now +
                 std::chrono::duration_cast<SteadyTime::duration>(plan.duration * kSwingRunPatience + kMorePatience))
{
    if (plan.headings == 0) {
        planSweep(here);
    } else {
        planStops(here);
    }
}

// To the nearer end first, then to the other end and back.
void SwingRun::planSweep(const AxisPosition& here)
{
    const auto& [min, max] = m_plan.azimuth;
    const bool up = here.azimuth - min <= max - here.azimuth;
    const Leg clockwise{.to = max, .rate = m_plan.rate, .turning = Turning::Clockwise};
    const Leg back{.to = min, .rate = -m_plan.rate, .turning = Turning::CounterClockwise};
    m_legs = {{.to = up ? min : max, .rate = {}, .reads = false}, up ? clockwise : back, up ? back : clockwise};
}

void SwingRun::planStops(const AxisPosition& here)
{
    const auto stops = stopsOf(m_plan);
    // To approach every heading from the correct side, the swing would first step back before the first heading. There
    // may be no room for that. So the first and the middle heading are approached from the other side, which the fit of
    // the hysteresis tolerates.
    for (std::size_t i = 0; i < stops.size(); ++i) {
        const Angle from = i == 0 ? here.azimuth : stops[i - 1];
        const bool forth = i == 0 || i == stops.size() / 2 ? i < stops.size() / 2 : stops[i] > from;
        m_legs.push_back(
            {.to = stops[i], .rate = {}, .turning = forth ? Turning::Clockwise : Turning::CounterClockwise});
    }
}

bool SwingRun::reached(const Leg& leg, const AxesThen& axes) const
{
    if (leg.rate == AngularRate{}) {
        return abs(axes.place.azimuth - leg.to) < kSwingRunThere && abs(axes.rates.azimuth) < kSwingRunStanding;
    }
    const Angle run = stoppingWay(leg.rate, m_limits) + abs(leg.rate) * kReaction;
    return leg.rate > AngularRate{} ? axes.place.azimuth >= leg.to - run : axes.place.azimuth <= leg.to + run;
}

std::optional<Request> SwingRun::begin(const Leg& leg)
{
    m_begun = true;
    m_standsFor.reset();
    m_reads = leg.reads && leg.rate != AngularRate{};
    if (leg.rate == AngularRate{}) {
        return request::PointAxes{
            .position = {.azimuth = leg.to, .elevation = m_plan.elevation},
            .purpose = leg.reads ? Text::tr("compass swing, to a heading") : Text::tr("compass swing, to its start")};
    }
    return request::Move{.rates = {.azimuth = leg.rate, .elevation = {}},
                         .purpose = leg.turning == Turning::Clockwise
                                        ? Text::tr("compass swing, turning clockwise")
                                        : Text::tr("compass swing, turning counter-clockwise")};
}

// A reading is a mean over a second. Waits for the first reading of this heading alone, then takes a few.
bool SwingRun::dwells(SteadyTime now, const AxesThen& axes)
{
    const Leg& leg = m_legs[m_leg];
    if (!leg.reads || leg.rate != AngularRate{}) {
        return false;
    }
    if (!reached(leg, axes)) {
        m_standsFor.reset();
        m_reads = false;
        return true;
    }
    m_standsFor = m_standsFor.value_or(now);
    const Seconds stood(now - *m_standsFor);
    m_reads = stood >= m_settling;
    return stood < std::max(kSwingDwell, m_settling * 2.0);
}

// Stands still on its way. The headings that it passed without a sensor are passed again on the way back.
std::optional<Request> SwingRun::wait(SteadyTime now, const AxesThen& axes)
{
    if (waits()) {
        return std::nullopt;
    }
    m_waitsSince = now;
    m_reads = false;
    const Angle run = stoppingWay(axes.rates.azimuth, m_limits);
    const Angle rest = axes.place.azimuth + (axes.rates.azimuth < AngularRate{} ? -run : run);
    return request::PointAxes{.position = {.azimuth = std::clamp(rest, m_plan.azimuth.min, m_plan.azimuth.max),
                                           .elevation = m_plan.elevation},
                              .purpose = Text::tr("compass swing, waiting for sensor data")};
}

void SwingRun::goOn(SteadyTime now)
{
    const SteadyTime::duration waited = now - *m_waitsSince;
    m_started += waited;
    m_deadline += waited;
    m_waited += waited;
    m_waitsSince.reset();
    m_begun = false;
}

Seconds SwingRun::waitLeft(SteadyTime now) const
{
    return kLongestWait - m_waited - Seconds(now - m_waitsSince.value_or(now));
}

std::optional<Request> SwingRun::step(SteadyTime now, const AxesThen& axes, bool heard)
{
    if (done()) {
        return std::nullopt;
    }
    if (!heard) {
        return wait(now, axes);
    }
    if (waits()) {
        goOn(now);
    }
    if (!m_begun) {
        return begin(m_legs[m_leg]);
    }
    if (dwells(now, axes) || !reached(m_legs[m_leg], axes)) {
        return std::nullopt;
    }
    ++m_leg;
    m_begun = false;
    m_reads = false;
    return done() ? std::optional<Request>(request::Hold{}) : begin(m_legs[m_leg]);
}

void SwingRun::take(const SwingReading& reading)
{
    if (!m_reads || done()) {
        return;
    }
    const auto& [value, about, level] = reading;
    const Leg& leg = m_legs[m_leg];
    // Right after a turning point the value still belongs to the way before.
    const bool sweeping = leg.rate != AngularRate{};
    if (sweeping && about.rates.azimuth / m_plan.rate * (leg.rate / m_plan.rate) < 0.0) {
        return;
    }
    const auto magnetic = orientation::SensorHeading::folded(value.heading.angle() - m_inSensor);
    const auto calibrated = value.calibration ? std::optional(value.calibration->magnetometer) : std::optional<int>();
    m_samples.push_back({.axisAzimuth = about.place.azimuth,
                         .axisRate = about.rates.azimuth,
                         .turning = leg.turning,
                         .heading = magnetic,
                         .magnetometerCalibration = calibrated,
                         .motorCurrent = about.current,
                         .axisElevation = about.place.elevation});
    m_levels.push_back(
        {.axisAzimuth = level.place.azimuth, .axisElevation = level.place.elevation, .elevation = value.elevation});
}

double SwingRun::part(SteadyTime now) const
{
    return std::clamp(Seconds(m_waitsSince.value_or(now) - m_started) / m_plan.duration, 0.0, done() ? 1.0 : 0.99);
}

Seconds SwingRun::left(SteadyTime now) const
{
    return std::max(m_plan.duration - Seconds(m_waitsSince.value_or(now) - m_started), Seconds(0.0));
}

bool SwingRun::heardAllAlong() const
{
    return m_waited == Seconds(0.0) || std::ranges::all_of(m_samples, [](const calibration::SwingSample& sample) {
               return sample.magnetometerCalibration.has_value();
           });
}

QString SwingRun::text(SteadyTime now) const
{
    if (waits()) {
        const Seconds left = std::max(waitLeft(now), Seconds(0.0));
        return Text::tr("waiting for sensor data, for at most %1 s more").arg(left.count(), 0, 'f', 0);
    }
    if (done() || (m_leg == 0 && m_plan.headings == 0)) {
        return Text::tr("moving to the start of the swing");
    }
    const QString way = m_legs[m_leg].turning == Turning::Clockwise ? Text::tr("turning clockwise")
                                                                    : Text::tr("turning counter-clockwise");
    return QStringLiteral("%1, %2").arg(way, countText());
}

QString SwingRun::countText() const
{
    const calibration::SwingTally tally(m_samples, m_fit);
    const QString count = Text::tr("readings: %1").arg(tally.all());
    return tally.leftOut() == 0 ? count : Text::tr("%1, left out: %2").arg(count, tally.whyLeftOut(m_fit));
}

std::vector<calibration::SwingDot> SwingRun::dots(calibration::AzimuthSense sense) const
{
    return calibration::dotsOf(m_samples, m_fit, sense, kMostDots);
}

// The readings are relative to magnetic north, the result to true north: the circle is turned by the declination. The
// curve is turned, too. Its constant then includes everything that the sensor adds itself.
Result<SwingOutcome> SwingRun::outcome(UtcTime utc, Angle declination) const
{
    calibration::SwingLimits limits = m_fit;
    limits.declination = declination;
    auto fit = calibration::fitCompassSwing(m_samples, limits);
    if (!fit) {
        return tl::unexpected(fit.error());
    }
    fit->north.value = (fit->north.value + declination).wrapped360();
    fit->curve = fit->curve.withNorthMoved(declination);
    fit->curve.constant += fit->curve.sense == calibration::AzimuthSense::Clockwise ? m_inSensor : -m_inSensor;
    for (calibration::SwingResidual& residual : fit->samples) {
        residual.heading = (residual.heading + declination).wrapped360();
    }
    SwingOutcome outcome{.when = utc, .samples = m_samples, .fit = *fit};
    if (auto tilt = calibration::fitAxisTilt(m_levels, fit->north, levelLimits())) {
        outcome.tilt = *tilt;
    } else {
        outcome.noTilt = tilt.error().text;
    }
    return outcome;
}

}  // namespace boresight
