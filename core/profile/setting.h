// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"
#include "core/profile/profile.h"

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

// Every setting, described once: the file's reader and writer, the commented default file, the dialog and the manual's
// table are made from this list. The default is what a default Profile holds.
namespace boresight::profile {

enum class SettingType
{
    Text,
    Integer,
    Number,
    Choice  // one of `choices`
};

enum class Applies
{
    Now,
    OnReconnect
};

using SettingValue = std::variant<std::string, std::int64_t, double>;  // Choice is a string

// Of the numbers in the file: a millionth of an arc second, and they hide the rounding between degrees and radians.
inline constexpr int kDecimals = 9;

struct Setting
{
    std::string key;  // "azimuth.travel_min_deg": table and key of the file
    SettingType type = SettingType::Text;
    std::string unit;  // "°/s"; empty without one
    double min = 0.0;  // of Integer and Number, ends included
    double max = 0.0;
    std::vector<std::string> choices;
    std::string text;  // what it does, one sentence
    Applies applies = Applies::Now;
    std::function<SettingValue(const Profile&)> get;
    // Refuses, with the reason, what is not of the setting's type and range; the profile is then unchanged.
    std::function<Result<>(Profile&, const SettingValue&)> set;
};

[[nodiscard]] std::span<const Setting> settings();
[[nodiscard]] const Setting* findSetting(std::string_view key);

// What one setting alone cannot tell: min below max, park inside the travel, different ids, ticks within the watchdog.
struct Problem
{
    std::string key;
    std::string text;

    bool operator==(const Problem&) const = default;
};
[[nodiscard]] std::vector<Problem> crossCheck(const Profile& profile);

// The texts of two settings, also for the command line that overrides them.
[[nodiscard]] Result<ListenAddress> parseListenAddress(std::string_view text);  // "127.0.0.1:4533", "[::1]:4533"
[[nodiscard]] std::string toText(const ListenAddress& address);

}  // namespace boresight::profile
