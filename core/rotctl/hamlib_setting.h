// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"

#include <cstddef>
#include <string>
#include <string_view>

// A setting of Hamlib for the model that Boresight starts a rotctld for: "min_az=-90". Pure.
namespace boresight::rotctl {

// Of all settings of one rotctld 4.5 together, in bytes. It joins them by commas.
inline constexpr std::size_t kMostHamlibSettings = 1000;

struct HamlibSetting
{
    std::string name;
    std::string value;

    bool operator==(const HamlibSetting&) const = default;
};

// Fails with InvalidInput for another form, for what Boresight sets itself, and for a limit that is no number: rotctld
// would use 0 for it.
[[nodiscard]] Result<HamlibSetting> parseHamlibSetting(std::string_view text);

}  // namespace boresight::rotctl
