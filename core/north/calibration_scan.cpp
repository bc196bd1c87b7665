// SPDX-License-Identifier: GPL-3.0-or-later
// The part of CalibrationDesk that leads the cross scan of a body.
#include "core/base/text.h"
#include "core/north/calibration_desk.h"
#include "core/power/power_text.h"

#include <algorithm>
#include <cmath>

namespace boresight {
namespace {

constexpr Angle kNarrowest = Angle::fromDegrees(0.2);
constexpr Angle kWidest = Angle::fromDegrees(40.0);
// A peak is not believed to be sharper than the encoder and the gear.
constexpr Angle kSharpestPeak = Angle::fromDegrees(0.01);
// Faster than Sun and Moon, slower than the way between two places.
constexpr AngularRate kResting = AngularRate::fromDegrees(0.1);
// The beam is where it was sent.
constexpr Angle kThere = Angle::fromDegrees(0.05);

// Near the zenith an axis runs although the beam hardly moves.
AngularRate onSky(const AxesThen& axes)
{
    return AngularRate::fromRadians(std::hypot(axes.rates.azimuth.radians() * std::cos(axes.place.elevation.radians()),
                                               axes.rates.elevation.radians()));
}

}  // namespace

Result<> CalibrationDesk::handle(const request::StartCrossScan& wanted)
{
    if (!(wanted.width >= kNarrowest && wanted.width <= kWidest)) {
        return failure(ErrorCode::OutOfRange, Text::tr("a scan is %1° to %2° wide")
                                                  .arg(kNarrowest.degrees(), 0, 'f', 1)
                                                  .arg(kWidest.degrees(), 0, 'f', 0));
    }
    const ephemeris::Refraction before = m_follower.refraction();
    return nothingRuns()
        .and_then([&] { return m_points.hasRoom(); })
        .and_then([&] { return m_follower.permitsAround(wanted.body, ScanRun::placesOf(wanted.width)); })
        .and_then([&] { return m_follower.follow(wanted.body, ephemeris::Refraction::Radio, m_follower.overTheTop()); })
        .and_then([&] {
            m_beforeScan = before;
            m_scanned.reset();
            m_scan.emplace(wanted.width, m_clock.now());
            return lookOn();
        });
}

Result<> CalibrationDesk::handle(const request::GivePower& wanted)
{
    if (!(std::abs(wanted.decibels) <= power::kLargestPower)) {
        return failure(ErrorCode::OutOfRange, Text::tr("this is no power in dB"));
    }
    m_power = wanted.decibels;
    return m_scan && m_scan->wantsPower(m_clock.now()) ? giveScan(wanted.decibels) : Result<>{};
}

void CalibrationDesk::take(const power::Value& value)
{
    if (m_scan) {
        m_scan->hear(value.decibels, value.arrival);
    }
}

Result<> CalibrationDesk::giveScan(double decibels)
{
    m_scan->give(decibels, m_clock.now());
    return lookOn();
}

Result<> CalibrationDesk::lookOn()
{
    const Result<> looks = m_follower.lookBeside(m_scan->offset());
    if (!looks) {
        endRun(toQString(looks.error().text), true);
    }
    return looks;
}

// A reading counts at the place where the beam was sent, so it has to be there.
void CalibrationDesk::stepScan()
{
    const SteadyTime now = m_clock.now();
    if (const QString reason = endOfScan(); !reason.isEmpty()) {
        endRun(reason, true);
        return;
    }
    const auto axes = m_axes.now();
    if (!axes || onSky(*axes) > kResting || !m_control.onTarget(kThere)) {
        m_scan->moves(now);
        return;
    }
    if (const auto power = m_scan->heard(now)) {
        m_power = *power;
        m_changed = true;
        [[maybe_unused]] const Result<> looks = giveScan(*power);
    } else if (m_scan->done(now)) {
        finishScan(axes->place);
    }
}

QString CalibrationDesk::endOfScan() const
{
    if (!m_follower.following()) {
        return m_follower.ending().isEmpty() ? whoEnded() : m_follower.ending();
    }
    if (m_control.trim() != AxisPosition{}) {
        return Text::tr("the beam was shifted by hand in the middle of the scan");
    }
    if (const QString reason = m_control.limitedReason(); !reason.isEmpty()) {
        return Text::tr("the beam does not get to a place of the scan: %1").arg(reason);
    }
    return m_scan->obstacle(m_clock.now());
}

void CalibrationDesk::finishScan(const AxisPosition& middle)
{
    const ephemeris::Body body = *m_follower.body();
    const auto scanned = m_scan->outcome(middle);
    const auto truth = m_follower.direction(body);
    if (!scanned || !truth) {
        endRun(toQString(scanned ? truth.error().text : scanned.error().text), true);
        return;
    }
    m_scanned = *scanned;
    endRun(Text::tr("done: the peak is a point now"), false);
    addPoint({.axes = scanned->peak,
              .truth = *truth,
              .sigma = std::max(scanned->sigma, kSharpestPeak),
              .label = Text::tr("%1, peak").arg(bodyName(body))});
}

}  // namespace boresight
