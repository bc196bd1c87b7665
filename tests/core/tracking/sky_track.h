// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"
#include "core/units/sky.h"

#include <map>
#include <string>
#include <vector>

// Paths across the sky for the tests of this folder: rows of tests/data, and satellites on circular orbits.
namespace boresight::tracking {

struct Timed
{
    double time;  // s
    AxisPosition position;
};

inline SteadyTime at(double seconds)
{
    return SteadyTime{std::chrono::duration_cast<SteadyTime::duration>(Seconds(1000.0 + seconds))};
}

inline AxisPosition axes(double azimuth, double elevation)
{
    return {Angle::fromDegrees(azimuth), Angle::fromDegrees(elevation)};
}

// In degrees.
double skyDistance(const AxisPosition& a, const AxisPosition& b);

// Rows of time, azimuth and elevation. The first `keys` columns name the path: "A85,gp_0.1". The environment variable
// may name another file of the same form.
std::map<std::string, std::vector<Timed>> table(const char* variable, const std::string& name, std::size_t keys);

inline std::map<std::string, std::vector<Timed>> trueTracks()
{
    return table("TRACK_TRUTH", "track_truth.csv", 1);
}

// From rise to set every 0.2 s, as in track_truth.csv. It culminates in the north, and the azimuth passes through
// north. The Earth is a sphere and does not rotate.
std::vector<Timed> circularPass(double heightKm, Angle maxElevation);

}  // namespace boresight::tracking
