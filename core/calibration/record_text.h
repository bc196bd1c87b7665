// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"
#include "core/calibration/calibration_record.h"

#include <QString>

#include <string>
#include <string_view>

// Writes a history of calibrations as a TOML file and reads it back. An exchanged record is a history with one entry.
// Angles are in degrees with 9 decimals. METHOD.md describes the keys. Pure.
namespace boresight::calibration {

// Refuses a value that could not be read again: a number that is not finite or out of range.
[[nodiscard]] Result<std::string> toText(const CalibrationHistory& history);

// Strict: a key that is unknown, missing, of another type or out of range is an error. All errors are reported
// together, one "FILE:LINE: key: reason" per line.
[[nodiscard]] Result<CalibrationHistory> parseHistory(std::string_view text, const QString& fileName);

}  // namespace boresight::calibration
