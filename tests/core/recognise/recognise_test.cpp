// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/recognise/recognise.h"

#include "core/elements/element_reader.h"
#include "core/passes/pass_finder.h"
#include "tests/core/recognise/client_points.h"
#include "tests/fakes/found_orbit.h"
#include "tests/fakes/reference_data.h"

#include <gmock/gmock.h>

#include <algorithm>

namespace boresight::recognise {
namespace {

using fakes::ClientHabit;
using fakes::pointsOf;
using testing::ElementsAre;
using testing::IsEmpty;
using testing::SizeIs;
using testing::UnorderedElementsAre;

const Site kSite{.latitude = 38.757_deg, .longitude = -9.117_deg, .heightMetres = 80.0};
const UtcTime kNow = UtcTime(std::chrono::seconds(1'790'000'000));

std::vector<std::string> namesOf(const Recognition& found)
{
    std::vector<std::string> names;
    for (const targets::Target& target : found.fits) {
        names.push_back(target.name.toStdString());
    }
    return names;
}

SharedSatellites joined(const SharedSatellites& all, const std::vector<orbit::ElementSet>& more)
{
    auto joined = std::make_shared<std::vector<orbit::ElementSet>>(*all);
    joined->insert(joined->end(), more.begin(), more.end());
    return joined;
}

class Recognise : public ::testing::Test
{
protected:
    // A pass that begins in the next two hours, of a satellite among others.
    Recognise()
        : found(fakes::orbitWith(kSite, kNow,
                                 [](const passes::Pass& pass) {
                                     return pass.aos.utc - kNow > std::chrono::minutes(10) && !pass.isUpAtEnd &&
                                            pass.tca.direction.elevation > 40_deg &&
                                            pass.tca.direction.elevation < 80_deg;
                                 })),
          others(fakes::manySatellites(500, kNow)),
          sky{.satellites = joined(others, {found.elements}), .site = kSite}
    {}

    [[nodiscard]] targets::Target target() const { return targets::satelliteTarget(found.elements); }
    // The middle of the rising half of the pass.
    [[nodiscard]] UtcTime halfWay() const { return found.pass.aos.utc + (found.pass.tca.utc - found.pass.aos.utc) / 2; }
    [[nodiscard]] std::vector<std::string> recognised(const SentPoints& points) const
    {
        return namesOf(recognise(points, sky));
    }
    // The same satellite, behind itself by this part of its orbit: 0.1° is 12 km.
    [[nodiscard]] orbit::ElementSet behind(std::int64_t number, const std::string& name, Angle by) const
    {
        orbit::ElementSet other = found.elements;
        other.number = number;
        other.name = name;
        other.meanAnomaly = other.meanAnomaly - by;
        return other;
    }
    [[nodiscard]] SentPoint atRise(UtcTime utc) const
    {
        return {.utc = utc,
                .direction = fakes::rounded({.azimuth = found.pass.aos.direction.azimuth, .elevation = {}}, 0.01_deg)};
    }

    fakes::FoundOrbit found;
    SharedSatellites others;
    Sky sky;
};

// REQ-RECOGNISE-1800: Two to five moving points of a client are enough to find its satellite among all loaded elements:
// sent each second with a wrong clock of ±3 s, in steps of 0.01°, 0.1° or 1°, or by Gpredict with a threshold of 0.1°
// or 5°, which aims ahead.
TEST_F(Recognise, TwoToFivePointsAreEnough)
{
    const std::vector<std::pair<ClientHabit, int>> clients{
        {{}, 5},
        {{.clock = Seconds(3.0)}, 5},
        {{.clock = Seconds(-3.0)}, 5},
        {{.step = 0.1_deg, .period = Seconds(2.0)}, 4},
        {{.step = 1_deg, .period = Seconds(10.0)}, 4},
        {{.ahead = 0.1_deg}, 5},
        {{.ahead = 5_deg}, 2},
        {{.ahead = 5_deg}, 3},
        {{.clock = Seconds(-2.0), .ahead = 5_deg}, 3},
        {{.period = Seconds(20.0)}, 2},
    };
    for (const auto& [habit, count] : clients) {
        for (const UtcTime from : {found.pass.aos.utc + std::chrono::seconds(20), halfWay(), found.pass.tca.utc}) {
            const SentPoints points = pointsOf(target(), kSite, from, count, habit);
            EXPECT_THAT(recognised(points), ElementsAre("TEST ONE"))
                << habit.step.degrees() << "° " << habit.clock.count() << " s, ahead " << habit.ahead.degrees()
                << "°, after rise " << Seconds(from - found.pass.aos.utc).count();
        }
    }
}

// REQ-RECOGNISE-1801: The elements of the client may be older than those of Boresight, so its satellite is beside the
// computed place.
TEST_F(Recognise, OlderElementsFit)
{
    targets::Target older = target();
    auto& elements = std::get<orbit::ElementSet>(older.kind);
    elements.meanAnomaly = elements.meanAnomaly - 0.1_deg;
    elements.ascendingNode = elements.ascendingNode + 0.03_deg;
    EXPECT_THAT(recognised(pointsOf(older, kSite, halfWay(), 5)), ElementsAre("TEST ONE"));
}

// REQ-RECOGNISE-1802: A client that waits for the rise sends the same point at the horizon, or only one point.
// Boresight recognises the satellite that rises there within the next half hour.
TEST_F(Recognise, TheSatelliteThatRisesAtThisPoint)
{
    const UtcTime before = found.pass.aos.utc - std::chrono::minutes(4);
    Sky few = sky;
    few.satellites = joined(fakes::manySatellites(50, kNow), {found.elements});
    EXPECT_THAT(namesOf(recognise({atRise(before)}, few)), ElementsAre("TEST ONE"));
    EXPECT_THAT(namesOf(recognise({atRise(before), atRise(before + std::chrono::seconds(5))}, few)),
                ElementsAre("TEST ONE"));
    SentPoint elsewhere = atRise(before);
    elsewhere.direction.azimuth = elsewhere.direction.azimuth + 1_deg;
    EXPECT_THAT(namesOf(recognise({elsewhere}, few)), IsEmpty());
    few.satellites = std::make_shared<std::vector<orbit::ElementSet>>(1, found.elements);
    EXPECT_THAT(namesOf(recognise({atRise(found.pass.aos.utc - std::chrono::minutes(40))}, few)), IsEmpty());
}

// REQ-RECOGNISE-1803: Sun, Moon, planets and radio sources are recognised, too.
TEST_F(Recognise, SunMoonPlanetsAndRadioSources)
{
    int seen = 0;
    for (const targets::Target& body : targets::objectTargets()) {
        targets::TargetPath path(body, kSite);
        for (int hour = 0; hour < 24; hour += 3) {
            const UtcTime from = kNow + std::chrono::hours(hour);
            if (path.at(from).value().elevation > 10_deg) {
                const auto points = pointsOf(body, kSite, from, 4, {.period = Seconds(60.0)});
                EXPECT_THAT(recognised(points), ElementsAre(body.name.toStdString())) << hour;
                ++seen;
                break;
            }
        }
    }
    EXPECT_GE(seen, 8);
}

// REQ-RECOGNISE-1804: If the points fit several satellites alike, all of them are reported. Satellites that are at the
// same place through the whole pass, as docked ones, count as one: the one with the smallest number.
TEST_F(Recognise, AmbiguityIsReported)
{
    const SentPoints points = pointsOf(target(), kSite, halfWay(), 5);
    sky.satellites = joined(others, {found.elements, behind(90'001, "TEST TWO", 0.13_deg)});  // 2 s
    EXPECT_THAT(recognised(points), ElementsAre("TEST ONE", "TEST TWO"));

    sky.satellites = joined(others, {behind(90'002, "DOCKED", {}), found.elements});
    const Recognition one = recognise(points, sky);
    EXPECT_THAT(namesOf(one), ElementsAre("TEST ONE"));
    EXPECT_THAT(one.together, ElementsAre(QStringLiteral("DOCKED")));
}

// A neighbour 0.4° away is another satellite, although the clock of the client may explain this. Its smaller number
// decides nothing.
TEST_F(Recognise, ANeighbourIsNoDockedShip)
{
    sky.satellites = joined(others, {found.elements, behind(11, "NEIGHBOUR", 0.03_deg)});
    EXPECT_THAT(recognised(pointsOf(target(), kSite, halfWay(), 5)), UnorderedElementsAre("TEST ONE", "NEIGHBOUR"));
}

// A train of satellites rises at one place of the horizon, one after the other.
TEST_F(Recognise, ATrainBeforeItsRiseIsAmbiguous)
{
    std::vector<orbit::ElementSet> train{found.elements};
    for (int i = 1; i < 20; ++i) {
        train.push_back(behind(90'000 + i, "TRAIN " + std::to_string(i), i * 0.03_deg));
    }
    sky.satellites = std::make_shared<std::vector<orbit::ElementSet>>(train);
    const Recognition all = recognise({atRise(found.pass.aos.utc - std::chrono::minutes(14))}, sky);
    EXPECT_THAT(all.fits, SizeIs(20));
    EXPECT_THAT(all.together, IsEmpty());

    sky.satellites =
        std::make_shared<std::vector<orbit::ElementSet>>(std::vector{found.elements, behind(90'002, "DOCKED", {})});
    const Recognition one = recognise({atRise(found.pass.aos.utc - std::chrono::minutes(14))}, sky);
    EXPECT_THAT(namesOf(one), ElementsAre("TEST ONE"));
    EXPECT_THAT(one.together, ElementsAre(QStringLiteral("DOCKED")));
}

// REQ-RECOGNISE-1806: The result says how far ahead of its target the client aims, and whether its points show a
// motion along the target.
TEST_F(Recognise, TheLeadOfTheClientIsMeasured)
{
    const Recognition exact = recognise(pointsOf(target(), kSite, halfWay(), 5), sky);
    EXPECT_TRUE(exact.isMoving);
    EXPECT_LT(exact.lead, 0.05_deg);
    for (const Angle ahead : {0.1_deg, 2_deg, 5_deg}) {
        const Recognition led = recognise(pointsOf(target(), kSite, halfWay(), 4, {.ahead = ahead}), sky);
        EXPECT_TRUE(led.isMoving);
        EXPECT_NEAR(led.lead.degrees(), ahead.degrees(), 0.1) << ahead.degrees();
    }
    Sky one = sky;
    one.satellites = std::make_shared<std::vector<orbit::ElementSet>>(1, found.elements);
    const Recognition waits = recognise({atRise(found.pass.aos.utc - std::chrono::minutes(4))}, one);
    EXPECT_THAT(waits.fits, SizeIs(1));
    EXPECT_FALSE(waits.isMoving);
}

// REQ-RECOGNISE-1805: Nothing is recognised in points that no loaded target fits: a fixed direction, a satellite
// without elements, elements that are too old, a point in the middle of the sky.
TEST_F(Recognise, NothingFits)
{
    const SentPoints points = pointsOf(target(), kSite, halfWay(), 5);
    sky.satellites = others;
    EXPECT_THAT(recognised(points), IsEmpty());
    orbit::ElementSet old = found.elements;
    old.epoch = orbit::julianDate(kNow - std::chrono::days(31));
    sky.satellites = joined(others, {old});
    EXPECT_THAT(recognised(points), IsEmpty());
    sky.satellites = joined(others, {found.elements});
    EXPECT_THAT(recognised({points.front()}), IsEmpty());
    EXPECT_THAT(recognised({}), IsEmpty());
    const SentPoint fixed{.utc = kNow, .direction = {.azimuth = 120_deg, .elevation = 30_deg}};
    EXPECT_THAT(recognised({fixed, {.utc = kNow + std::chrono::seconds(60), .direction = fixed.direction}}), IsEmpty());
}

// A client that moves along the same line, but faster or slower, does not track the satellite.
TEST_F(Recognise, TheRateCounts)
{
    SentPoints points = pointsOf(target(), kSite, halfWay(), 5, {.period = Seconds(3.0)});
    for (std::size_t i = 0; i < points.size(); ++i) {
        points[i].utc = points.front().utc + std::chrono::seconds(6 * i);
    }
    EXPECT_THAT(recognised(points), IsEmpty());
}

SkyPointing seenAt(const targets::Target& target, UtcTime utc)
{
    return targets::TargetPath(target, kSite).at(utc).value();
}

bool isOfChineseStation(const orbit::ElementSet& set)
{
    return set.name.starts_with("CSS") || set.name.starts_with("TIANZHOU") || set.name.starts_with("SHENZHOU");
}

// Real elements: the ISS and its docked ships are one target, and each other satellite is recognised by itself. The
// elements of the Chinese station and of its ships are of different days, and 0.1° to 0.8° apart. Such ships are
// ambiguous.
TEST(RecogniseReference, StationsAndSatellites)
{
    if (!fakes::hasReference("omm_stations_2024-05-09.tle") || !fakes::hasReference("tle_sats.txt")) {
        GTEST_SKIP() << "the element files are not here";
    }
    auto sets = orbit::readElements(fakes::referenceText("omm_stations_2024-05-09.tle")).sets;
    const auto more = orbit::readElements(fakes::referenceText("tle_sats.txt")).sets;
    std::ranges::copy_if(more, std::back_inserter(sets), [&](const orbit::ElementSet& set) {
        return std::ranges::find(sets, set.number, &orbit::ElementSet::number) == sets.end();
    });
    const auto all = std::make_shared<std::vector<orbit::ElementSet>>(sets);
    const UtcTime now = orbit::utcTime(sets.front().epoch) + std::chrono::hours(12);
    int recognised = 0;
    for (const orbit::ElementSet& set : sets) {
        const auto list = passes::findPasses(
            orbit::Sgp4(set), {.site = kSite, .from = now, .to = now + std::chrono::hours(24), .isClear = {}});
        if (list.passes.empty() || list.passes.front().isUpAtEnd ||
            std::abs(orbit::minutesBetween(set.epoch, orbit::julianDate(now))) > 20 * orbit::kMinutesPerDay) {
            continue;
        }
        const passes::Pass& pass = list.passes.front();
        for (const ClientHabit& habit : {ClientHabit{.period = Seconds(2.0)}, ClientHabit{.ahead = 5_deg}}) {
            const UtcTime from = pass.aos.utc + (pass.tca.utc - pass.aos.utc) / 2;
            const Recognition found = recognise(pointsOf(targets::satelliteTarget(set), kSite, from, 4, habit),
                                                {.satellites = all, .site = kSite});
            ASSERT_THAT(found.fits, SizeIs(testing::Ge(1))) << set.name;
            const bool isIt =
                found.together.contains(targets::satelliteName(set)) ||
                std::ranges::find(found.fits, targets::satelliteName(set), &targets::Target::name) != found.fits.end();
            EXPECT_TRUE(isIt) << set.name << " is not " << found.fits.front().name.toStdString();
            for (const targets::Target& fit : found.fits) {
                EXPECT_LT(angleBetween(seenAt(fit, from), seenAt(targets::satelliteTarget(set), from)), 0.8_deg)
                    << set.name << " or " << fit.name.toStdString();
            }
            if (found.fits.size() > 1) {
                EXPECT_TRUE(isOfChineseStation(set)) << set.name;
            }
            ++recognised;
        }
    }
    EXPECT_GT(recognised, 10);
}

}  // namespace
}  // namespace boresight::recognise
