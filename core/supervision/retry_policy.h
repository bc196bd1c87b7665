// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"
#include "core/profile/in_force.h"

#include <QString>

#include <optional>

// May the mount be re-armed without a person, and when? Pure; time is passed in. Only losses whose cause can pass by
// itself and leaves a reply to check (heat, supply, bus) ever qualify, and only where the profile says so.
namespace boresight::supervision {

// What kind of loss it was, as far as recovery is concerned.
enum class LossClass
{
    Encoder,          // never by itself
    Configuration,    // never
    Driver,           // never
    Motion,           // never: a blocked axis, and every Stop of our own supervision
    Released,         // never: power cycle, or another program commands the drive
    OverTemperature,  // by the profile
    Supply,           // by the profile
    Bus               // by the profile: silence, a drive's time-out
};

class RetryPolicy
{
public:
    // The profile outlives this. Another rule counts from the next loss on.
    explicit RetryPolicy(const profile::InForce& profile) : m_profile(profile) {}

    // A drive was lost. Several losses of one episode: the strictest one decides.
    void lost(LossClass loss, SteadyTime now);
    // An automatic re-arm was begun.
    void tried(SteadyTime now);
    // A person re-armed: the episode is over, and "once" counts again.
    void rearmed();
    // Every tick while nothing is lost. After an hour of health the episode is over.
    void healthy(SteadyTime now);

    // When the next automatic re-arm may be tried; empty: never, or nothing is lost.
    [[nodiscard]] std::optional<SteadyTime> nextTry() const;

private:
    [[nodiscard]] profile::Retry policy(LossClass loss) const;

    const profile::InForce& m_profile;
    std::optional<profile::Retry> m_allowed;  // by the strictest loss since the last attempt; empty: nothing is lost
    SteadyTime m_from{};                      // the last loss or attempt
    bool m_tried = false;                     // in this episode
    std::optional<SteadyTime> m_healthySince;
};

// What matters for a re-arm, of one drive. Empty: it does not say it, or says no number.
struct DriveConditions
{
    std::optional<double> voltage;           // V
    std::optional<double> boardTemperature;  // °C
    std::optional<double> motorTemperature;  // °C; empty also without a sensor
};

// Why a re-arm would be pointless now: the heat or the supply that led to the fault is still there, or is not told any
// more. `atLoss` is what was told last. Empty: go ahead.
[[nodiscard]] QString clearRefusal(const profile::SupervisionSettings& settings, LossClass loss,
                                   const DriveConditions& atLoss, const DriveConditions& now);
// The same of a drive whatever it was lost by, or was not: what it measures now would stop the mount again at once.
[[nodiscard]] QString standingRefusal(const profile::SupervisionSettings& settings, const DriveConditions& now);

}  // namespace boresight::supervision
