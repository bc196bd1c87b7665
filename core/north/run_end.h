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
    bool holds = false;  // the mount is to hold, if it still moves for the run
    RunFinding found = {};
};

[[nodiscard]] RunEnd failedRun(const QString& why);
// The same, and the mount is to hold.
[[nodiscard]] RunEnd brokenOff(const QString& why);
// The mount does not do any more what a run asked of it: why.
[[nodiscard]] QString whoEnded(const StationControl& control);

}  // namespace boresight
