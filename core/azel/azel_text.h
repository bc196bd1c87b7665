// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"
#include "core/units/sky.h"

#include <chrono>
#include <cstddef>
#include <optional>
#include <string_view>

// The text of an azel.dat, by which WSJT-X and its relatives report where the Moon is. It is whole or it is refused: of
// a text that was cut or is of two times nothing is used. Pure.
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
    std::optional<SkyPointing> sun;     // empty: its angles make no sense
    std::optional<Radio> radio;         // empty: the program writes none
    std::optional<double> megahertz;    // of the dial, whole; empty where it does not fit into the field
    std::optional<double> dxDoppler;    // Hz
    std::optional<double> selfDoppler;  // Hz

    bool operator==(const AzelText&) const = default;
};

// The longest form has some 200 bytes. No reader needs more than one byte beyond this.
inline constexpr std::size_t kLongestAzelText = 512;

// Refused with the reason. The reason repeats nothing of the text.
[[nodiscard]] Result<AzelText> readAzelText(std::string_view text);

}  // namespace boresight::azel
