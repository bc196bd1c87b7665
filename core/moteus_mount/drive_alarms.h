// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/alarms/alarm_list.h"
#include "core/base/text.h"
#include "core/moteus_mount/drive.h"
#include "core/supervision/finding.h"

#include <QString>

#include <string_view>

// What the operator reads when something is wrong with a drive. `drive` is its label: "azimuth drive". Pure.
namespace boresight::drive_alarms {

[[nodiscard]] AlarmText silent(const QString& drive);        // nothing was commanded
[[nodiscard]] AlarmText answersAgain(const QString& drive);  // and waits for a re-arm
[[nodiscard]] AlarmText lost(const QString& drive, DriveLoss loss, int faultCode, Seconds watchdog);
[[nodiscard]] AlarmText activeLimit(const QString& drive, int code);
[[nodiscard]] AlarmText supervised(const supervision::Observed& observed);
[[nodiscard]] AlarmText unordered(const QString& drive, moteus::Mode mode);

}  // namespace boresight::drive_alarms
