// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/ephemeris/rise_set.h"

#include "tests/core/ephemeris/body_table.h"

#include <gtest/gtest.h>

#include <utility>

using namespace boresight;
using namespace boresight::ephemeris;

namespace {

const UtcTime kDay = utcOf("2026-12-24T00:00:00Z");  // the table has this day in Lisbon, every ten minutes

// The two rows between which the body passes an elevation.
std::optional<std::pair<UtcTime, UtcTime>> passage(Body body, Angle elevation, bool upwards)
{
    std::optional<BodyRow> before;
    for (const BodyRow& row : bodyTable()) {
        if (row.body != body || row.utc < kDay || row.site != "Lisbon" || row.utc >= kDay + std::chrono::days(1)) {
            continue;
        }
        const BodyRow& from = upwards ? before.value_or(row) : row;
        const BodyRow& to = upwards ? row : before.value_or(row);
        if (from.direction.elevation <= elevation && to.direction.elevation > elevation) {
            return std::pair(before->utc, row.utc);
        }
        before = row;
    }
    return std::nullopt;
}

}  // namespace

// REQ-EPHEMERIS-07 (RiseSet.*): Rises and sets are found to the second, and days without any are detected. Only a body
// that is up or down for less than 10 min may be missed.
TEST(RiseSet, LieWhereTheTablePassesTheElevation)
{
    Almanac lisbon(siteOf("Lisbon"));
    for (const Body body : {Body::Sun, Body::Moon}) {
        for (const Angle elevation : {0_deg, 10_deg}) {
            const auto rising = passage(body, elevation, true);
            const auto setting = passage(body, elevation, false);
            ASSERT_TRUE(rising && setting);
            const auto rise = nextRise(lisbon, body, kDay, elevation);
            const auto set = nextSet(lisbon, body, kDay, elevation);
            ASSERT_TRUE(rise && set);
            EXPECT_TRUE(*rise > rising->first && *rise <= rising->second);
            EXPECT_TRUE(*set > setting->first && *set <= setting->second);
        }
    }
}

TEST(RiseSet, AreExactToTheSecond)
{
    Almanac lisbon(siteOf("Lisbon"));
    const UtcTime rise = nextRise(lisbon, Body::Sun, kDay, 0_deg).value();
    EXPECT_GT(lisbon.place(Body::Sun, rise).direction.elevation, 0_deg);
    EXPECT_LE(lisbon.place(Body::Sun, rise - std::chrono::seconds(1)).direction.elevation, 0_deg);
    EXPECT_GT(nextRise(lisbon, Body::Sun, rise, 0_deg).value(), rise + std::chrono::hours(23)) << "not the same again";
}

TEST(RiseSet, AreNotWhereThereAreNone)
{
    Almanac svalbard(siteOf("Svalbard"));
    EXPECT_FALSE(nextRise(svalbard, Body::Sun, utcOf("2026-12-24T00:00:00Z"), 0_deg)) << "polar night";
    EXPECT_FALSE(nextSet(svalbard, Body::Sun, utcOf("2026-06-21T00:00:00Z"), 0_deg)) << "polar day";
}

// The search skips the hours in which the body cannot reach the horizon. This test looks every ten minutes.
TEST(RiseSet, AreNotSteppedOver)
{
    Almanac tromso({.latitude = 69.65_deg, .longitude = 18.96_deg, .heightMetres = 0.0});
    for (int day = 0; day < 360; day += 12) {
        const UtcTime from = utcOf("2026-01-01T00:00:00Z") + std::chrono::hours(24 * day + day % 24);
        const auto isUp = [&](Body body, UtcTime utc) { return tromso.place(body, utc).direction.elevation > 0_deg; };
        for (const Body body : {Body::Sun, Body::Moon}) {
            const UtcTime rise = nextRise(tromso, body, from, 0_deg).value_or(from + kRiseSearch);
            const UtcTime set = nextSet(tromso, body, from, 0_deg).value_or(from + kRiseSearch);
            bool was = isUp(body, from);
            for (UtcTime utc = from + kShortestUp; utc <= from + kRiseSearch; utc += kShortestUp) {
                const bool is = isUp(body, utc);
                EXPECT_FALSE(is && !was && utc < rise) << "day " << day;
                EXPECT_FALSE(was && !is && utc < set) << "day " << day;
                was = is;
            }
        }
    }
}
