// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/targets/locator.h"

#include "core/base/text.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

namespace boresight::targets {

namespace {

struct Pair
{
    char first;          // of its characters
    std::int64_t steps;  // how many there are
    std::int64_t size;   // of one step, in steps of the finest grid
};

// 18 × 10 × 24 × 10 × 24 steps of the finest grid go round the globe, and from pole to pole.
constexpr std::array<Pair, 5> kPairs{{{'A', 18, 57600}, {'0', 10, 5760}, {'a', 24, 240}, {'0', 10, 24}, {'a', 24, 1}}};
constexpr std::int64_t kLocatorSteps = 18 * 57600;

constexpr double kLatitudeStep = 180.0 / kLocatorSteps;  // degrees
constexpr double kLongitudeStep = 360.0 / kLocatorSteps;

std::int64_t stepsOf(double degrees, double step)
{
    // The edge of a square belongs to it, even if the conversion between degrees and radians has rounded it down.
    constexpr double kRounding = 1e-6;
    return std::clamp(static_cast<std::int64_t>(std::floor(degrees / step + kRounding)), std::int64_t{0},
                      kLocatorSteps - 1);
}

char smallLetter(char character)
{
    return character >= 'A' && character <= 'Z' ? static_cast<char>(character - 'A' + 'a') : character;
}

}  // namespace

Result<GeoPoint> fromLocator(std::string_view text)
{
    if (text.size() < 4 || text.size() > 10 || text.size() % 2 != 0) {
        return failure(ErrorCode::InvalidInput, Text::tr("a locator has 4, 6, 8 or 10 characters, like JN58td"));
    }
    std::array<std::int64_t, 2> steps{};  // longitude, latitude
    for (std::size_t i = 0; i < text.size(); ++i) {
        const Pair& pair = kPairs.at(i / 2);
        const std::int64_t step = smallLetter(text[i]) - smallLetter(pair.first);
        if (step < 0 || step >= pair.steps) {
            const char last = static_cast<char>(pair.first + pair.steps - 1);
            return failure(ErrorCode::InvalidInput, Text::tr("character %1 of a locator is one of %2…%3")
                                                        .arg(QString::number(i + 1), QString(QLatin1Char(pair.first)),
                                                             QString(QLatin1Char(last))));
        }
        steps.at(i % 2) += step * pair.size;
    }
    const double half = static_cast<double>(kPairs.at(text.size() / 2 - 1).size) / 2.0;
    return GeoPoint{.latitude = Angle::fromDegrees((static_cast<double>(steps[1]) + half) * kLatitudeStep - 90.0),
                    .longitude = Angle::fromDegrees((static_cast<double>(steps[0]) + half) * kLongitudeStep - 180.0)};
}

Result<std::string> toLocator(const GeoPoint& place, LocatorLength length)
{
    constexpr double kPole = 90.0 + 1e-9;
    if (!(std::abs(place.latitude.degrees()) <= kPole) || !place.longitude.isFinite()) {
        return failure(ErrorCode::OutOfRange, Text::tr("latitude -90…90° and longitude -180…180° are expected"));
    }
    std::array<std::int64_t, 2> steps{stepsOf(place.longitude.wrapped180().degrees() + 180.0, kLongitudeStep),
                                      stepsOf(place.latitude.degrees() + 90.0, kLatitudeStep)};
    std::string text;
    for (std::size_t i = 0; i < static_cast<std::size_t>(length); ++i) {
        const Pair& pair = kPairs.at(i / 2);
        std::int64_t& rest = steps.at(i % 2);
        text += static_cast<char>(pair.first + rest / pair.size);
        rest %= pair.size;
    }
    return text;
}

}  // namespace boresight::targets
