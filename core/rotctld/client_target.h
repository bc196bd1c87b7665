// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/rotctld/line_protocol.h"
#include "core/rotctld/rotator.h"

#include <optional>

// The target of a command that may have an angle for one axis only. Station thread.
namespace boresight::rotctld {

// The target with these angles of the client. An azimuth outside the limits is moved by 360° if that brings it inside.
// An axis without an angle keeps its set-point, because a real controller has a set-point for each axis.
[[nodiscard]] Result<SkyPointing> completed(const Rotator& rotator, std::optional<Angle> azimuth,
                                            std::optional<Angle> elevation);

// Points there. Fills in the outcome, except its result.
Result<> pointTo(Rotator& rotator, const Client& client, const Result<SkyPointing>& place, LineOutcome& outcome);

}  // namespace boresight::rotctld
