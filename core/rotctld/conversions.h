// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>

// The small calculations of the protocol: Maidenhead locator, degrees-minutes-seconds, great circle on Hamlib's sphere
// of 111.2 km per degree. Degrees and kilometres are plain doubles, because they come from text, go back to text, and
// never reach the mount. The results agree with Hamlib 4.5.4 to the last printed digit. Pure.
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

// `length`: 2…13 characters. An odd length is rounded down.
[[nodiscard]] std::optional<std::string> toLocator(LongitudeLatitude place, int length);
[[nodiscard]] std::optional<LongitudeLatitude> fromLocator(std::string_view locator);  // centre of the square

// Only `negative` decides the sign. The signs of the parts are ignored.
[[nodiscard]] double toDegrees(const DegreesMinutesSeconds& angle);
[[nodiscard]] DegreesMinutesSeconds toDegreesMinutesSeconds(double degrees);  // wrapped to ±180° first

[[nodiscard]] std::optional<DistanceAzimuth> greatCircle(LongitudeLatitude from, LongitudeLatitude to);
[[nodiscard]] std::optional<double> longPathAzimuth(double shortPath);
[[nodiscard]] double longPathDistance(double shortPath);

}  // namespace boresight::rotctld
