// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"

#include <cstddef>
#include <string>
#include <string_view>

// A wind speed as an anemometer reports it in one message. Whole or refused. Pure.
namespace boresight::wind {

enum class Unit
{
    MetresPerSecond,
    KilometresPerHour,
    Knots
};

struct Format
{
    std::string key = "wind";  // of the speed in a JSON object, or in front of the number
    Unit unit = Unit::MetresPerSecond;

    bool operator==(const Format&) const = default;
};

// No message of an anemometer has more bytes.
inline constexpr std::size_t kLongestReading = 4096;
// m/s. The strongest gust that was ever measured had 113 m/s.
inline constexpr double kStrongest = 150.0;

// In m/s: "12.3", "wind 12.3" with the key or with "wind" in front, or a JSON object with the key. Points in the key
// lead into the objects of an object: "wind.speed". Refused with the reason, which repeats nothing of the text.
[[nodiscard]] Result<double> readWind(std::string_view text, const Format& format);

}  // namespace boresight::wind
