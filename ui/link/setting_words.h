// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"
#include "core/profile/setting.h"

#include <QString>

#include <optional>

// A setting of the profile in the words of the screen. Pure.
namespace boresight::ui {

[[nodiscard]] QString groupTitle(const QString& table);  // of the file: "azimuth" is "Azimuth axis"
// Its name on the screen: "lowest azimuth" on the panel Limits, "Gear ratio (Azimuth axis)" on the page of the profile.
[[nodiscard]] QString settingName(const std::string& key);
[[nodiscard]] QString problemText(const profile::Problem& problem);  // "NAME: TEXT"

[[nodiscard]] QString valueText(const profile::Setting& setting, const profile::Profile& profile);  // "450.0 °"
// "450.0", to edit. Of a choice: its word in the file.
[[nodiscard]] QString typedText(const profile::Setting& setting, const profile::Profile& profile);
// "-3600 … 3600 °", "Hold position, Brake"; empty without one.
[[nodiscard]] QString rangeText(const profile::Setting& setting);

// Puts the typed text into the profile. The unit may follow the number. Refused with the reason.
[[nodiscard]] Result<> putTyped(const profile::Setting& setting, const QString& typed, profile::Profile& profile);

// The place of a value in its range, 0 to 1. Logarithmic if the range spans decades.
[[nodiscard]] std::optional<double> shareOfRange(const profile::Setting& setting, const profile::Profile& profile);

}  // namespace boresight::ui
