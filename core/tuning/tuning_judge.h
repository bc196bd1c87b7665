// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"
#include "core/messages/tuning_status.h"
#include "core/tuning/tuning_run_state.h"

// What a tuning run that went to its end has measured, and what that means in plain words. Pure.
namespace boresight {

// An error says why the run has no result. The gains and the time are left to the caller.
[[nodiscard]] Result<TuningResult> resultOf(const TuningRunState& run);

}  // namespace boresight
