// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"
#include "core/targets/target.h"

#include <optional>
#include <span>
#include <string_view>

// A target as a person types it:
//
//   moon, jupiter, "cas a"            a natural object in the sky
//   25544, "iss (zarya)", iss         a known satellite: its number, its name, or words of one name only
//   azel 120.5,30                     a fixed direction: azimuth and elevation in degrees
//   radec 12:30:49.4,12:23:28         right ascension in hours and declination in degrees, J2000
//   place 38.757,-9.117,1200          degrees north, degrees east, metres above the ellipsoid, which may be left out
//   IM58kr, IM58kr long               a locator; by the long path
//
// "table FILE" and "oem FILE" name a file that the caller must read first (core/table_file). "rotctld:HOST:PORT" names
// a rotator that the caller must ask (core/followed_rotctld).
//
// Capital and small letters are equal. Pure.
namespace boresight::targets {

// The error names what is missing, or the satellites that the text may mean.
[[nodiscard]] Result<Target> parseTarget(std::string_view text, std::span<const orbit::ElementSet> satellites);

// The file in "table FILE" or "oem FILE". The content of the file decides about its format. Empty: another target.
[[nodiscard]] std::optional<QString> tableFile(std::string_view text);

// The text without blanks around it if it begins with "rotctld:". Empty: another target.
[[nodiscard]] std::optional<QString> otherRotator(std::string_view text);

// Parses "12:30:49.4,12:23:28" or "12.514,12.391". Empty for any other text.
[[nodiscard]] std::optional<ephemeris::StarPlace> parseStarPlace(std::string_view text);

}  // namespace boresight::targets
