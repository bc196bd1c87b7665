// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/moteus_mount/crash_stop_proof.h"

#include "core/base/numbers.h"
#include "core/base/text.h"

#include <algorithm>
#include <utility>

namespace boresight {
namespace {

constexpr Seconds kRunUp{1.5};  // long enough for a low speed to be steady
// The room must be enough for the run-up, the watchdog time and a long stopping distance.
constexpr Seconds kRoomTime{4.0};
constexpr Angle kRoomMargin = Angle::fromDegrees(2.0);
// A drive that brakes or holds stops the axis much earlier. A drive that does neither must not run on for longer.
constexpr Seconds kProofPatience{2.0};
// An axis stands still when its angle stays within the band for this time. The band is well above the encoder noise.
constexpr Seconds kStandingTime{0.12};
constexpr Angle kStandingBand = Angle::fromDegrees(0.03);
// The stop is counted from the first sample within this narrower band. More noise makes the measured time too long,
// never too short.
constexpr Angle kStoodBand = Angle::fromDegrees(0.005);

// The rate in the direction of the farther end of the travel. 0 if the room is not enough.
AngularRate direction(AngularRate rate, Angle from, const TravelRange& travel)
{
    const Angle up = travel.max - from;
    const Angle down = from - travel.min;
    const Angle room = abs(rate) * kRoomTime + kRoomMargin;
    return std::max(up, down) < room ? AngularRate{} : up > down ? rate : -rate;
}

QString nameOf(Axis axis)
{
    return axis == Axis::Azimuth ? Text::tr("azimuth") : Text::tr("elevation");
}

}  // namespace

Result<CrashStopProof> CrashStopProof::prepare(AngularRate rate, const AxisPosition& from, const TravelRange& azimuth,
                                               const TravelRange& elevation, AxisSet axes)
{
    const AngularRate azimuthRate = direction(rate, from.azimuth, azimuth);
    const AngularRate elevationRate = direction(rate, from.elevation, elevation);
    for (const Axis axis : axes) {
        if ((axis == Axis::Azimuth ? azimuthRate : elevationRate) == AngularRate{}) {
            return boresight::failure(
                ErrorCode::Refused,
                Text::tr(
                    "Not enough room for a crash stop of the %1 at %2°/s. Move it away from both ends of its travel.")
                    .arg(nameOf(axis), toQString(formatFixed(rate.degrees(), 1))));
        }
    }
    return CrashStopProof(azimuthRate, elevationRate, axes);
}

CrashStopProof::CrashStopProof(AngularRate azimuthRate, AngularRate elevationRate, AxisSet axes)
    : m_azimuthRate(azimuthRate), m_elevationRate(elevationRate), m_axes(axes)
{}

void CrashStopProof::enter(Phase phase, SteadyTime now)
{
    m_phase = phase;
    m_phaseSince = now;
    m_samples.clear();
}

CrashStopProof::Action CrashStopProof::step(SteadyTime now, const Measured& measured)
{
    if (!m_phaseSince) {
        m_phaseSince = now;
    }
    if (m_samples.empty() || m_samples.back().time != measured.received) {
        m_samples.push_back({measured.received, measured.angle});
    }
    switch (m_phase) {
        case Phase::RunningUp:
            return runUp(now, measured);
        case Phase::Starving:
            return watchStop(now);
        case Phase::Recovering:
            return recover(now, measured);
        case Phase::Over:
            break;
    }
    return Action::Finish;
}

CrashStopProof::Action CrashStopProof::runUp(SteadyTime now, const Measured& measured)
{
    if (now - *m_phaseSince < kRunUp) {
        return Action::Run;
    }
    const Angle moved = measured.angle - m_samples.front().angle;
    if (abs(moved) < abs(rate()) * kRunUp * 0.5) {
        return fail(Text::tr("the axis did not reach the speed"));
    }
    enter(Phase::Starving, now);
    m_samples.push_back({measured.received, measured.angle});
    return Action::Starve;
}

// The time of the earliest sample since which all samples lie within `band` of the last one.
SteadyTime CrashStopProof::within(Angle band) const
{
    const Angle last = m_samples.back().angle;
    SteadyTime since = m_samples.back().time;
    for (auto sample = m_samples.rbegin(); sample != m_samples.rend() && abs(sample->angle - last) <= band; ++sample) {
        since = sample->time;
    }
    return since;
}

CrashStopProof::Action CrashStopProof::watchStop(SteadyTime now)
{
    if (m_samples.back().time - within(kStandingBand) >= kStandingTime) {
        m_stop =
            Stop{.rate = abs(rate()),
                 .angle = abs(m_samples.back().angle - m_samples.front().angle),
                 .time = std::chrono::round<std::chrono::milliseconds>(within(kStoodBand) - m_samples.front().time)};
        enter(Phase::Recovering, now);
        return Action::Recover;
    }
    if (now - *m_phaseSince > kProofPatience) {
        m_failure = Text::tr("The %1 did not stop within %2 s without commands. Check its time-out mode.")
                        .arg(nameOf(axis()))
                        .arg(kProofPatience.count());
        enter(Phase::Recovering, now);
        return Action::Recover;
    }
    return Action::Wait;
}

CrashStopProof::Action CrashStopProof::recover(SteadyTime now, const Measured& measured)
{
    if (!measured.settled) {
        return now - *m_phaseSince > kProofPatience ? fail(Text::tr("its drive did not come back")) : Action::Wait;
    }
    if (!m_failure.isEmpty() || m_axes.size() == 1) {
        m_phase = Phase::Over;
        return Action::Finish;
    }
    m_axes = m_axes.subspan(1);
    enter(Phase::RunningUp, now);
    return Action::Wait;
}

CrashStopProof::Action CrashStopProof::fail(const QString& why)
{
    m_failure = QStringLiteral("%1: %2").arg(nameOf(axis()), why);
    m_phase = Phase::Over;
    return Action::Finish;
}

std::optional<CrashStopProof::Stop> CrashStopProof::takeStop()
{
    return std::exchange(m_stop, std::nullopt);
}

QString CrashStopProof::progress() const
{
    const QString name = nameOf(axis());
    switch (m_phase) {
        case Phase::RunningUp:
            return Text::tr("moving the %1 up to speed").arg(name);
        case Phase::Starving:
            return Text::tr("no commands to the %1, measuring how it stops").arg(name);
        case Phase::Recovering:
            return Text::tr("holding the %1 again").arg(name);
        case Phase::Over:
            break;
    }
    return {};
}

}  // namespace boresight
