// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"
#include "core/schedule/night_report.h"

#include <QString>

#include <string>
#include <string_view>

// A night report as a TOML file, and back. Angles are in degrees. Pure.
namespace boresight::schedule {

// Refuses what could not be read again: a number that is not finite or out of range.
[[nodiscard]] Result<std::string> toText(const NightReport& report);

// Strict: all errors are reported at once, one "FILE:LINE: key: reason" per line.
[[nodiscard]] Result<NightReport> parseReport(std::string_view text, const QString& fileName);

// The same for the pass that is stored in its own file.
[[nodiscard]] Result<std::string> toText(const NewestPass& newest);
[[nodiscard]] Result<NewestPass> parsePass(std::string_view text, const QString& fileName);

}  // namespace boresight::schedule
