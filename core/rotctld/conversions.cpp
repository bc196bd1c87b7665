// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/rotctld/conversions.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace boresight::rotctld {
namespace {

constexpr double kKilometresPerDegree = 111.2;
constexpr double kRadiansPerDegree = std::numbers::pi / 180.0;

// Letters and digits alternate, and each pair divides the square before: 18 fields, 10 squares, 24 subsquares …
constexpr std::array kDivisions{18, 10, 24, 10, 24, 10};
constexpr int kMaxLocatorLength = 2 * static_cast<int>(kDivisions.size());

bool isDigitPair(std::size_t pair)
{
    return kDivisions.at(pair) == 10;
}

// Writes one coordinate, scaled to 0…180, into the characters first, first + 2, first + 4, …
void writeOrdinate(std::string& locator, std::size_t first, double ordinate)
{
    constexpr double kRoundingGuard = 0.000001;  // keeps 50° in the square that begins at 50°
    double rest = std::fmod(ordinate + 270.0 + kRoundingGuard, 180.0);
    double size = 180.0;
    for (std::size_t pair = 0; 2 * pair < locator.size(); ++pair) {
        size /= kDivisions.at(pair);
        const int index = static_cast<int>(rest / size);
        rest -= size * index;
        locator[2 * pair + first] = static_cast<char>((isDigitPair(pair) ? '0' : 'A') + index);
    }
}

std::optional<double> readOrdinate(std::string_view locator, std::size_t first)
{
    double ordinate = -90.0;
    double size = 180.0;
    for (std::size_t pair = 0; 2 * pair + 1 < locator.size(); ++pair) {
        const char character = locator[2 * pair + first];
        const bool lowerCase = character >= 'a' && character <= 'z';
        const int index = character - (isDigitPair(pair) ? '0' : lowerCase ? 'a' : 'A');
        if (index < 0 || index >= kDivisions.at(pair)) {
            return std::nullopt;
        }
        size /= kDivisions.at(pair);
        ordinate += size * index;
    }
    return ordinate + size / 2.0;
}

bool onTheGlobe(LongitudeLatitude place)
{
    return std::abs(place.latitude) <= 90.0 && std::abs(place.longitude) <= 180.0;
}

// A pole has no azimuth, so a point close to the pole is used.
double besidePole(double latitude)
{
    constexpr double kBeside = 89.999999999;
    return std::abs(latitude) == 90.0 ? std::copysign(kBeside, latitude) : latitude;
}

}  // namespace

std::optional<std::string> toLocator(LongitudeLatitude place, int length)
{
    constexpr double kMostTurned = 270.0;  // beyond this, the letters of Hamlib leave the alphabet
    if (length < 2 || length / 2 * 2 > kMaxLocatorLength || std::abs(place.longitude) > 2.0 * kMostTurned ||
        std::abs(place.latitude) > kMostTurned) {
        return std::nullopt;
    }
    std::string locator(static_cast<std::size_t>(length / 2) * 2, ' ');
    writeOrdinate(locator, 0, place.longitude / 2.0);
    writeOrdinate(locator, 1, place.latitude);
    return locator;
}

std::optional<LongitudeLatitude> fromLocator(std::string_view locator)
{
    if (locator.size() < 2 || locator.size() > kMaxLocatorLength + 1) {
        return std::nullopt;
    }
    const auto longitude = readOrdinate(locator, 0);
    const auto latitude = readOrdinate(locator, 1);
    if (!longitude || !latitude) {
        return std::nullopt;
    }
    return LongitudeLatitude{.longitude = *longitude * 2.0, .latitude = *latitude};
}

double toDegrees(const DegreesMinutesSeconds& angle)
{
    const double size = std::abs(static_cast<double>(angle.degrees)) +
                        std::abs(static_cast<double>(angle.minutes)) / 60.0 + std::abs(angle.seconds) / 3600.0;
    return angle.negative ? -size : size;
}

DegreesMinutesSeconds toDegreesMinutesSeconds(double degrees)
{
    const double wrapped =
        degrees >= 0.0 ? std::fmod(degrees + 180.0, 360.0) - 180.0 : std::fmod(degrees - 180.0, 360.0) + 180.0;
    const double size = std::abs(wrapped);
    const double minutes = (size - std::floor(size)) * 60.0;
    return {.degrees = static_cast<int>(size),
            .minutes = static_cast<int>(minutes),
            .seconds = (minutes - std::floor(minutes)) * 60.0,
            .negative = wrapped < 0.0 && wrapped != -180.0};
}

std::optional<DistanceAzimuth> greatCircle(LongitudeLatitude from, LongitudeLatitude to)
{
    if (!onTheGlobe(from) || !onTheGlobe(to)) {
        return std::nullopt;
    }
    const double fromLatitude = besidePole(from.latitude) * kRadiansPerDegree;
    const double toLatitude = besidePole(to.latitude) * kRadiansPerDegree;
    const double east = (to.longitude - from.longitude) * kRadiansPerDegree;
    const double cosine =
        std::sin(fromLatitude) * std::sin(toLatitude) + std::cos(fromLatitude) * std::cos(toLatitude) * std::cos(east);
    if (cosine > 0.999999999999999) {
        return DistanceAzimuth{};  // the same place
    }
    if (cosine < -0.999999) {
        return DistanceAzimuth{.kilometres = 180.0 * kKilometresPerDegree};  // every direction leads to the antipode
    }
    const double azimuth = std::atan2(
        std::sin(east) * std::cos(toLatitude),
        std::cos(fromLatitude) * std::sin(toLatitude) - std::sin(fromLatitude) * std::cos(toLatitude) * std::cos(east));
    const double turned = std::fmod(360.0 + azimuth / kRadiansPerDegree, 360.0);
    return DistanceAzimuth{.kilometres = std::acos(cosine) / kRadiansPerDegree * kKilometresPerDegree,
                           .azimuth = std::floor(turned + 0.5)};
}

std::optional<double> longPathAzimuth(double shortPath)
{
    if (!(shortPath >= 0.0 && shortPath <= 360.0)) {
        return std::nullopt;
    }
    return shortPath < 180.0 ? shortPath + 180.0 : shortPath == 360.0 ? 180.0 : shortPath - 180.0;
}

double longPathDistance(double shortPath)
{
    return 360.0 * kKilometresPerDegree - shortPath;
}

}  // namespace boresight::rotctld
