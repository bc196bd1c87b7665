// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"
#include "core/profile/setting.h"

#include <QString>

#include <optional>

// A setting of the profile as the operator reads and types it. Pure.
namespace boresight::ui {

[[nodiscard]] QString groupTitle(const QString& table);  // of the file: "azimuth" is "Azimuth axis"
// As it is found on the screen: "lowest azimuth" on the panel Limits, "Gear ratio (Azimuth axis)" on the page of the
// profile.
[[nodiscard]] QString settingName(const std::string& key);
[[nodiscard]] QString problemText(const profile::Problem& problem);  // "NAME: TEXT"

[[nodiscard]] QString valueText(const profile::Setting& setting, const profile::Profile& profile);  // "450.0 °"
[[nodiscard]] QString typedText(const profile::Setting& setting, const profile::Profile& profile);  // "450.0", to edit
[[nodiscard]] QString rangeText(const profile::Setting& setting);  // "-3600 … 3600 °"; empty without one

// What was typed, into the profile; the unit may follow the number. Refused with the reason.
[[nodiscard]] Result<> putTyped(const profile::Setting& setting, const QString& typed, profile::Profile& profile);

// Where a value lies between the ends of its range, 0 to 1; by the logarithm where the range spans decades.
[[nodiscard]] std::optional<double> shareOfRange(const profile::Setting& setting, const profile::Profile& profile);

}  // namespace boresight::ui
