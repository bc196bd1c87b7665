// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"
#include "core/messages/tuning_status.h"
#include "core/tuning/tuning_run_state.h"

// The figures and the verdict of a finished tuning run. Pure.
namespace boresight {

// The error explains why the run has no result. The caller fills in the gains and the time.
[[nodiscard]] Result<TuningResult> resultOf(const TuningRunState& run);

}  // namespace boresight
