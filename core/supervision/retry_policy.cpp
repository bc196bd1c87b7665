// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/supervision/retry_policy.h"

#include "core/base/text.h"
#include "core/supervision/finding_words.h"

#include <algorithm>

namespace boresight::supervision {
namespace {

using profile::Retry;

constexpr Seconds kHealth{3600.0};
constexpr double kCoolDown = 5.0;  // °C: a smaller margin would be used up by the first motion
// A board this far below its limit did not cause the fault, and waiting for it to cool would never end.
constexpr double kCool = 25.0;  // °C

Retry stricter(Retry one, Retry other)
{
    return std::min(one, other);  // in the order of the enumerators
}

QString tooHot(const QString& sentence, double now, double needed)
{
    return now <= needed ? QString() : sentence.arg(words(now, 0), words(needed, 0));
}

QString motorTooHot(double now, double needed)
{
    return tooHot(Text::tr("The motor is still at %1 °C. It must cool down to %2 °C."), now, needed);
}

QString boardTooHot(double now, double needed)
{
    return tooHot(Text::tr("The drive board is still at %1 °C. It must cool down to %2 °C."), now, needed);
}

QString supplyTooLow(double now, double needed)
{
    return now < needed
               ? Text::tr("The supply is still at %1 V. It must reach %2 V.").arg(words(now, 1), words(needed, 1))
               : QString();
}

QString supplyTooHigh(double now, double allowed)
{
    return now > allowed
               ? Text::tr("The supply is still at %1 V. It must fall to %2 V.").arg(words(now, 1), words(allowed, 1))
               : QString();
}

QString supplyRefusal(const profile::SupervisionSettings& settings, const std::optional<double>& now)
{
    if (!now) {
        return Text::tr("The drive does not report its supply voltage.");
    }
    const QString low = supplyTooLow(*now, settings.supplyLow);
    return low.isEmpty() ? supplyTooHigh(*now, settings.supplyHigh) : low;
}

// Fault 38 does not say whether the board or the motor was too hot. It was the motor if the board was far from its
// limit. The part that was too hot must cool down by kCoolDown. The other one must not be hot now either: a motor warms
// up for minutes after it was switched off.
QString heatRefusal(double boardLimit, double motorHot, const DriveConditions& atLoss, const DriveConditions& now)
{
    if (!now.boardTemperature) {
        return Text::tr("The drive does not report its temperature.");
    }
    const double boardThen = atLoss.boardTemperature.value_or(boardLimit);
    const bool boardWasFar = boardThen < boardLimit - kCoolDown;
    const double motorThen = atLoss.motorTemperature.value_or(0.0);
    const bool motorWasHot = boardWasFar && motorThen > motorHot - kCool;
    if (motorWasHot && !now.motorTemperature) {
        return Text::tr(
                   "The motor was at %1 °C and no longer reports its temperature. Repair its sensor, or let the motor "
                   "cool down and restart Boresight.")
            .arg(words(motorThen, 0));
    }
    const double motorNeeded = motorWasHot ? std::min(motorHot, motorThen - kCoolDown) : motorHot;
    const QString motor = now.motorTemperature ? motorTooHot(*now.motorTemperature, motorNeeded) : QString();
    if (!motor.isEmpty() || motorWasHot || boardThen < boardLimit - kCool) {
        return motor;
    }
    return boardTooHot(*now.boardTemperature, std::min(boardThen, boardLimit) - kCoolDown);
}

}  // namespace

void RetryPolicy::lost(LossClass loss, SteadyTime now)
{
    m_allowed = stricter(policy(loss), m_allowed.value_or(Retry::Interval));
    m_from = now;
    m_healthySince.reset();
}

void RetryPolicy::tried(SteadyTime now)
{
    m_tried = true;
    m_from = now;
}

void RetryPolicy::rearmed()
{
    m_allowed.reset();
    m_tried = false;
    m_healthySince.reset();
}

void RetryPolicy::healthy(SteadyTime now)
{
    m_allowed.reset();
    if (!m_healthySince) {
        m_healthySince = now;
    }
    if (now - *m_healthySince >= kHealth) {
        m_tried = false;
    }
}

std::optional<SteadyTime> RetryPolicy::nextTry() const
{
    const Retry allowed = m_allowed.value_or(Retry::Never);
    if (allowed == Retry::Never || (allowed == Retry::Once && m_tried)) {
        return std::nullopt;
    }
    return m_from + std::chrono::duration_cast<SteadyTime::duration>(m_profile->recovery.interval);
}

Retry RetryPolicy::policy(LossClass loss) const
{
    switch (loss) {
        case LossClass::OverTemperature:
            return m_profile->recovery.overTemperature;
        case LossClass::Supply:
            return m_profile->recovery.supply;
        case LossClass::Bus:
            return m_profile->recovery.bus;
        case LossClass::Encoder:
        case LossClass::Configuration:
        case LossClass::Driver:
        case LossClass::Motion:
        case LossClass::Released:
            break;
    }
    return Retry::Never;
}

QString clearRefusal(const profile::SupervisionSettings& settings, LossClass loss, const DriveConditions& atLoss,
                     const DriveConditions& now)
{
    if (loss == LossClass::OverTemperature) {
        return heatRefusal(settings.boardLimit, settings.motorHot, atLoss, now);
    }
    if (loss == LossClass::Supply) {
        return supplyRefusal(settings, now.voltage);
    }
    const bool wasLow = atLoss.voltage && *atLoss.voltage <= settings.supplyStop;
    return wasLow && now.voltage ? supplyTooLow(*now.voltage, settings.supplyLow) : QString();
}

QString standingRefusal(const profile::SupervisionSettings& settings, const DriveConditions& now)
{
    if (now.boardTemperature && *now.boardTemperature >= settings.boardLimit) {
        return boardTooHot(*now.boardTemperature, settings.boardLimit - kCoolDown);
    }
    return now.voltage ? supplyTooLow(*now.voltage, settings.supplyStop) : QString();
}

}  // namespace boresight::supervision
