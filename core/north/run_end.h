// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/sensor_offset.h"
#include "core/control/station_control.h"
#include "core/north/point_book.h"
#include "core/north/swing_run.h"

#include <QString>

#include <variant>

// How a run of a calibration ended and what it found. Values only.
namespace boresight {

using RunFinding = std::variant<std::monostate, calibration::SensorOffset, SwungCompass, NewPoint>;

struct RunEnd
{
    QString outcome;  // for the operator
    bool failed = false;
    bool holds = false;  // the mount must be held, if it still moves for the run
    RunFinding found = {};
};

[[nodiscard]] RunEnd failedRun(const QString& why);
// The same as the function above, and the mount must be held.
[[nodiscard]] RunEnd brokenOff(const QString& why);
// Why the mount stopped doing what a run asked of it.
[[nodiscard]] QString whoEnded(const StationControl& control);

}  // namespace boresight
