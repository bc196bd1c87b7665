// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"

#include <cstddef>
#include <string>
#include <string_view>

// The wind speed in one message of an anemometer. A message is read completely or refused. Pure.
namespace boresight::wind {

enum class Unit
{
    MetresPerSecond,
    KilometresPerHour,
    Knots
};

struct Format
{
    std::string key = "wind";  // key of the speed in a JSON object, or the word before the number
    Unit unit = Unit::MetresPerSecond;

    bool operator==(const Format&) const = default;
};

// No message of an anemometer is longer (bytes).
inline constexpr std::size_t kLongestReading = 4096;
// m/s. The strongest gust ever measured had 113 m/s.
inline constexpr double kStrongest = 150.0;

// In m/s. Reads "12.3", "wind 12.3" (with the key or with "wind"), or a JSON object with the key. Points in the key
// lead into nested objects: "wind.speed". The reason of a refusal repeats nothing of the text.
[[nodiscard]] Result<double> readWind(std::string_view text, const Format& format);

}  // namespace boresight::wind
