// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/control/brake_guard.h"

#include "core/alarms/catalogue.h"
#include "core/base/text.h"
#include "core/profile/output_settings.h"

#include <algorithm>
#include <utility>

namespace boresight {
namespace {

// A drive with a watchdog has stopped its axis within this time after it became silent.
constexpr Seconds kWatchdogStop{2.0};
// An axis that moves shows its next whole step within this time.
constexpr Seconds kNextStep{3.0};

bool isHeldByNothing(const AxisReport& report)
{
    return report.answers && !report.changesHands &&
           (report.hand == AxisHand::Off || report.hand == AxisHand::TimedOut);
}

}  // namespace

void BrakeGuard::take(const contacts::OutputAnswer& answer)
{
    if (!isUsed()) {
        return;
    }
    m_answer = answer;
    if (answer.problem.isEmpty()) {
        m_isReported = false;
        m_of.alarms.clear(alarmEntry("brake.output-failed"));
    } else {
        m_of.alarms.raise(alarmEntry("brake.output-failed"), {toQString(m_of.profile->brake.output), answer.problem});
    }
}

// The places of a silent axis are old: it moves or it does not.
bool BrakeGuard::moves() const
{
    return !m_of.motion.atRest() || std::ranges::any_of(kAxes, [this](Axis axis) {
        return m_of.mount.report(axis).answers && !m_of.standstill.stands(axis);
    });
}

// Without a watchdog a silent axis may run to its last target, perhaps at half the speed of the profile.
brake::BrakeTimes BrakeGuard::times() const
{
    brake::BrakeTimes times{.switching = m_of.profile->brake.switching,
                            .setAfter = m_of.profile->brake.setAfter,
                            .urgent = Seconds(0.0),
                            .blind = kWatchdogStop};
    const Capabilities mount = m_of.mount.capabilities();
    for (const Axis axis : kAxes) {
        if (const auto& capabilities = mount.axes[index(axis)]) {
            const profile::AxisSettings& settings = m_of.profile->axis(axis);
            const Angle travel = settings.geometry.travel.max - settings.geometry.travel.min;
            const Seconds longest{2.0 * travel.radians() / settings.limits.speed.radians()};
            times.urgent = capabilities->step > Angle{} ? kNextStep : times.urgent;
            times.blind = capabilities->watchdog ? times.blind : std::max(times.blind, longest);
        }
    }
    return times;
}

QString BrakeGuard::step(bool isUrgent, SteadyTime now)
{
    // The wish is of the last tick. Meanwhile STOP may have come, or a drive may have been lost.
    const bool isWanted = std::exchange(m_isWanted, false) && !isUrgent && m_of.mount.follows();
    if (!isUsed()) {
        return {};
    }
    // A crash-stop test measures the first motion, so the brake is open before it, and stays open.
    const bool isTested = m_of.mount.proofRunning() && (m_of.mount.follows() || releases());
    const bool isNeeded = isWanted || isTested;
    const bool works = m_answer.problem.isEmpty();
    const auto ofAny = [this](const auto& holds) {
        return std::ranges::any_of(kAxes, [&](Axis axis) { return holds(m_of.mount.report(axis)); });
    };
    const bool endsMotion = !works && (isNeeded || releases()) && !std::exchange(m_isReported, true);
    m_sequence.step({.wanted = isNeeded && works,
                     .moves = moves(),
                     .isLimp = ofAny(isHeldByNothing),
                     .isBlind = ofAny([](const AxisReport& report) { return !report.answers; }),
                     .isUrgent = isUrgent || !works,
                     .released = m_answer.isOn},
                    times(), now);
    return endsMotion ? Text::tr("brake output: %1").arg(m_answer.problem) : QString();
}

bool BrakeGuard::letsMove(SteadyTime now, Seconds step)
{
    if (isOpen() && m_answer.problem.isEmpty()) {
        return true;
    }
    Motion ahead = m_of.motion;
    ahead.advance(now, step);
    m_isWanted = !ahead.atRest();
    return !m_isWanted;
}

Result<> BrakeGuard::admits() const
{
    return m_answer.problem.isEmpty()
               ? Result<>{}
               : failure(ErrorCode::Refused,
                         Text::tr("The brake output does not work: %1. Check the output.").arg(m_answer.problem));
}

Result<> BrakeGuard::admitsOff() const
{
    if (isSet()) {
        return {};
    }
    return failure(ErrorCode::Refused,
                   m_answer.problem.isEmpty()
                       ? Text::tr("The brake is not set yet. Wait until nothing has moved for %1 s.")
                             .arg(m_of.profile->brake.setAfter.count())
                       : Text::tr("The brake output does not work: %1. The brake may be open. Secure the antenna, then "
                                  "empty brake.output on the page Profile.")
                             .arg(m_answer.problem));
}

Result<> BrakeGuard::mayChange(const profile::Profile& after) const
{
    const profile::Profile& before = *m_of.profile;
    if (!profile::isAnotherOutput(before.brake.output, before.mqtt, after.brake.output, after.mqtt)) {
        return {};
    }
    const bool isIdle = (isSet() || !m_answer.problem.isEmpty()) && !moves();
    return !isIdle
               ? failure(ErrorCode::Refused,
                         Text::tr("The brake output (brake.output) can only be changed while the brake is set. Hold "
                                  "the mount, and wait until it stands still and the brake is set."))
               : Result<>{};
}

void BrakeGuard::profileChanged(const profile::Profile& before, const profile::Profile& after)
{
    if (profile::isAnotherOutput(before.brake.output, before.mqtt, after.brake.output, after.mqtt)) {
        m_sequence = {};
        m_answer = {};
        m_isReported = false;
        m_of.alarms.clear(alarmEntry("brake.output-failed"));
    }
}

BrakeStatus BrakeGuard::status() const
{
    return isUsed() ? BrakeStatus{.output = toQString(m_of.profile->brake.output),
                                  .state = m_sequence.state(),
                                  .problem = m_answer.problem}
                    : BrakeStatus{};
}

}  // namespace boresight
