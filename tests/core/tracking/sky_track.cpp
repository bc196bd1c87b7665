// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/core/tracking/sky_track.h"

#include "core/base/numbers.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <sstream>

namespace boresight::tracking {

double skyDistance(const AxisPosition& a, const AxisPosition& b)
{
    const double e = a.elevation.radians();
    const double f = b.elevation.radians();
    const double cosine =
        std::sin(e) * std::sin(f) + std::cos(e) * std::cos(f) * std::cos((a.azimuth - b.azimuth).radians());
    return Angle::fromRadians(std::acos(std::clamp(cosine, -1.0, 1.0))).degrees();
}

std::map<std::string, std::vector<Timed>> table(const char* variable, const std::string& name, std::size_t keys)
{
    std::map<std::string, std::vector<Timed>> rows;
    const char* const other = std::getenv(variable);
    std::ifstream file(other && *other ? std::string(other) : std::string(BORESIGHT_TEST_DATA "/") + name);
    for (std::string line; std::getline(file, line);) {
        std::vector<std::string> field;
        std::istringstream fields(line);
        for (std::string text; std::getline(fields, text, ',');) {
            field.push_back(text);
        }
        const auto time = field.size() == keys + 3 ? parseFinite(field[keys]) : std::nullopt;
        if (time) {
            const std::string key = keys == 1 ? field[0] : field[0] + "," + field[1];
            rows[key].push_back({*time, axes(*parseFinite(field[keys + 1]), *parseFinite(field[keys + 2]))});
        }
    }
    return rows;
}

std::vector<Timed> circularPass(double heightKm, Angle maxElevation)
{
    constexpr double kEarthRadius = 6371.0;         // km, mean
    constexpr double kEarthGravity = 398'600.4418;  // km³/s², WGS 84
    const double radius = kEarthRadius + heightKm;
    const double horizon = kEarthRadius / radius;  // cosine of the angle at which the path touches the horizon
    const double aside = std::acos(horizon * std::cos(maxElevation.radians())) - maxElevation.radians();
    const double rate = std::sqrt(kEarthGravity / (radius * radius * radius));
    const double half = std::acos(horizon / std::cos(aside)) / rate;
    std::vector<Timed> pass;
    for (int i = 0; 0.2 * i <= 2.0 * half; ++i) {
        const double along = rate * (0.2 * i - half);
        const double north = radius * std::sin(aside) * std::cos(along);
        const double east = radius * std::sin(along);
        const double up = radius * std::cos(aside) * std::cos(along) - kEarthRadius;
        pass.push_back({0.2 * i,
                        {Angle::fromRadians(std::atan2(east, north)),
                         Angle::fromRadians(std::atan2(up, std::hypot(north, east)))}});
    }
    return pass;
}

}  // namespace boresight::tracking
