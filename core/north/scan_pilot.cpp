// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/north/scan_pilot.h"

#include "core/base/text.h"
#include "core/power/power_text.h"

#include <algorithm>
#include <cmath>

namespace boresight {
namespace {

constexpr Angle kNarrowest = Angle::fromDegrees(0.2);
constexpr Angle kWidest = Angle::fromDegrees(40.0);
// The encoder and the gear cannot resolve a sharper peak.
constexpr Angle kSharpestPeak = Angle::fromDegrees(0.01);
// Faster than Sun and Moon move, slower than the way between two places.
constexpr AngularRate kResting = AngularRate::fromDegrees(0.1);
// Nearer than this the beam has arrived where it was sent.
constexpr Angle kThere = Angle::fromDegrees(0.05);

// Near the zenith the azimuth axis turns although the beam hardly moves.
AngularRate onSky(const AxesThen& axes)
{
    return AngularRate::fromRadians(std::hypot(axes.rates.azimuth.radians() * std::cos(axes.place.elevation.radians()),
                                               axes.rates.elevation.radians()));
}

}  // namespace

ScanPilot::ScanPilot(const StationControl& control, BodyFollower& follower, const AxisObserver& axes,
                     const Clock& clock)
    : m_control(control), m_follower(follower), m_axes(axes), m_clock(clock)
{}

Result<> ScanPilot::isWidth(Angle width)
{
    if (!(width >= kNarrowest && width <= kWidest)) {
        return failure(ErrorCode::OutOfRange, Text::tr("The width of a scan must be %1° to %2°.")
                                                  .arg(kNarrowest.degrees(), 0, 'f', 1)
                                                  .arg(kWidest.degrees(), 0, 'f', 0));
    }
    return {};
}

Result<> ScanPilot::start(ephemeris::Body body, Angle width)
{
    const ephemeris::Refraction before = m_follower.refraction();
    return m_follower.permitsAround(body, ScanRun::placesOf(width))
        .and_then([&] { return m_follower.follow(body, ephemeris::Refraction::Radio, m_follower.overTheTop()); })
        .and_then([&] {
            m_before = before;
            m_scanned.reset();
            m_run.emplace(width, m_clock.now());
            return lookOn();
        });
}

Result<> ScanPilot::isPower(double decibels)
{
    if (!(std::abs(decibels) <= power::kLargestPower)) {
        return failure(ErrorCode::OutOfRange, Text::tr("This is not a power in dB."));
    }
    return {};
}

Result<> ScanPilot::give(double decibels)
{
    m_power = decibels;
    return m_run && m_run->wantsPower(m_clock.now()) ? giveToRun(decibels) : Result<>{};
}

void ScanPilot::take(const power::Value& value)
{
    if (m_run) {
        m_run->hear(value.decibels, value.arrival);
    }
}

Result<> ScanPilot::giveToRun(double decibels)
{
    m_run->give(decibels, m_clock.now());
    return lookOn();
}

Result<> ScanPilot::lookOn()
{
    return m_follower.lookBeside(m_run->offset());
}

// A reading counts for the place where the beam was sent, so the beam must have arrived there.
ScanPilot::Step ScanPilot::tick()
{
    const SteadyTime now = m_clock.now();
    if (const QString reason = ending(); !reason.isEmpty()) {
        return {.end = failedRun(reason)};
    }
    const auto axes = m_axes.now();
    if (!axes || onSky(*axes) > kResting || !m_control.onTarget(kThere)) {
        m_run->moves(now);
        return {};
    }
    if (const auto power = m_run->heard(now)) {
        m_power = *power;
        const Result<> looks = giveToRun(*power);
        return {.read = true, .end = looks ? std::nullopt : std::optional(failedRun(looks.error().text))};
    }
    return {.end = m_run->done(now) ? std::optional(finish(axes->place)) : std::nullopt};
}

void ScanPilot::end()
{
    if (m_run) {
        m_follower.setRefraction(m_before);
        m_run.reset();
    }
}

QString ScanPilot::ending() const
{
    if (!m_follower.following()) {
        return m_follower.ending().isEmpty() ? whoEnded(m_control) : m_follower.ending();
    }
    if (m_control.trim() != AxisPosition{}) {
        return Text::tr("The beam was trimmed by hand during the scan.");
    }
    if (const QString reason = m_control.limitedReason(); !reason.isEmpty()) {
        return Text::tr("The beam cannot reach a place of the scan: %1").arg(reason);
    }
    return m_run->obstacle(m_clock.now());
}

RunEnd ScanPilot::finish(const AxisPosition& middle)
{
    const ephemeris::Body body = *m_follower.body();
    const auto scanned = m_run->outcome(middle);
    const auto truth = m_follower.direction(body);
    if (!scanned || !truth) {
        return failedRun(scanned ? truth.error().text : scanned.error().text);
    }
    m_scanned = *scanned;
    return {.outcome = Text::tr("done, and the peak is a point now"),
            .found = NewPoint{.axes = scanned->peak,
                              .truth = *truth,
                              .sigma = std::max(scanned->sigma, kSharpestPeak),
                              .label = Text::tr("%1, peak").arg(bodyName(body))}};
}

}  // namespace boresight
