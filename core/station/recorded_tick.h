// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/messages/sensor_status.h"
#include "core/messages/station_status.h"
#include "core/recording/recording.h"

// The values of a recording, from those of the station. Pure.
namespace boresight {

// `sample` belongs to the tick of `status` and was taken at `utc`.
[[nodiscard]] recording::Tick recordedTick(const StationStatus& status, const TickSample& sample,
                                           const SensorStatus& sensor, UtcTime utc);
// The log has the clock of the computer, which is `ahead` of the clock of the ticks.
[[nodiscard]] recording::Event recordedEvent(const LogEntry& entry, Seconds ahead);
// For a recording that begins now.
[[nodiscard]] recording::Header recordedHeader(const StationStatus& status, bool simulated);

}  // namespace boresight
