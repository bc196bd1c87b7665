// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>

// The protocol's small calculations: Maidenhead locator, degrees-minutes-seconds, great circle on Hamlib's sphere of
// 111.2 km per degree. Degrees and kilometres as plain doubles, because they come from and go to text unchanged and
// never near the mount. Results agree with Hamlib 4.5.4 to the last printed digit. Pure.
namespace boresight::rotctld {

struct LongitudeLatitude
{
    double longitude = 0.0;  // degrees, east positive
    double latitude = 0.0;   // degrees, north positive
};

struct DegreesMinutesSeconds
{
    int degrees = 0;
    int minutes = 0;
    double seconds = 0.0;
    bool negative = false;  // south or west
};

struct DistanceAzimuth
{
    double kilometres = 0.0;
    double azimuth = 0.0;  // whole degrees
};

// length 2…13 characters, an odd one rounds down.
[[nodiscard]] std::optional<std::string> toLocator(LongitudeLatitude place, int length);
[[nodiscard]] std::optional<LongitudeLatitude> fromLocator(std::string_view locator);  // centre of the square

// Signs of the parts do not count, only `negative`.
[[nodiscard]] double toDegrees(const DegreesMinutesSeconds& angle);
[[nodiscard]] DegreesMinutesSeconds toDegreesMinutesSeconds(double degrees);  // wrapped to ±180° first

[[nodiscard]] std::optional<DistanceAzimuth> greatCircle(LongitudeLatitude from, LongitudeLatitude to);
[[nodiscard]] std::optional<double> longPathAzimuth(double shortPath);
[[nodiscard]] double longPathDistance(double shortPath);

}  // namespace boresight::rotctld
