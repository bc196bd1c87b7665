// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/numbers.h"
#include "core/elements/iso_epoch.h"
#include "core/elements/tle_reader.h"
#include "core/orbit/sgp4.h"
#include "core/orbit/topocentric.h"
#include "core/plan/plan_pass.h"
#include "tests/fakes/reference_data.h"

#include <QtGlobal>

#include <fstream>
#include <iterator>
#include <map>
#include <sstream>
#include <string>
#include <vector>

// The tables of planned passes. An environment variable may name another table of the same form.
namespace boresight::plan {

using Row = std::map<std::string, std::string>;  // by the names of the columns

inline std::string tablePath(const char* variable, const char* name)
{
    const QByteArray other = qgetenv(variable);
    return other.isEmpty() ? fakes::referencePath(name) : other.toStdString();
}

inline bool hasTable(const char* variable, const char* name)
{
    return std::ifstream(tablePath(variable, name)).good();
}

inline std::vector<Row> tableRows(const char* variable, const char* name)
{
    std::ifstream file(tablePath(variable, name));
    std::vector<std::string> names;
    std::vector<Row> rows;
    for (std::string line; std::getline(file, line);) {
        if (line.empty() || line.starts_with('#')) {
            continue;
        }
        std::istringstream stream(line);
        std::vector<std::string> cells;
        for (std::string cell; std::getline(stream, cell, ',');) {
            cells.push_back(cell);
        }
        if (names.empty()) {
            names = cells;
            continue;
        }
        Row& row = rows.emplace_back();
        for (std::size_t i = 0; i < names.size(); ++i) {
            row[names[i]] = i < cells.size() ? cells[i] : std::string();
        }
    }
    return rows;
}

inline double number(const Row& row, const char* column)
{
    return parseFinite(row.at(column)).value();
}

inline Angle degrees(const Row& row, const char* column)
{
    return Angle::fromDegrees(number(row, column));
}

inline UtcTime utc(const Row& row, const char* column)
{
    return orbit::utcTime(orbit::parseIsoEpoch(row.at(column)).value());
}

inline std::map<std::string, orbit::ElementSet> elementsByName()
{
    std::ifstream file(tablePath("TLE_SATS", "tle_sats.txt"));
    const std::string text(std::istreambuf_iterator<char>(file), {});
    std::map<std::string, orbit::ElementSet> sets;
    for (const orbit::ElementSet& set : orbit::readTle(text).sets) {
        sets.emplace(set.name, set);
    }
    return sets;
}

inline DirectionAt directionsOf(const orbit::ElementSet& set, const Site& site)
{
    return [orbit = orbit::Sgp4(set), observer = orbit::Observer(site)](UtcTime at) -> std::optional<SkyPointing> {
        const orbit::JulianDate date = orbit::julianDate(at);
        const orbit::OrbitResult state = orbit.propagate(date);
        return state ? std::optional(observer.look(orbit::groundState(*state, date)).direction) : std::nullopt;
    };
}

struct AxisSpeeds
{
    double speed;         // °/s
    double acceleration;  // °/s²
};

inline PlanMount mountWith(const AxisSpeeds& azimuth, const AxisSpeeds& elevation, const TravelRange& azimuths,
                           const TravelRange& elevations, const pointing::Region& region = {})
{
    const auto limits = [](const AxisSpeeds& axis) {
        return tracking::MotionLimits{.speed = AngularRate::fromDegrees(axis.speed),
                                      .acceleration = AngularAcceleration::fromDegrees(axis.acceleration),
                                      .jerk = {}};
    };
    return {.region = pointing::PermittedRegion(region, azimuths, elevations),
            .pointing = {},
            .azimuth = limits(azimuth),
            .elevation = limits(elevation),
            .beamWidth = 0.5_deg};
}

}  // namespace boresight::plan
