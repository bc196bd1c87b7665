// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>

// The coasts of the Earth as closed lines, accurate to half a degree.
namespace boresight::ui {

struct CoastPoint
{
    std::int16_t longitude = 0;  // tenths of a degree, east positive
    std::int16_t latitude = 0;   // north positive

    bool operator==(const CoastPoint&) const = default;
};

// Ends each line.
inline constexpr CoastPoint kCoastEnd{9999, 9999};

[[nodiscard]] std::span<const CoastPoint> coastPoints();

}  // namespace boresight::ui
