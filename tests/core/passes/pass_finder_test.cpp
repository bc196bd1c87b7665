// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/passes/pass_finder.h"

#include "core/elements/iso_epoch.h"
#include "core/orbit/topocentric.h"
#include "core/passes/pass_scan.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <random>
#include <vector>

using namespace boresight;
using namespace boresight::passes;
using namespace std::chrono_literals;
using testing::ElementsAre;
using testing::Gt;
using testing::IsEmpty;
using testing::SizeIs;

namespace {

UtcTime utcOf(const char* text)
{
    return orbit::utcTime(orbit::parseIsoEpoch(text).value());
}

const UtcTime kStart = utcOf("2024-05-10T00:00:00");
const Site kLisbon{38.757_deg, -9.117_deg, 80.0};
const Site kSvalbard{78.23_deg, 15.39_deg, 450.0};

orbit::ElementSet circle(double revolutionsPerDay, Angle inclination)
{
    return {.epoch = orbit::julianDate(kStart - 12h),
            .revolutionsPerDay = revolutionsPerDay,
            .eccentricity = 1e-4,
            .inclination = inclination,
            .ascendingNode = 147.859_deg,
            .perigee = 150.467_deg,
            .meanAnomaly = 209.533_deg,
            .bstar = 1e-5};
}

orbit::ElementSet ellipse(double revolutionsPerDay, double eccentricity)
{
    orbit::ElementSet set = circle(revolutionsPerDay, 63.4_deg);
    set.eccentricity = eccentricity;
    set.perigee = 270_deg;
    return set;
}

PassSearch days(const Site& site, int count)
{
    return {.site = site, .from = kStart, .to = kStart + std::chrono::days(count)};
}

// The elevation, computed in the simplest way.
Angle elevationAt(const orbit::ElementSet& set, const Site& site, UtcTime utc)
{
    const auto date = orbit::julianDate(utc);
    return orbit::Observer(site).look(groundState(*orbit::Sgp4(set).propagate(date), date)).direction.elevation;
}

// The moments when the satellite rises or sets, in steps of 10 s.
std::vector<UtcTime> changesOnAGrid(const orbit::Sgp4& orbit, const PassSearch& search)
{
    std::vector<UtcTime> changes;
    const orbit::Observer observer(search.site);
    bool wasUp = false;
    for (UtcTime now = search.from; now <= search.to; now += 10s) {
        const auto date = orbit::julianDate(now);
        const auto state = orbit.propagate(date);
        const bool isUp =
            state && observer.look(groundState(*state, date)).direction.elevation > search.minimumElevation;
        if (isUp != wasUp) {
            changes.push_back(now);
        }
        wasUp = isUp;
    }
    return changes;
}

bool hasEdgeBefore(const PassList& list, UtcTime change)
{
    return std::ranges::any_of(list.passes, [&](const Pass& pass) {
        const auto isIt = [&](UtcTime edge) { return edge <= change && edge > change - 10s - 1ms; };
        return isIt(pass.aos.utc) || isIt(pass.los.utc);
    });
}

}  // namespace

// REQ-PASSES-02: A satellite that never rises has no pass. One that is always up has one pass, from the beginning to
// the end of the search.
TEST(PassFinder, KnowsNeverAndAlways)
{
    const orbit::Sgp4 equatorial(circle(15.5, 0.1_deg));
    EXPECT_EQ(findPasses(equatorial, days(kSvalbard, 3)), PassList());
    orbit::ElementSet still = circle(1.00272844, 0.02_deg);
    still.meanAnomaly = 70_deg;  // over the east of Africa
    const PassList always = findPasses(orbit::Sgp4(still), days({0_deg, 40_deg, 0.0}, 3));
    ASSERT_THAT(always.passes, SizeIs(1));
    EXPECT_TRUE(always.passes[0].isUpAtStart);
    EXPECT_TRUE(always.passes[0].isUpAtEnd);
    EXPECT_EQ(always.passes[0].duration(), Seconds(3 * 86400.0));
    EXPECT_GT(always.passes[0].maxima, 1) << "one in a day at least";
}

// REQ-PASSES-03: A pass that is under way at the beginning or end of the search is cut there, and is marked as cut.
TEST(PassFinder, CutsAPassAtTheEndsOfTheSpan)
{
    const orbit::Sgp4 orbit(circle(15.5, 51.6_deg));
    const Pass whole = findPasses(orbit, days(kLisbon, 1)).passes.at(1);
    EXPECT_FALSE(whole.isUpAtStart || whole.isUpAtEnd);
    PassSearch late = days(kLisbon, 1);
    late.from = whole.aos.utc + 30s;
    const Pass rest = findPasses(orbit, late).passes.at(0);
    EXPECT_TRUE(rest.isUpAtStart);
    EXPECT_EQ(rest.aos.utc, late.from);
    EXPECT_NEAR(Seconds(rest.tca.utc - whole.tca.utc).count(), 0.0, 2e-3);
    EXPECT_NEAR(Seconds(rest.los.utc - whole.los.utc).count(), 0.0, 1e-3);
    PassSearch early = days(kLisbon, 1);
    early.to = whole.aos.utc + 30s;
    const Pass begin = findPasses(orbit, early).passes.back();
    EXPECT_TRUE(begin.isUpAtEnd);
    EXPECT_EQ(begin.los.utc, early.to);
    EXPECT_EQ(begin.tca, begin.los) << "it is highest there";
}

TEST(PassFinder, FindsNothingInASpanThatIsNone)
{
    const orbit::Sgp4 orbit(circle(15.5, 51.6_deg));
    EXPECT_EQ(findPasses(orbit, days(kLisbon, 0)), PassList());
    EXPECT_EQ(findPasses(orbit, days(kLisbon, -3)), PassList());
}

// REQ-PASSES-04: No pass is missed and none is invented, for low, high, flat, polar and equatorial orbits, sites from
// pole to equator, and minimum elevations below and above 0°.
TEST(PassFinder, FindsWhatAFineGridFinds)
{
    std::mt19937 random(1);
    const auto draw = [&random](double from, double to) {
        return std::uniform_real_distribution<double>(from, to)(random);
    };
    for (int i = 0; i < 60; ++i) {
        orbit::ElementSet set = i % 5 == 0   ? ellipse(draw(1.9, 2.4), draw(0.5, 0.7))
                                : i % 7 == 0 ? circle(draw(0.9, 8.0), Angle::fromDegrees(draw(0.0, 90.0)))
                                             : circle(draw(11.0, 15.8), Angle::fromDegrees(draw(0.0, 180.0)));
        set.meanAnomaly = Angle::fromDegrees(draw(0.0, 360.0));
        PassSearch search = days({Angle::fromDegrees(draw(-90.0, 90.0)), Angle::fromDegrees(draw(-180.0, 180.0))}, 1);
        search.minimumElevation = Angle::fromDegrees(i % 3 == 0 ? draw(-10.0, 30.0) : 0.0);
        const orbit::Sgp4 orbit(set);
        const PassList found = findPasses(orbit, search);
        std::size_t edges = 0;
        for (const Pass& pass : found.passes) {
            edges += pass.duration() > 10s ? (pass.isUpAtEnd ? 1U : 2U) : 0U;
            EXPECT_GT(pass.tca.direction.elevation, search.minimumElevation) << i;
        }
        const auto changes = changesOnAGrid(orbit, search);
        EXPECT_GE(changes.size(), edges) << i;
        for (const UtcTime change : changes) {
            EXPECT_TRUE(hasEdgeBefore(found, change)) << i;
        }
    }
}

// REQ-PASSES-05: A pass that only just reaches the minimum elevation is found, however short it is.
TEST(PassFinder, FindsAPassThatGrazes)
{
    const orbit::ElementSet set = circle(15.5, 51.6_deg);
    const PassMoment top = findPasses(orbit::Sgp4(set), days(kLisbon, 1)).passes.at(1).tca;
    PassSearch search = days(kLisbon, 1);
    search.from = top.utc - 1h;
    search.to = top.utc + 1h;
    for (const double below : {1e-3, 1e-6, 1e-8}) {
        search.minimumElevation = top.direction.elevation - Angle::fromDegrees(below);
        const auto passes = findPasses(orbit::Sgp4(set), search).passes;
        ASSERT_THAT(passes, SizeIs(1)) << below;
        EXPECT_NEAR(Seconds(passes[0].tca.utc - top.utc).count(), 0.0, 2e-3);
        EXPECT_LT(passes[0].duration(), 5s) << below;
        for (const PassMoment& edge : {passes[0].aos, passes[0].los}) {
            EXPECT_NEAR(elevationAt(set, kLisbon, edge.utc).degrees(), search.minimumElevation.degrees(), 1e-5);
        }
    }
    search.minimumElevation = top.direction.elevation + Angle::fromDegrees(1e-6);
    EXPECT_THAT(findPasses(orbit::Sgp4(set), search).passes, IsEmpty());
}

// REQ-PASSES-06: A pass with several maxima is one pass. Its TCA is the highest of them.
TEST(PassFinder, TakesTheHighestOfSeveralMaxima)
{
    bool isMet = false;
    for (int node = 0; node < 360; node += 15) {
        orbit::ElementSet set = ellipse(2.006, 0.72);
        set.ascendingNode = Angle::fromDegrees(node);
        for (const Pass& pass : findPasses(orbit::Sgp4(set), days(kLisbon, 2)).passes) {
            isMet = isMet || pass.maxima > 1;
            for (UtcTime at = pass.aos.utc; at < pass.los.utc; at += 60s) {
                ASSERT_LE(elevationAt(set, kLisbon, at), pass.tca.direction.elevation + Angle::fromDegrees(1e-6));
            }
        }
    }
    EXPECT_TRUE(isMet);
}

// REQ-PASSES-07: If the satellite decays the search ends, with the moment and the reason. A pass at that moment is cut
// there.
TEST(PassFinder, EndsWhereTheOrbitEnds)
{
    orbit::ElementSet set = circle(16.0, 51.6_deg);
    set.bstar = 0.005;
    const orbit::Sgp4 orbit(set);
    const PassList found = findPasses(orbit, days(kLisbon, 30));
    ASSERT_TRUE(found.end);
    EXPECT_TRUE(orbit.propagate(orbit::julianDate(found.end->utc - 10ms)));
    EXPECT_EQ(orbit.propagate(orbit::julianDate(found.end->utc + 10ms)), tl::unexpected(found.end->fault));
    EXPECT_THAT(found.passes, SizeIs(Gt(3U)));
    EXPECT_LE(found.passes.back().los.utc, found.end->utc);
    PassSearch afterwards = days(kLisbon, 31);
    afterwards.from = found.end->utc + 1s;
    const PassList none = findPasses(orbit, afterwards);
    EXPECT_THAT(none.passes, IsEmpty());
    ASSERT_TRUE(none.end);
    EXPECT_EQ(none.end->utc, afterwards.from);
}

// REQ-PASSES-08: A site at the pole sees a polar orbit on each revolution.
TEST(PassFinder, SeesEachTurnFromThePole)
{
    const auto passes = findPasses(orbit::Sgp4(circle(14.1, 98.7_deg)), days({90_deg, 0_deg, 0.0}, 1)).passes;
    EXPECT_THAT(passes.size(), testing::AllOf(testing::Ge(14U), testing::Le(15U)));
}

// REQ-PASSES-09: The parts of a pass in which the antenna sees the sky are found to 1 ms: several rises, or none.
TEST(PassFinder, FindsWhatAMaskLeavesOfAPass)
{
    const orbit::ElementSet set = circle(15.5, 51.6_deg);
    PassSearch search = days(kLisbon, 1);
    const Pass open = findPasses(orbit::Sgp4(set), search).passes.at(1);
    EXPECT_THAT(open.clear, IsEmpty()) << "nobody asked";

    search.isClear = [](const SkyPointing&) { return true; };
    EXPECT_THAT(findPasses(orbit::Sgp4(set), search).passes.at(1).clear,
                ElementsAre(Stretch{open.aos.utc, open.los.utc}));
    search.isClear = [](const SkyPointing&) { return false; };
    EXPECT_THAT(findPasses(orbit::Sgp4(set), search).passes.at(1).clear, IsEmpty());

    // A tower 2° wide in front of the highest point, and a wall of 5° all around.
    const Angle tower = open.tca.direction.azimuth;
    search.isClear = [tower](const SkyPointing& direction) {
        return direction.elevation > 5_deg && abs((direction.azimuth - tower).wrapped180()) > 1_deg;
    };
    const Pass hidden = findPasses(orbit::Sgp4(set), search).passes.at(1);
    EXPECT_EQ(hidden.aos, open.aos) << "AOS and LOS are those of the minimum elevation";
    ASSERT_THAT(hidden.clear, SizeIs(2));
    EXPECT_NEAR(elevationAt(set, kLisbon, hidden.clear[0].from).degrees(), 5.0, 1e-3);
    EXPECT_NEAR(elevationAt(set, kLisbon, hidden.clear[1].to).degrees(), 5.0, 1e-3);
    EXPECT_LT(hidden.clear[0].to, open.tca.utc);
    EXPECT_GT(hidden.clear[1].from, open.tca.utc);
}

// REQ-PASSES-10: A search for many satellites reports its progress, and ends soon when it is stopped.
TEST(PassFinder, ReportsItsProgressAndCanBeStopped)
{
    const std::vector<SatelliteSearch> searches(5, {orbit::Sgp4(circle(15.5, 51.6_deg)), days(kLisbon, 1)});
    std::vector<std::size_t> progress;
    const auto all = findPasses(searches, {}, [&](std::size_t finished) { progress.push_back(finished); });
    EXPECT_THAT(all, SizeIs(5));
    EXPECT_THAT(progress, ElementsAre(1, 2, 3, 4, 5));
    EXPECT_EQ(all[4], findPasses(searches[0].orbit, searches[0].search));
    std::stop_source stop;
    const auto some = findPasses(searches, stop.get_token(), [&](std::size_t finished) {
        if (finished == 2) {
            stop.request_stop();
        }
    });
    EXPECT_THAT(some, SizeIs(2));
    EXPECT_EQ(findPasses(searches[0].orbit, days(kLisbon, 3000), stop.get_token()), PassList());
}

// REQ-PASSES-11: Ten days of a low orbit cost fewer than 4000 propagations.
TEST(PassFinder, RestsWhileTheSatelliteIsFarBelow)
{
    for (const double inclination : {30.0, 51.6, 98.7}) {
        const PassSearch search = days(kLisbon, 10);
        PassScan scan(orbit::Sgp4(circle(15.0, Angle::fromDegrees(inclination))), search);
        EXPECT_THAT(scan.run({}).passes, SizeIs(Gt(30U))) << inclination;
        EXPECT_LT(scan.propagations(), 4000) << inclination;
    }
}
