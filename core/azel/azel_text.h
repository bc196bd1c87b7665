// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"
#include "core/units/sky.h"

#include <chrono>
#include <cstddef>
#include <optional>
#include <string_view>

// The text of an azel.dat, in which WSJT-X and related programs report the direction of the Moon. It is complete or it
// is refused: nothing is used from a text that is truncated or mixes two times. Pure.
namespace boresight::azel {

enum class Radio
{
    Receives,
    Transmits
};

struct AzelText
{
    std::chrono::seconds timeOfDay{0};  // UTC; the file has no date
    SkyPointing moon;                   // azimuth [0°, 360°) from true north, elevation [-90°, 90°]
    std::optional<SkyPointing> sun;     // empty: its angles are invalid
    std::optional<Radio> radio;         // empty: the program does not write it
    std::optional<double> megahertz;    // dial frequency, whole MHz; empty if it does not fit into the field
    std::optional<double> dxDoppler;    // Hz
    std::optional<double> selfDoppler;  // Hz

    bool operator==(const AzelText&) const = default;
};

// The longest form has about 200 bytes. Readers read at most one byte beyond this limit.
inline constexpr std::size_t kLongestAzelText = 512;

// Refused with a reason that quotes nothing from the text.
[[nodiscard]] Result<AzelText> readAzelText(std::string_view text);

}  // namespace boresight::azel
