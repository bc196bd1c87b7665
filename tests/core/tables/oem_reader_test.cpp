// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tables/oem_reader.h"

#include "core/tables/table_reader.h"
#include "tests/core/tables/oem_text.h"
#include "tests/fakes/text_of.h"

#include <gmock/gmock.h>

namespace boresight::tables {
namespace {

using namespace std::chrono_literals;
using testing::HasSubstr;
using testing::StartsWith;

const UtcTime kEpoch = std::chrono::sys_days(std::chrono::year(2026) / 12 / 24);

// 7000 km from the centre of the Earth, moving by one degree a minute.
std::vector<OemSample> samples(int count, std::chrono::seconds from = 0s)
{
    std::vector<OemSample> all;
    for (int i = 0; i < count; ++i) {
        const std::chrono::milliseconds time = std::chrono::milliseconds(1'798'070'400'000) + from + i * 60s;
        const double angle = 0.0174533 * (static_cast<double>(from.count()) / 60.0 + i);
        all.push_back({isoText(time),
                       {7000.0 * std::cos(angle), 7000.0 * std::sin(angle), 10.0},
                       {-2.036 * std::sin(angle), 2.036 * std::cos(angle), 0.0}});
    }
    return all;
}

std::string whole(const std::string& more = {})
{
    return headText() + segmentText("ITRF2014", "UTC", samples(5), more);
}

std::string refusalOf(const std::string& text)
{
    const auto table = readTable(text, QStringLiteral("a.oem"));
    return table ? "accepted" : textOf(table.error());
}

// REQ-TABLES-920: An OEM in KVN is read: name, frame, times, positions and velocities, the interpolation that it names,
// and its usable part. Comments, accelerations and covariances are ignored.
TEST(OemReader, ReadsWhatTheStandardHas)
{
    std::string text = whole(
        "COMMENT usable is less\nUSEABLE_START_TIME = 2026-12-24T00:01:00\nUSEABLE_STOP_TIME = 2026-12-24T00:03:00\n"
        "INTERPOLATION = LAGRANGE\nINTERPOLATION_DEGREE = 3\n");
    text = changed(text, "META_STOP\n", "META_STOP\nCOMMENT rows\n");
    text += "COVARIANCE_START\nEPOCH = 2026-12-24T00:01:00\n1\n2 3\nCOVARIANCE_STOP\n";
    const auto oem = readOem(text);
    ASSERT_TRUE(oem) << oem.error().reason.toStdString();
    EXPECT_EQ(oem->name, "TEST ONE");
    ASSERT_EQ(oem->segments.size(), 1U);
    const OrbitSegment& segment = oem->segments.front();
    EXPECT_EQ(segment.frame, OrbitFrame::Earth);
    EXPECT_FALSE(segment.usesVelocities);
    EXPECT_EQ(segment.nodes, 4U);
    EXPECT_EQ(segment.from, atomicTime(kEpoch + 1min));
    EXPECT_EQ(segment.to, atomicTime(kEpoch + 3min));
    ASSERT_EQ(segment.rows.size(), 5U);
    EXPECT_EQ(segment.rows[1].time, atomicTime(kEpoch + 1min));
    EXPECT_NEAR(segment.rows[1].position.y, 122.167, 0.001);
    EXPECT_NEAR(segment.rows[1].velocity.y, 2.0357, 0.0001);

    const std::string last = text.substr(0, text.find("COVARIANCE_START"));
    const auto accelerated = readOem(last.substr(0, last.size() - 1) + " 1e-3 0 0\n");
    ASSERT_TRUE(accelerated) << accelerated.error().reason.toStdString();
    EXPECT_EQ(accelerated->segments, oem->segments);
}

// REQ-TABLES-921: If no method is named, a Hermite polynomial of degree 7 is used, over four rows or as many as there
// are.
TEST(OemReader, HasASoundInterpolationOfItsOwn)
{
    const auto segmentOf = [](const std::string& text) { return readOem(text).value().segments.front(); };
    EXPECT_TRUE(segmentOf(whole()).usesVelocities);
    EXPECT_EQ(segmentOf(whole()).nodes, 4U);
    EXPECT_EQ(segmentOf(whole("INTERPOLATION = Hermite\nINTERPOLATION_DEGREE = 5\n")).nodes, 3U);
    EXPECT_EQ(segmentOf(whole("INTERPOLATION = HERMITE\nINTERPOLATION_DEGREE = 1\n")).nodes, 2U);
    EXPECT_EQ(segmentOf(whole("INTERPOLATION = LINEAR\nINTERPOLATION_DEGREE = 1\n")).nodes, 2U);
    EXPECT_EQ(segmentOf(whole("INTERPOLATION = LAGRANGE\nINTERPOLATION_DEGREE = 9\n")).nodes, 5U);
}

// REQ-TABLES-922: Unsupported content is refused with the line and the reason: another centre, frame, time system or
// method, or a frame of a fixed date.
TEST(OemReader, RefusesWhatItCannotDo)
{
    const std::string text = whole();
    EXPECT_EQ(refusalOf(changed(text, "EARTH", "MARS BARYCENTER")),
              "a.oem:13: The centre is \"MARS BARYCENTER\". Boresight reads only orbits with CENTER_NAME = EARTH.");
    EXPECT_EQ(refusalOf(changed(text, "ITRF2014", "MOD")),
              "a.oem:13: The frame is \"MOD\". Boresight reads ITRF, EME2000, GCRF, ICRF, TEME and TOD.");
    EXPECT_EQ(refusalOf(changed(text, "SYSTEM = UTC", "SYSTEM = TDB")),
              "a.oem:13: The time system is \"TDB\". Boresight reads UTC, TAI, GPS and TT.");
    EXPECT_THAT(refusalOf(whole("INTERPOLATION = PROPAGATE\n")),
                HasSubstr("INTERPOLATION is \"PROPAGATE\". Boresight supports HERMITE, LAGRANGE and LINEAR."));
    EXPECT_THAT(refusalOf(whole("INTERPOLATION_DEGREE = 26\n")), HasSubstr("It must be a number from 1 to 25."));
    EXPECT_THAT(refusalOf(changed(text, "ITRF2014", "TEME\nREF_FRAME_EPOCH = 2026-12-24T00:00:00")),
                HasSubstr("The frame TEME has the fixed date REF_FRAME_EPOCH."));
    EXPECT_THAT(refusalOf("CCSDS_OPM_VERS = 2.0\n"),
                HasSubstr("a.oem:1: The file is a CCSDS message, but not an OEM."));
    EXPECT_THAT(refusalOf(changed(text, "VERS = 2.0", "VERS = 4.0")), HasSubstr("a.oem:1: The version \"4.0\" of OEM"));
}

// REQ-TABLES-923: A damaged OEM is refused with the line, the error and what to do: a cut file, a key that is missing,
// doubled or unknown, invalid numbers, other units, and rows that are not in the order of time.
TEST(OemReader, NamesTheLineOfAMistake)
{
    const std::string text = whole();
    const std::string head = headText();
    EXPECT_THAT(refusalOf(head), StartsWith("a.oem:4: The file has no META_START and no rows."));
    EXPECT_THAT(refusalOf(text.substr(0, text.find("META_STOP"))), HasSubstr("The file is cut: META_STOP is missing."));
    EXPECT_THAT(refusalOf(text + "COVARIANCE_START\n"), HasSubstr("The file is cut: COVARIANCE_STOP is missing."));
    EXPECT_THAT(refusalOf(text.substr(0, text.rfind("0.0"))), HasSubstr("must have 6 numbers behind its time"));
    EXPECT_THAT(refusalOf(changed(text, "CENTER_NAME = EARTH\n", "")),
                StartsWith("a.oem:12: The key CENTER_NAME is missing above."));
    EXPECT_THAT(refusalOf(changed(text, "OBJECT_ID", "OBJECT_NAME")),
                StartsWith("a.oem:7: The file has the key OBJECT_NAME twice in one segment."));
    EXPECT_THAT(refusalOf(whole("USABLE_STOP_TIME = x\n")),
                HasSubstr("The key \"USABLE_STOP_TIME\" is not one of an OEM."));
    EXPECT_THAT(refusalOf(whole("USEABLE_STOP_TIME = x\n")),
                HasSubstr("USEABLE_STOP_TIME is \"x\". It must be a time"));
    EXPECT_THAT(refusalOf(changed(text, "7000.000000000", "nan")), StartsWith("a.oem:14: \"nan\" is not a number."));
    EXPECT_THAT(refusalOf(changed(text, "7000.000000000", "7000000")),
                StartsWith("a.oem:14: The position is 7e+06 km from the centre of the Earth. The range is 6000 to"));
    EXPECT_THAT(refusalOf(changed(text, " 2.036000000", " 2036.0")), StartsWith("a.oem:14: The speed is 2036 km/s."));
    EXPECT_THAT(refusalOf(changed(text, "T00:02:00.000 ", "T00:00:30.000 ")),
                StartsWith("a.oem:16: The time is not later than the time in the row above. Sort the rows by time."));
    EXPECT_THAT(refusalOf(changed(text, "6995", "-6995")), StartsWith("a.oem:16: The place is 177.0°"));
    EXPECT_THAT(refusalOf(text + "COVARIANCE_START\nCOVARIANCE_STOP\n1\n"),
                StartsWith("a.oem:21: After COVARIANCE_STOP only META_START may follow."));
    EXPECT_THAT(refusalOf(whole("USEABLE_START_TIME = 2026-12-25T00:00:00\n")),
                HasSubstr("The segment that ends here has no rows in its usable time."));
    EXPECT_THAT(refusalOf(head + segmentText("ITRF", "UTC", samples(1))), HasSubstr("has fewer than two rows."));
}

// REQ-TABLES-924: Segments are in the order of time and of one object. If a segment begins where the previous one ends,
// the path continues. Otherwise there is a gap.
TEST(OemReader, KeepsTheSegmentsApart)
{
    const std::string first = headText() + segmentText("ITRF", "UTC", samples(5));
    const auto touching = readOem(first + segmentText("ITRF", "UTC", samples(5, 240s)));
    ASSERT_TRUE(touching);
    EXPECT_EQ(spansOf(touching->segments), (std::vector<TableSpan>{{atomicTime(kEpoch), atomicTime(kEpoch + 8min)}}));
    const auto apart = readOem(first + segmentText("ITRF", "UTC", samples(5, 300s)));
    ASSERT_TRUE(apart);
    EXPECT_EQ(spansOf(apart->segments),
              (std::vector<TableSpan>{{atomicTime(kEpoch), atomicTime(kEpoch + 4min)},
                                      {atomicTime(kEpoch + 5min), atomicTime(kEpoch + 9min)}}));
    EXPECT_THAT(refusalOf(first + segmentText("ITRF", "UTC", samples(5, 180s))),
                HasSubstr("begins before the end of the segment above it."));
    EXPECT_THAT(refusalOf(first + changed(segmentText("ITRF", "UTC", samples(5, 300s)), "TEST ONE", "TEST TWO")),
                HasSubstr("The object is \"TEST TWO\", but the object above is \"TEST ONE\"."));
}

}  // namespace
}  // namespace boresight::tables
