// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"
#include "core/profile/in_force.h"

#include <QString>

#include <optional>

// Decides whether and when the mount may be re-armed without a person. Only a loss by heat, supply or bus qualifies:
// its cause can pass by itself, and a reply shows whether it has passed. The profile must permit it. Pure: time is
// passed in.
namespace boresight::supervision {

// The kinds of loss, by how the mount may recover from them.
enum class LossClass
{
    Encoder,          // never re-armed without a person
    Configuration,    // never
    Driver,           // never
    Motion,           // never: a blocked axis, and every stop by our own supervision
    Released,         // never: power cycle, or another program commands the drive
    OverTemperature,  // by the profile
    Supply,           // by the profile
    Bus               // by the profile: silence, a drive's time-out
};

class RetryPolicy
{
public:
    // The profile outlives this. A changed rule of the profile applies from the next loss on.
    explicit RetryPolicy(const profile::InForce& profile) : m_profile(profile) {}

    // A drive was lost. Of several losses in one episode the strictest rule decides.
    void lost(LossClass loss, SteadyTime now);
    // An automatic re-arm was begun.
    void tried(SteadyTime now);
    // A person re-armed the mount. The episode is over, and "once" permits one attempt again.
    void rearmed();
    // Call every tick while nothing is lost. After an hour without a loss the episode is over.
    void healthy(SteadyTime now);

    // When the next automatic re-arm may be tried; empty: never, or nothing is lost.
    [[nodiscard]] std::optional<SteadyTime> nextTry() const;

private:
    [[nodiscard]] profile::Retry policy(LossClass loss) const;

    const profile::InForce& m_profile;
    std::optional<profile::Retry> m_allowed;  // the strictest rule of the present losses; empty: nothing is lost
    SteadyTime m_from{};                      // the last loss or attempt
    bool m_tried = false;                     // an automatic re-arm was tried in this episode
    std::optional<SteadyTime> m_healthySince;
};

// The values of one drive that matter for a re-arm. Empty: the drive does not report a number.
struct DriveConditions
{
    std::optional<double> voltage;           // V
    std::optional<double> boardTemperature;  // °C
    std::optional<double> motorTemperature;  // °C; empty also without a sensor
};

// Why a re-arm would be useless now: the heat or the bad supply that led to the fault lasts, or the drive does not
// report it any more. `atLoss` has the values reported at the loss. Empty: nothing is in the way.
[[nodiscard]] QString clearRefusal(const profile::SupervisionSettings& settings, LossClass loss,
                                   const DriveConditions& atLoss, const DriveConditions& now);
// The same for any drive, lost or not: the values that it reports now would stop the mount again at once.
[[nodiscard]] QString standingRefusal(const profile::SupervisionSettings& settings, const DriveConditions& now);

}  // namespace boresight::supervision
