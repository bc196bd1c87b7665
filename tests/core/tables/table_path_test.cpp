// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tables/table_path.h"

#include "core/orbit/sgp4.h"
#include "core/tables/row_polynomial.h"
#include "core/tables/table_reader.h"
#include "core/units/angle_between.h"
#include "tests/core/tables/oem_text.h"
#include "tests/fakes/low_orbit.h"
#include "tests/fakes/text_of.h"

#include <gmock/gmock.h>

#include <functional>

namespace boresight::tables {
namespace {

using namespace std::chrono_literals;
using testing::HasSubstr;

const orbit::Observer kLisbon({.latitude = 38.757_deg, .longitude = -9.117_deg, .heightMetres = 80.0});
const UtcTime kStart = std::chrono::sys_days(std::chrono::year(2026) / 12 / 24);

SharedTable tableOf(const std::string& text)
{
    const auto table = readTable(text, QStringLiteral("/tmp/way.txt"));
    EXPECT_TRUE(table) << textOf(table.error());
    return table.value_or(nullptr);
}

std::chrono::milliseconds unixTime(UtcTime utc)
{
    return std::chrono::duration_cast<std::chrono::milliseconds>(utc.time_since_epoch());
}

orbit::OrbitState stateAt(const orbit::Sgp4& orbit, UtcTime utc)
{
    return orbit.propagate(orbit::julianDate(utc)).value();
}

// The state of the orbit at a time, as a row of a frame.
using RowOf = std::function<OemSample(UtcTime utc)>;

std::string oemOf(const std::string& frame, const RowOf& rowOf, std::chrono::hours length, const std::string& more = {})
{
    std::vector<OemSample> samples;
    for (UtcTime utc = kStart; utc <= kStart + length; utc += 60s) {
        samples.push_back(rowOf(utc));
    }
    return headText() + segmentText(frame, "UTC", samples, more);
}

class OrbitOfOurOwn : public testing::Test
{
protected:
    [[nodiscard]] OemSample teme(UtcTime utc) const
    {
        const orbit::OrbitState state = stateAt(orbit, utc);
        return {isoText(unixTime(utc)), state.position, state.velocity};
    }
    [[nodiscard]] OemSample earth(UtcTime utc) const
    {
        const orbit::GroundState state = groundState(stateAt(orbit, utc), orbit::julianDate(utc));
        return {isoText(unixTime(utc)), state.position, state.velocity};
    }
    // The largest difference between SGP4 and the table, at the rows and between them, for the whole day.
    [[nodiscard]] double worst(const std::string& oem, std::chrono::hours length) const
    {
        TablePath path(tableOf(oem), kLisbon);
        double degrees = 0.0;
        for (UtcTime utc = kStart; utc <= kStart + length; utc += 17s) {
            const auto seen = kLisbon.look(groundState(stateAt(orbit, utc), orbit::julianDate(utc)));
            const auto place = path.at(utc);
            EXPECT_TRUE(place) << textOf(place.error());
            degrees = std::max(degrees, angleBetween(place->direction, seen.direction).degrees());
            EXPECT_NEAR(*place->kilometres, seen.kilometres, 0.001);
        }
        return degrees;
    }

    orbit::Sgp4 orbit{fakes::lowOrbit(kStart)};
};

// REQ-TABLES-930: An OEM of a low orbit with a row each minute gives the same directions as SGP4, to 1e-4°, at the rows
// and between them. This holds in TEME and in a frame of the Earth, with Hermite and with Lagrange polynomials.
TEST_F(OrbitOfOurOwn, AnOemOfItLeadsTheSameWay)
{
    const RowOf inTeme = [this](UtcTime utc) { return teme(utc); };
    const RowOf onEarth = [this](UtcTime utc) { return earth(utc); };
    EXPECT_LT(worst(oemOf("TEME", inTeme, 24h), 24h), 1e-5);
    EXPECT_LT(worst(oemOf("ITRF", onEarth, 24h), 24h), 1e-5);
    const char* const lagrange = "INTERPOLATION = LAGRANGE\nINTERPOLATION_DEGREE = 7\n";
    EXPECT_LT(worst(oemOf("TEME", inTeme, 3h, lagrange), 3h), 1e-4);
    const char* const cubic = "INTERPOLATION = HERMITE\nINTERPOLATION_DEGREE = 3\n";
    EXPECT_LT(worst(oemOf("ITRF", onEarth, 3h, cubic), 3h), 1e-4);
}

// REQ-TABLES-931: A table is up from its rise to its set at the site, to 0.1 s, at the times of the orbit's passes.
TEST_F(OrbitOfOurOwn, RisesAndSetsAsTheOrbit)
{
    TablePath path(tableOf(oemOf(
                       "TEME", [this](UtcTime utc) { return teme(utc); }, 24h)),
                   kLisbon);
    const auto elevation = [&](UtcTime utc) {
        return kLisbon.look(groundState(stateAt(orbit, utc), orbit::julianDate(utc))).direction.elevation.degrees();
    };
    int stays = 0;
    for (UtcTime from = kStart; from < kStart + 24h; ++stays) {
        const auto stay = path.nextStay(from, kStart + 24h);
        if (!stay) {
            EXPECT_THAT(textOf(stay.error()), HasSubstr("has nothing above the horizon"));
            break;
        }
        ASSERT_TRUE(stay->to);
        if (stay->from > kStart) {
            EXPECT_NEAR(elevation(stay->from), 0.0, 0.005);
            EXPECT_LT(elevation(stay->from - 1s), 0.0);
        }
        if (*stay->to < kStart + 24h) {
            EXPECT_NEAR(elevation(*stay->to), 0.0, 0.005);
        }
        EXPECT_GT(elevation(stay->from + (*stay->to - stay->from) / 2), 0.0);
        EXPECT_GE(path.at(stay->from)->direction.elevation, 0_deg);
        EXPECT_GE(path.at(*stay->to)->direction.elevation, 0_deg);
        EXPECT_EQ(path.nextStay(stay->from + 1s, kStart + 24h)->from, stay->from + 1s) << "it is up already";
        from = *stay->to + 1s;
    }
    EXPECT_GE(stays, 4);
}

// The example of Vallado from the test of EarthAxis, in each frame, in km. The example has UT1 = UTC - 0.4399619 s.
// Here UT1 equals UTC, so the time is earlier by this amount.
// REQ-TABLES-932: A position in GCRF, EME2000, TOD, TEME and a frame of the Earth gives the same direction as in a
// published example, to 0.2″.
TEST(TablePath, TheFramesOfAPublishedExampleAgree)
{
    struct Frame
    {
        const char* name;
        orbit::Vector place;
    };
    const char* const time = "2004-04-06T07:51:27.946047";
    const char* const later = "2004-04-06T07:52:27.946047";
    const auto directionIn = [&](const Frame& frame) {
        const orbit::Vector rest{};
        TablePath path(tableOf(headText() +
                               segmentText(frame.name, "UTC", {{time, frame.place, rest}, {later, frame.place, rest}})),
                       kLisbon);
        return path
            .at(utcTime(
                atomicTime(std::chrono::sys_days(std::chrono::year(2004) / 4 / 6) + 7h + 51min + 27s + 946'047us)))
            .value()
            .direction;
    };
    const SkyPointing wanted = directionIn({"TDR", {-1033.4750313, 7901.3055856, 6380.3445328}});
    for (const Frame& frame :
         {Frame{"GCRF", {5102.508958, 6123.011401, 6378.136928}}, Frame{"EME2000", {5102.5096, 6123.01152, 6378.1363}},
          Frame{"TOD", {5094.5147804, 6127.3664612, 6380.3445328}},
          Frame{"TEME", {5094.1801621, 6127.6446595, 6380.3445327}}}) {
        EXPECT_LT(angleBetween(directionIn(frame), wanted).degrees(), 0.2 / 3600.0) << frame.name;
    }
}

// A straight path at constant speed, with a row each 10 s around the leap second at the end of 2016.
// REQ-TABLES-933: The path does not jump at a leap second, and the same rows in UTC, TAI, GPS and TT give the same
// path.
TEST(TablePath, GoesEvenlyThroughALeapSecond)
{
    const UtcTime midnight = std::chrono::sys_days(std::chrono::year(2017) / 1 / 1);
    const auto placeAfter = [](double seconds) { return orbit::Vector{6000.0, -1000.0 + 7.0 * seconds, 4000.0}; };
    const orbit::Vector velocity{0.0, 7.0, 0.0};
    const auto tableIn = [&](const std::string& system, std::chrono::milliseconds ahead) {
        std::vector<OemSample> samples;
        const std::vector<std::string> utc{"2016-12-31T23:59:30", "2016-12-31T23:59:40", "2016-12-31T23:59:50",
                                           "2016-12-31T23:59:60", "2017-01-01T00:00:09", "2017-01-01T00:00:19"};
        for (std::size_t i = 0; i < utc.size(); ++i) {
            const auto shown = unixTime(midnight - 30s) + 36s + ahead + std::chrono::seconds(10 * i);
            samples.push_back(
                {system == "UTC" ? utc[i] : isoText(shown), placeAfter(10.0 * static_cast<double>(i)), velocity});
        }
        return tableOf(headText() + segmentText("ITRF", system, samples));
    };
    const SharedTable inUtc = tableIn("UTC", 0s);
    EXPECT_EQ(*tableIn("TAI", 0s), *inUtc);
    EXPECT_EQ(*tableIn("GPS", -19s), *inUtc);
    EXPECT_EQ(*tableIn("TT", 32'184ms), *inUtc);
    TablePath path(inUtc, kLisbon);
    const auto seenAfter = [&](double seconds) { return kLisbon.look({placeAfter(seconds), {}}).direction; };
    EXPECT_LT(angleBetween(path.at(midnight - 5s)->direction, seenAfter(25.0)).degrees(), 1e-7);
    EXPECT_LT(angleBetween(path.at(midnight + 4s)->direction, seenAfter(35.0)).degrees(), 1e-7);
}

// REQ-TABLES-934: Nothing is extrapolated, and nothing is interpolated across a gap. The reason names the beginning,
// the end or the gap.
TEST_F(OrbitOfOurOwn, HasNothingInAGapAndBeyondItsEnds)
{
    std::vector<OemSample> first;
    std::vector<OemSample> second;
    for (int i = 0; i < 10; ++i) {
        first.push_back(teme(kStart + i * 60s));
        second.push_back(teme(kStart + 20min + i * 60s));
    }
    TablePath path(tableOf(headText() + segmentText("TEME", "UTC", first) + segmentText("TEME", "UTC", second)),
                   kLisbon);
    EXPECT_TRUE(path.at(kStart));
    EXPECT_TRUE(path.at(kStart + 9min));
    EXPECT_TRUE(path.at(kStart + 20min));
    EXPECT_TRUE(path.at(kStart + 29min));
    EXPECT_EQ(textOf(path.at(kStart - 1ms).error()), "The table of TEST ONE begins at 2026-12-24 00:00Z.");
    EXPECT_EQ(textOf(path.at(kStart + 9min + 1ms).error()),
              "The table of TEST ONE has a gap from 2026-12-24 00:09Z to 2026-12-24 00:20Z.");
    EXPECT_EQ(textOf(path.at(kStart + 29min + 1ms).error()), "The table of TEST ONE ended at 2026-12-24 00:29Z.");
    EXPECT_EQ(path.at(kStart - 1ms).error().code, ErrorCode::NotAvailable);
    EXPECT_THAT(textOf(path.nextStay(kStart + 1h, kStart + 2h).error()),
                HasSubstr("ended at 2026-12-24 00:29Z. Use a table with later times."));
    EXPECT_THAT(textOf(path.nextStay(kStart - 48h, kStart - 24h).error()), HasSubstr("begins at 2026-12-24 00:00Z."));
}

// REQ-TABLES-935: Directions are interpolated on the great circle at a constant rate, by the short way through north
// and through the zenith.
TEST(TablePath, DirectionsGoAlongTheGreatCircle)
{
    TablePath north(tableOf("2026-12-24T00:00:00Z,350,0\n2026-12-24T00:01:00Z,10,0\n2026-12-24T00:02:00Z,10,80\n"
                            "2026-12-24T00:03:00Z,190,80\n"),
                    kLisbon);
    const auto near = [&](UtcTime utc, const SkyPointing& wanted) {
        return angleBetween(north.at(utc)->direction, wanted).degrees() < 1e-9;
    };
    EXPECT_TRUE(near(kStart, {350_deg, 0_deg}));
    EXPECT_TRUE(near(kStart + 15s, {355_deg, 0_deg}));
    EXPECT_TRUE(near(kStart + 30s, {0_deg, 0_deg}));
    EXPECT_TRUE(near(kStart + 90s, {10_deg, 40_deg}));
    EXPECT_TRUE(near(kStart + 150s, {0_deg, 90_deg}));
    EXPECT_TRUE(near(kStart + 165s, {190_deg, 85_deg}));
    EXPECT_TRUE(near(kStart + 180s, {190_deg, 80_deg}));
    EXPECT_FALSE(north.at(kStart)->kilometres);
}

// REQ-TABLES-936: A table of directions is up while its direction is above the horizon. This also holds between two
// rows, and for each segment.
TEST(TablePath, DirectionsRiseAndSet)
{
    TablePath path(tableOf("2026-12-24T00:00:00Z 100 -10\n2026-12-24T00:10:00Z 100 10\n2026-12-24T00:20:00Z 100 -30\n"
                           "2026-12-24T02:00:00Z 200 5\n2026-12-24T02:10:00Z 200 8\n"),
                   kLisbon);
    const auto nearly = [](UtcTime time, UtcTime wanted) { return std::chrono::abs(time - wanted) <= 2ms; };
    const auto first = path.nextStay(kStart - 10min, kStart + 24h);
    ASSERT_TRUE(first);
    EXPECT_TRUE(nearly(first->from, kStart + 5min));
    EXPECT_TRUE(nearly(*first->to, kStart + 12min + 30s));
    const auto second = path.nextStay(kStart + 15min, kStart + 24h);
    ASSERT_TRUE(second);
    EXPECT_EQ(*second, (TableStay{.from = kStart + 2h, .to = kStart + 2h + 10min})) << "it ends with its rows";
    EXPECT_EQ(path.nextStay(kStart + 15min, kStart + 2h + 5min)->to, std::nullopt) << "it goes on";
    EXPECT_THAT(textOf(path.nextStay(kStart + 15min, kStart + 30min).error()),
                HasSubstr("has nothing above the horizon from 2026-12-24 00:15Z to 2026-12-24 00:30Z."));
    EXPECT_THAT(textOf(path.nextStay(kStart + 21min, kStart + 30min).error()), HasSubstr("has a gap from"));
}

// REQ-TABLES-937: Rows between which no path can be computed give no direction, and never one that is not a number.
TEST(TablePath, UnevenRowsHaveNoWayRatherThanAWrongOne)
{
    std::vector<OrbitRow> rows;
    for (int i = 0; i < 26; ++i) {
        rows.push_back({.time = AtomicTime(i < 25 ? i : 2'000'000'000'000'000'000),
                        .position = {7000.0 + i % 2, 0.0, 0.0},
                        .velocity = {}});
    }
    Table table{.name = QStringLiteral("odd"),
                .rows = OrbitSegments{{.usesVelocities = false,
                                       .nodes = rows.size(),
                                       .from = rows.front().time,
                                       .to = rows.back().time,
                                       .rows = rows}},
                .spans = {{rows.front().time, rows.back().time}}};
    TablePath path(std::make_shared<const Table>(std::move(table)), kLisbon);
    const auto place = path.at(UtcTime(std::chrono::nanoseconds(1'000'000'000'000'000'000)));
    ASSERT_FALSE(place);
    EXPECT_THAT(textOf(place.error()), HasSubstr("are too uneven to interpolate between them."));
}

}  // namespace
}  // namespace boresight::tables
