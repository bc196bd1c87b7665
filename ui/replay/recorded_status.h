// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/messages/station_status.h"
#include "ui/replay/replay_tape.h"
#include "ui/sky/sky_trail.h"

#include <memory>
#include <vector>

// A recording as the values that the sky and the charts show of a station. Pure.
namespace boresight::ui {

// The charts use steady time. In a replay it is the UTC.
[[nodiscard]] SteadyTime steadyTimeOf(UtcTime utc);

// The profile with the values of the header. Limits and travel are not in a recording, so there are none.
[[nodiscard]] std::shared_ptr<const profile::Profile> recordedProfile(const recording::Header& header);

// The status that the station had at this moment, with this profile. Values that are too old have their age.
[[nodiscard]] StationStatus recordedStatus(const ReplayTape& tape,
                                           const std::shared_ptr<const profile::Profile>& profile, UtcTime utc);

[[nodiscard]] TickSample recordedSample(const recording::Tick& tick);

// The places of the beam in the last quarter of an hour before this moment, ten in each second.
[[nodiscard]] std::vector<SeenPlace> recordedTrail(const ReplayTape& tape, UtcTime utc);

}  // namespace boresight::ui
