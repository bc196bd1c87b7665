// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/targets/target_path.h"

#include "core/base/numbers.h"
#include "core/elements/iso_epoch.h"
#include "core/ephemeris/refraction.h"
#include "core/passes/pass_finder.h"
#include "core/tables/table_reader.h"
#include "core/units/angle_between.h"
#include "tests/fakes/low_orbit.h"
#include "tests/fakes/text_of.h"

#include <gtest/gtest.h>

#include <array>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

namespace boresight::targets {
namespace {

using ephemeris::Refraction;

const Site kLisbon{.latitude = 38.757_deg, .longitude = -9.117_deg, .heightMetres = 80.0};
const Site kSvalbard{.latitude = 78.23_deg, .longitude = 15.39_deg, .heightMetres = 450.0};
const UtcTime kDay = std::chrono::sys_days(std::chrono::year(2026) / 12 / 24);

Target object(std::string_view key)
{
    return {.name = QString::fromStdString(std::string(key)), .kind = ephemeris::skyObject(key).value()};
}

Target position(const Site& site, GreatCircle path = GreatCircle::Short)
{
    return {.name = QStringLiteral("here"), .kind = EarthPosition{.site = site, .path = path}};
}

SkyPointing directionAt(const Target& target, const Site& site, UtcTime utc = kDay)
{
    return TargetPath(target, site).at(utc).value();
}

// REQ-TARGETS-900: Sun, Moon, planets and radio sources agree with the reference table for Lisbon to 1.5′, with
// refraction: optical for the bodies, radio for the radio sources.
TEST(TargetPath, MeetsTheTableOfPlanetsAndRadioSources)
{
    std::ifstream file(BORESIGHT_TEST_DATA "/planets_azel.csv");
    int rows = 0;
    for (std::string line; std::getline(file, line);) {
        if (!line.starts_with("Lisbon")) {
            continue;
        }
        std::vector<std::string> fields(6);
        std::istringstream stream(line);
        for (std::string& field : fields) {
            std::getline(stream, field, ',');
        }
        const UtcTime utc = orbit::utcTime(orbit::parseIsoEpoch(fields[2].substr(0, 19)).value());
        const SkyPointing airless{.azimuth = Angle::fromDegrees(parseFinite(fields[3]).value()),
                                  .elevation = Angle::fromDegrees(parseFinite(fields[4]).value())};
        const Refraction air = fields[1].ends_with("-a") ? Refraction::Radio : Refraction::Light;
        const SkyPointing seen = directionAt(object(fields[1]), kLisbon, utc);
        EXPECT_LT(angleBetween(seen, ephemeris::apparent(airless, air)).degrees(), 1.5 / 60.0) << line;
        ++rows;
    }
    EXPECT_EQ(rows, 14 * 12);
}

// The worked example of Reda and Andreas, NREL/TP-560-34302 (2008), table A5.1, plus Sæmundsson's refraction of 1.21′
// there.
// REQ-TARGETS-901: The Sun agrees with a published example, raised by refraction.
TEST(TargetPath, MeetsThePublishedExampleOfTheSun)
{
    const Site golden{.latitude = 39.742476_deg, .longitude = -105.1786_deg, .heightMetres = 1830.14};
    const UtcTime utc = std::chrono::sys_days(std::chrono::year(2003) / 10 / 17) + std::chrono::hours(19) +
                        std::chrono::minutes(30) + std::chrono::seconds(30);
    const SkyPointing sun = directionAt(object("sun"), golden, utc);
    EXPECT_NEAR(sun.azimuth.degrees(), 194.34024, 0.001);
    EXPECT_NEAR(sun.elevation.degrees(), 39.872046 + 1.21 / 60.0, 0.001);
}

// Flinders Peak to Buninyong, from the manual of the Geocentric Datum of Australia: 306°52′05.37″. New York to London,
// the example of GeographicLib's GeodSolve: 51.1989° on the shortest path. Another program computed the others.
// REQ-TARGETS-902: The direction to a place on the Earth, and its elevation, are those of WGS-84. For a place below the
// horizon the beam points along the horizon on the bearing. The long path is the opposite bearing.
TEST(TargetPath, PointsToPositionsOnAndAboveTheEarth)
{
    const Site flinders{.latitude = -37.951033416667_deg, .longitude = 144.424867888889_deg};
    const Site buninyong{.latitude = -37.652821138889_deg, .longitude = 143.926495527778_deg};
    const SkyPointing peak = directionAt(position(buninyong), flinders);
    EXPECT_NEAR(peak.azimuth.degrees(), 306.0 + 52.0 / 60.0 + 5.37 / 3600.0, 1e-4);
    EXPECT_EQ(peak.elevation, 0_deg);

    const Site newYork{.latitude = 40.6_deg, .longitude = -73.8_deg};
    const Site london{.latitude = 51.6_deg, .longitude = -0.5_deg};
    EXPECT_NEAR(directionAt(position(london), newYork).azimuth.degrees(), 51.1989, 0.02);
    const SkyPointing round = directionAt(position(london, GreatCircle::Long), newYork);
    EXPECT_NEAR(round.azimuth.degrees(), 231.1989, 0.02);
    EXPECT_EQ(round.elevation, 0_deg);

    const SkyPointing above = directionAt(position({0_deg, 25.9_deg, 35'786'000.0}), kLisbon);
    EXPECT_NEAR(above.azimuth.degrees(), 131.752752, 1e-4);
    EXPECT_NEAR(above.elevation.degrees(), 32.370605, 1e-4);
    const SkyPointing plane = directionAt(position({39.3_deg, -8.5_deg, 11'000.0}), kLisbon);
    EXPECT_NEAR(plane.azimuth.degrees(), 41.356151, 1e-4);
    EXPECT_NEAR(plane.elevation.degrees(), 7.351561, 1e-4);
}

// REQ-TARGETS-903: The mount's own place has no direction, and the reason says so.
TEST(TargetPath, HasNoDirectionToItsOwnPlace)
{
    const auto here = TargetPath(position(kLisbon), kLisbon).nextUp(kDay);
    ASSERT_FALSE(here);
    EXPECT_EQ(textOf(here.error()), "here is the site of the mount, so it has no direction.");
}

// REQ-TARGETS-904: A body rises and sets when it appears at the horizon, to 2 s. A body that is up rises now. A body
// that never sets has no set. A body that never rises is refused with the reason.
TEST(TargetPath, RisesAndSetsAtTheHorizonAsItAppears)
{
    for (const char* const key : {"sun", "moon", "jupiter", "tau-a"}) {
        TargetPath path(object(key), kLisbon);
        const UtcTime later = path.nextUp(kDay).value().sets.value() + std::chrono::minutes(1);
        const UpTime up = path.nextUp(later).value();
        ASSERT_GT(up.rises, later) << key;
        ASSERT_TRUE(up.sets) << key;
        EXPECT_NEAR(path.at(up.rises).value().elevation.degrees(), 0.0, 0.008) << key;
        EXPECT_NEAR(path.at(*up.sets).value().elevation.degrees(), 0.0, 0.008) << key;
        const UtcTime middle = up.rises + (*up.sets - up.rises) / 2;
        EXPECT_GT(path.at(middle).value().elevation, 5_deg) << key;
        EXPECT_EQ(path.nextUp(middle).value().rises, middle) << key;
        EXPECT_EQ(path.nextUp(middle).value().sets.has_value(), true) << key;
    }
    EXPECT_EQ(TargetPath(object("cas-a"), kLisbon).nextUp(kDay).value(), UpTime{.rises = kDay});
    const auto never = TargetPath(object("sgr-a"), kSvalbard).nextUp(kDay);
    ASSERT_FALSE(never);
    EXPECT_EQ(textOf(never.error()), "sgr-a does not rise within a day.");
}

// REQ-TARGETS-905: A satellite is tracked without refraction, and rises and sets as in the list of passes.
TEST(TargetPath, ASatelliteGoesAsTheListOfPasses)
{
    const orbit::ElementSet elements = fakes::lowOrbit(kDay);
    TargetPath path(satelliteTarget(elements), kLisbon);
    const auto passes = passes::findPasses(
        orbit::Sgp4(elements), {.site = kLisbon, .from = kDay, .to = kDay + std::chrono::days(1), .isClear = {}});
    ASSERT_FALSE(passes.passes.empty());
    const passes::Pass& first = passes.passes.front();
    EXPECT_EQ(path.nextUp(kDay).value(), (UpTime{.rises = first.aos.utc, .sets = first.los.utc}));
    EXPECT_LT(angleBetween(path.at(first.tca.utc).value(), first.tca.direction).degrees(), 1e-6);
}

// Again the example of Reda and Andreas, and Sæmundsson's 29.0′ at 0° and 5.4′ at 10° (Meeus, 16.4). For radio waves:
// the refractivity of ITU-R P.453 is 1.0843 times that of light at 1010 hPa, 10 °C and half the moisture.
// REQ-TARGETS-920: A refraction rule of the profile applies to satellites and bodies alike: off, optical or radio. The
// rule "by kind" keeps the refraction of each kind. Under each rule a satellite rises and sets by geometry. Fixed
// targets are never refracted.
TEST(TargetPath, ARuleBendsAllAlike)
{
    using ephemeris::RefractionRule;
    const Site golden{.latitude = 39.742476_deg, .longitude = -105.1786_deg, .heightMetres = 1830.14};
    const UtcTime utc = std::chrono::sys_days(std::chrono::year(2003) / 10 / 17) + std::chrono::hours(19) +
                        std::chrono::minutes(30) + std::chrono::seconds(30);
    const auto sunBy = [&](RefractionRule rule) {
        return TargetPath(object("sun"), golden, rule).at(utc).value().elevation.degrees();
    };
    EXPECT_NEAR(sunBy(RefractionRule::None), 39.872046, 0.001);
    EXPECT_EQ(sunBy(RefractionRule::Light), sunBy(RefractionRule::ByKind));
    EXPECT_NEAR((sunBy(RefractionRule::Radio) - sunBy(RefractionRule::None)) * 60.0, 1.21 * 1.0843, 0.01);

    const Target satellite = satelliteTarget(fakes::lowOrbit(kDay));
    TargetPath path(satellite, kLisbon);
    const UpTime up = path.nextUp(kDay).value();
    const auto bentAt = [&](UtcTime when, RefractionRule rule) {
        path.setRule(RefractionRule::None);
        const SkyPointing airless = path.at(when).value();
        path.setRule(rule);
        EXPECT_EQ(path.nextUp(kDay).value(), up);
        EXPECT_EQ(path.at(when).value().azimuth, airless.azimuth);
        return (path.at(when).value().elevation - airless.elevation).degrees() * 60.0;
    };
    EXPECT_EQ(bentAt(up.rises, RefractionRule::ByKind), 0.0);
    EXPECT_NEAR(bentAt(up.rises, RefractionRule::Light), 29.0, 0.1);
    EXPECT_NEAR(bentAt(*up.sets, RefractionRule::Radio), 29.0 * 1.0843, 0.1);
    const SkyPointing ten{.azimuth = 0_deg, .elevation = 10_deg};
    EXPECT_NEAR((satelliteSeen(ten, RefractionRule::Light).elevation - 10_deg).degrees() * 60.0, 5.4, 0.1);

    for (const RefractionRule rule : {RefractionRule::None, RefractionRule::Light, RefractionRule::Radio}) {
        const SkyPointing low{.azimuth = 270_deg, .elevation = 1_deg};
        EXPECT_EQ(TargetPath({.name = {}, .kind = low}, kLisbon, rule).at(kDay).value(), low);
        const Target plane = position({39.3_deg, -8.5_deg, 11'000.0});
        EXPECT_EQ(TargetPath(plane, kLisbon, rule).at(kDay), TargetPath(plane, kLisbon).at(kDay));
        EXPECT_EQ(TargetPath(satellite, kLisbon, rule).nextUp(kDay), Result<UpTime>(up));
    }
}

// REQ-TARGETS-908: A body rises at the horizon by the refraction rule: without refraction some minutes later.
TEST(TargetPath, WithoutAirABodyRisesByGeometry)
{
    using ephemeris::RefractionRule;
    const UtcTime seen = TargetPath(object("sun"), kLisbon).nextUp(kDay).value().rises;
    TargetPath path(object("sun"), kLisbon, RefractionRule::None);
    const UtcTime geometric = path.nextUp(kDay).value().rises;
    EXPECT_NEAR(path.at(geometric).value().elevation.degrees(), 0.0, 0.008);
    EXPECT_GT(geometric - seen, std::chrono::minutes(2));
    EXPECT_LT(geometric - seen, std::chrono::minutes(4));
    EXPECT_EQ(path.refractionOfRise(), ephemeris::Refraction::None);
    EXPECT_EQ(TargetPath(object("moon"), kLisbon).refractionOfRise(), ephemeris::Refraction::Light);
    EXPECT_EQ(TargetPath(object("cas-a"), kLisbon).refractionOfRise(), ephemeris::Refraction::Radio);
    const Target west{.name = {}, .kind = SkyPointing{.azimuth = 270_deg, .elevation = 12_deg}};
    EXPECT_EQ(TargetPath(west, kLisbon).refractionOfRise(), ephemeris::Refraction::None);
}

// REQ-TARGETS-906: A fixed direction does not change, and is always up.
TEST(TargetPath, ADirectionStays)
{
    const SkyPointing west{.azimuth = 270_deg, .elevation = 12_deg};
    TargetPath path({.name = QStringLiteral("west"), .kind = west}, kLisbon);
    EXPECT_EQ(path.at(kDay).value(), west);
    EXPECT_EQ(path.at(kDay + std::chrono::hours(9)).value(), west);
    EXPECT_EQ(path.nextUp(kDay).value(), UpTime{.rises = kDay});
}

// REQ-TARGETS-907: A table is up while its direction is above the horizon, at most from its first row to its last.
TEST(TargetPath, ATableRisesAndSets)
{
    const auto table =
        tables::readTable("2026-12-24T01:00:00Z,100,-10\n2026-12-24T01:10:00Z,100,10\n2026-12-24T01:20:00Z,120,20\n",
                          QStringLiteral("/tmp/pass.csv"));
    const Target target = tableTarget(table.value());
    EXPECT_EQ(target.name, QStringLiteral("pass.csv"));
    EXPECT_FALSE(needsSite(target));
    TargetPath path(target, kLisbon);
    const UpTime up = path.nextUp(kDay).value();
    EXPECT_LT(std::chrono::abs(up.rises - (kDay + std::chrono::minutes(65))), std::chrono::milliseconds(2));
    EXPECT_EQ(up.sets, kDay + std::chrono::minutes(80));
    EXPECT_LT(angleBetween(path.at(*up.sets).value(), {120_deg, 20_deg}).degrees(), 1e-9);
    EXPECT_EQ(path.at(kDay).error().code, ErrorCode::NotAvailable);
    EXPECT_EQ(path.nextUp(kDay + std::chrono::hours(2)).error().code, ErrorCode::Refused);
}

}  // namespace
}  // namespace boresight::targets
