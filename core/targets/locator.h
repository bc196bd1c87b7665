// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"
#include "core/units/quantity.h"

#include <string>
#include <string_view>

// Maidenhead locators, as radio amateurs name their place: pairs of letters and digits, first of longitude, then of
// latitude, each pair a finer grid: 20° × 10° (A–R), 2° × 1° (0–9), 5′ × 2.5′ (a–x), 30″ × 15″ (0–9), 1.25″ × 0.625″
// (a–x). Pure.
namespace boresight::targets {

struct GeoPoint
{
    Angle latitude;   // north positive
    Angle longitude;  // east positive

    bool operator==(const GeoPoint&) const = default;
};

// 4, 6, 8 or 10 characters in upper or lower case; the centre of that square.
[[nodiscard]] Result<GeoPoint> fromLocator(std::string_view text);

enum class LocatorLength
{
    Four = 4,
    Six = 6,
    Eight = 8,
    Ten = 10
};

// The square that contains a place, written "JN58td25ul". The latitude is within -90…90°. The longitude may have any
// number of turns.
[[nodiscard]] Result<std::string> toLocator(const GeoPoint& place, LocatorLength length = LocatorLength::Six);

}  // namespace boresight::targets
