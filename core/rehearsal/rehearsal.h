// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"
#include "core/messages/rehearsal_status.h"
#include "core/night/night_desk.h"
#include "core/profile/profile.h"
#include "core/units/sky.h"

#include <functional>
#include <stop_token>

// Runs the schedule of the next day on a copy of the mount, as fast as this computer can: the same plan, control,
// limits and cable as for the real mount, with axes that follow exactly. Moves nothing and writes nothing. Blocking
// until it is done, so use a separate thread.
namespace boresight {

struct RehearsalTask
{
    profile::Profile profile;
    NightDesk::Satellites satellites;              // sorted by number
    std::string antenna = pointing::kMainAntenna;  // the selected antenna
    AxisPosition standing;                         // the position at the beginning; mechanical angles
    UtcTime from{};
};

// `progress` is called with 0 to 1 from time to time. The error explains why the schedule cannot be armed, or that the
// rehearsal was stopped.
[[nodiscard]] Result<RehearsedNight> rehearse(const RehearsalTask& task, const std::stop_token& stop,
                                              const std::function<void(double)>& progress);

}  // namespace boresight
