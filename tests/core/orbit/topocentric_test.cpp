// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/orbit/topocentric.h"

#include "core/base/numbers.h"
#include "core/elements/iso_epoch.h"
#include "core/elements/tle_reader.h"
#include "core/orbit/sgp4.h"
#include "tests/fakes/reference_data.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <string>

using namespace boresight;
using namespace boresight::orbit;
using namespace boresight::fakes;

namespace {

Site tableSite(const std::string& name)
{
    static const std::map<std::string, Site> sites{{"Lisbon", {38.757_deg, -9.117_deg, 80.0}},
                                                   {"Sydney", {-33.87_deg, 151.21_deg, 10.0}},
                                                   {"Svalbard", {78.23_deg, 15.39_deg, 450.0}}};
    return sites.at(name);
}

}  // namespace

// REQ-ORBIT-20: Azimuth (times cos elevation) and elevation agree with the table of known passes to 1e-4°, the range to
// 1e-3 km and its rate to 1e-5 km/s.
TEST(TopocentricReference, MeetsTheTable)
{
    if (!hasReference("azel_sats.csv") || !hasReference("tle_sats.txt")) {
        GTEST_SKIP() << "no " << referencePath("azel_sats.csv") << " and tle_sats.txt";
    }
    std::map<std::string, Sgp4> orbits;
    for (const ElementSet& set : readTle(referenceText("tle_sats.txt")).sets) {
        orbits.emplace(std::to_string(set.number), Sgp4(set));
    }
    auto rows = referenceRows("azel_sats.csv");
    ASSERT_GT(rows.size(), 500U);
    rows.erase(rows.begin());
    std::array<double, 4> worst{};
    for (const auto& row : rows) {
        const JulianDate utc = parseIsoEpoch(row.at(3)).value();
        const OrbitResult state = orbits.at(row.at(1)).propagate(utc);
        ASSERT_TRUE(state);
        const LookAngles seen = Observer(tableSite(row.at(2))).look(groundState(*state, utc));
        const auto value = [&](std::size_t column) { return parseFinite(row.at(column)).value(); };
        const Angle azimuth = (seen.direction.azimuth - Angle::fromDegrees(value(4))).wrapped180();
        const std::array<double, 4> off{std::abs(azimuth.degrees()) * std::cos(seen.direction.elevation.radians()),
                                        std::abs(seen.direction.elevation.degrees() - value(5)),
                                        std::abs(seen.kilometres - value(6)),
                                        std::abs(seen.kilometresPerSecond - value(7))};
        for (std::size_t i = 0; i < off.size(); ++i) {
            worst[i] = std::max(worst[i], off[i]);
        }
    }
    EXPECT_LT(worst[0], 1e-4);
    EXPECT_LT(worst[1], 1e-4);
    EXPECT_LT(worst[2], 1e-3);
    EXPECT_LT(worst[3], 1e-5);
    RecordProperty("worst_az_el_deg_km_km_s", std::to_string(worst[0]) + " " + std::to_string(worst[1]) + " " +
                                                  std::to_string(worst[2]) + " " + std::to_string(worst[3]));
}

// REQ-ORBIT-21: The sub-satellite point is on the ellipsoid, for satellites from the ground to the distance of the
// Moon.
TEST(SubSatellitePoint, IsThePlaceUnderTheSatellite)
{
    for (const double latitude : {-90.0, -89.9, -45.0, 0.0, 0.1, 38.757, 78.0, 90.0}) {
        for (const double height : {-400.0, 0.0, 420e3, 35786e3, 4e8}) {
            const Site site{Angle::fromDegrees(latitude), 151_deg, height};
            const Site found = subSatellitePoint(Observer(site).ground({}, 0.0));
            EXPECT_NEAR(found.latitude.degrees(), latitude, 1e-8) << height;
            EXPECT_NEAR(found.heightMetres, height, 1e-2) << latitude;
            if (std::abs(latitude) < 90.0) {
                EXPECT_NEAR(found.longitude.degrees(), 151.0, 1e-9);
            }
        }
    }
}

// REQ-ORBIT-22: The Doppler factor is 1 for a satellite at constant distance, and above 1 for one that approaches.
TEST(LookAnglesOfASatellite, HaveTheirDopplerFactor)
{
    EXPECT_EQ(LookAngles{}.dopplerFactor(), 1.0);
    EXPECT_NEAR(LookAngles{.kilometresPerSecond = -6.766431}.dopplerFactor(), 1.0 + 6.766431 / 299792.458, 1e-15);
}

TEST(Observer, SeesWhatItPlaces)
{
    const Observer observer({38.757_deg, -9.117_deg, 80.0});
    const LookAngles seen = observer.look({.position = observer.ground({250_deg, 33_deg}, 1234.5)});
    EXPECT_NEAR(seen.direction.azimuth.degrees(), 250.0, 1e-9);
    EXPECT_NEAR(seen.direction.elevation.degrees(), 33.0, 1e-9);
    EXPECT_NEAR(seen.kilometres, 1234.5, 1e-9);
}

TEST(Observer, AThingAtTheSiteHasNoDirectionAndIsNoNumberLess)
{
    const Observer observer({});
    const LookAngles seen = observer.look({.position = observer.ground({}, 0.0)});
    EXPECT_EQ(seen, LookAngles{});
}
