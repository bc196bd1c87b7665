// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/record_text.h"

#include "tests/fakes/text_of.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <fstream>
#include <iterator>

namespace boresight::calibration {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

UtcTime at(int year, unsigned month, unsigned day, std::chrono::milliseconds since)
{
    return std::chrono::sys_days{std::chrono::year(year) / std::chrono::month(month) / std::chrono::day(day)} + since;
}

DeviationCurve curve()
{
    return {.sense = AzimuthSense::CounterClockwise,
            .constant = 1.5_deg,
            .a1 = 8_deg,
            .b1 = -2.25_deg,
            .a2 = 0.125_deg,
            .b2 = 3_deg,
            .scatter = 0.5_deg,
            .constantSigma = 1.25_deg,
            .elevation = 30_deg,
            .unreliable = {{.from = 350_deg, .to = 10_deg, .residual = -15_deg},
                           {.from = 100_deg, .to = 120_deg, .residual = 9_deg}}};
}

CalibrationRecord full()
{
    CalibrationRecord record;
    record.when = at(2026, 11, 21, std::chrono::milliseconds(77696123));
    record.title = QStringLiteral(R"(Six points of the Sun, "by eye" \ é)");
    record.mount = {.azimuthDrive = "18c0a7a5-2d94-4d3c-9d5e-0d1f0b7e1a01",
                    .elevationDrive = "18c0a7a5-2d94-4d3c-9d5e-0d1f0b7e1a02",
                    .site = RecordSite{Angle::fromDegrees(38.7223), Angle::fromDegrees(-9.1393), 120.5}};
    for (const Term term : kAllTerms) {
        valueOf(record.terms.before, term) = Angle::fromDegrees(0.25 * static_cast<double>(indexOf(term)));
        valueOf(record.terms.after, term) = Angle::fromDegrees(37.4 - 0.1 * static_cast<double>(indexOf(term)));
    }
    record.sigmas[indexOf(Term::AzimuthOffset)] = 0.05_deg;
    record.sigmas[indexOf(Term::TiltEast)] = 0.02_deg;
    record.sensor =
        Change<SensorMounting>{.before = {}, .after = {AzimuthSense::CounterClockwise, 12_deg, -1_deg, curve()}};
    record.points.push_back({.axes = {370_deg, 30_deg},
                             .truth = {47.5_deg, 30.25_deg},
                             .sigma = 0.03_deg,
                             .when = at(2026, 11, 21, std::chrono::milliseconds(5)),
                             .label = QStringLiteral("Sun")});
    record.points.push_back({.axes = {-10_deg, 60_deg},
                             .truth = {27.5_deg, 60.25_deg},
                             .sigma = 0.1_deg,
                             .when = at(2026, 2, 1, std::chrono::milliseconds(0)),
                             .label = QStringLiteral(""),
                             .isUsed = false});
    return record;
}

CalibrationRecord bare()
{
    CalibrationRecord record;
    record.when = at(2026, 1, 1, std::chrono::milliseconds(0));
    return record;
}

std::string written(const CalibrationHistory& history)
{
    const auto text = toText(history);
    EXPECT_TRUE(text.has_value()) << (text ? "" : textOf(text.error()));
    return text.value_or("");
}

std::string recordReason(const std::string& text)
{
    const auto history = parseHistory(text, QStringLiteral("calibration.toml"));
    return history ? "accepted" : textOf(history.error());
}

std::string replaced(std::string text, const std::string& what, const std::string& with)
{
    const std::size_t at = text.find(what);
    EXPECT_NE(at, std::string::npos) << what;
    return at == std::string::npos ? text : text.replace(at, what.size(), with);
}

// REQ-CALIBRATION-19 (RecordText.*): A history is a TOML file, in degrees. Every value is kept to a billionth of a
// degree. Unknown, missing or wrong keys are all reported at once with their lines. A history that could not be read
// again is not written.
TEST(RecordText, EverythingSurvives)
{
    const CalibrationHistory history({full(), bare(), full()}, 2, {full()});
    const std::string text = written(history);
    const auto read = parseHistory(text, QStringLiteral("calibration.toml"));
    ASSERT_TRUE(read.has_value()) << textOf(read.error());
    EXPECT_EQ(read->inForce(), 2U);
    ASSERT_EQ(read->entries().size(), 3U);
    ASSERT_EQ(read->superseded().size(), 1U);
    EXPECT_EQ(read->superseded().front(), read->entries().front());
    EXPECT_EQ(written(*read), text);  // to a billionth of a degree
    const CalibrationRecord& record = read->entries().front();
    EXPECT_EQ(record.when, full().when);
    EXPECT_EQ(record.title, full().title);
    EXPECT_EQ(record.mount.elevationDrive, full().mount.elevationDrive);
    EXPECT_NEAR(record.mount.site->longitude.degrees(), -9.1393, 1e-9);
    EXPECT_NEAR(record.terms.after.azimuthOffset.degrees(), 37.4, 1e-9);
    EXPECT_NEAR(record.terms.before.elevationSag.degrees(), 1.5, 1e-9);
    EXPECT_FALSE(record.sigmas[indexOf(Term::TiltNorth)].has_value());
    EXPECT_NEAR(record.sigmas[indexOf(Term::TiltEast)]->degrees(), 0.02, 1e-9);
    ASSERT_TRUE(record.sensor && record.sensor->after.curve);
    EXPECT_FALSE(record.sensor->before.curve.has_value());
    EXPECT_EQ(record.sensor->after.curve->sense, AzimuthSense::CounterClockwise);
    EXPECT_NEAR(record.sensor->after.curve->b1.degrees(), -2.25, 1e-9);
    ASSERT_EQ(record.sensor->after.curve->unreliable.size(), 2U);
    EXPECT_NEAR(record.sensor->after.curve->unreliable[1].to.degrees(), 120.0, 1e-9);
    ASSERT_EQ(record.points.size(), 2U);
    EXPECT_NEAR(record.points[0].axes.azimuth.degrees(), 370.0, 1e-9);
    EXPECT_NEAR(record.points[0].truth.elevation.degrees(), 30.25, 1e-9);
    EXPECT_EQ(record.points[0].when, full().points[0].when);
    EXPECT_EQ(record.points[0].label, QStringLiteral("Sun"));
    EXPECT_TRUE(record.points[0].isUsed);
    EXPECT_FALSE(record.points[1].isUsed);
    EXPECT_FALSE(read->entries()[1].mount.site.has_value());
    EXPECT_FALSE(read->entries()[1].sensor.has_value());
}

// A file from an earlier day is written back identically, to the last byte.
TEST(RecordText, KeepsTheFormOfItsFile)
{
    std::ifstream file(BORESIGHT_TEST_DATA "/calibrations.toml");
    const std::string kept{std::istreambuf_iterator<char>(file), {}};
    EXPECT_EQ(written(CalibrationHistory({full(), bare(), full()}, 2, {full()})), kept);
    EXPECT_EQ(recordReason(kept), "accepted");
}

TEST(RecordText, IsReadable)
{
    const std::string text = written(CalibrationHistory({full()}, 1));
    EXPECT_THAT(text, StartsWith("# Boresight: calibrations of one mount"));
    EXPECT_THAT(text, HasSubstr("when = 2026-11-21T21:34:56.123Z\n"));
    EXPECT_THAT(text, HasSubstr("[calibration.terms.after]\nazimuth_offset_deg = 37.4\n"));
    EXPECT_THAT(text, HasSubstr("[[calibration.point]]\nwhen = 2026-11-21T00:00:00.005Z\nlabel = \"Sun\"\n"));
}

TEST(RecordText, AnEmptyHistoryIsOne)
{
    const auto read = parseHistory(written({}), QStringLiteral("calibration.toml"));
    ASSERT_TRUE(read.has_value());
    EXPECT_EQ(*read, CalibrationHistory());
}

TEST(RecordText, TellsAllErrorsAtOnceInTheOrderOfTheirLines)
{
    const std::string bad =
        "version = 1\n"
        "in_force = 2\n"
        "surprise = 1\n"
        "[[calibration]]\n"
        "when = 2026-11-21\n"
        "title = 5\n"
        "azimuth_drive = \"a\"\n"
        "[calibration.terms]\n"
        "before = 7\n"
        "[calibration.sigmas]\n"
        "tilt_north_deg = \"much\"\n"
        "tilt_south_deg = 0.1\n"
        "[[calibration.point]]\n"
        "when = 2026-11-21T21:34:00+01:00\n"
        "label = \"Sun\"\n"
        "axis_azimuth_deg = nan\n"
        "axis_elevation_deg = 1e9\n"
        "true_azimuth_deg = 10\n"
        "true_elevation_deg = 10\n"
        "sigma_deg = 0\n"
        "used = 1\n";
    EXPECT_EQ(
        recordReason(bad),
        "calibration.toml:2: in_force: 2 is not within 0…1\n"
        "calibration.toml:3: surprise: unknown key\n"
        "calibration.toml:4: calibration[1].elevation_drive: is missing\n"
        "calibration.toml:5: calibration[1].when: a UTC time is expected, like 2026-11-21T21:34:00.000Z\n"
        "calibration.toml:6: calibration[1].title: a text in quotes is expected, without control characters\n"
        "calibration.toml:8: calibration[1].terms.after: is missing\n"
        "calibration.toml:9: calibration[1].terms.before: a table is expected\n"
        "calibration.toml:11: calibration[1].sigmas.tilt_north_deg: a number is expected\n"
        "calibration.toml:12: calibration[1].sigmas.tilt_south_deg: unknown key\n"
        "calibration.toml:14: calibration[1].point[1].when: a UTC time is expected, like 2026-11-21T21:34:00.000Z\n"
        "calibration.toml:16: calibration[1].point[1].axis_azimuth_deg: a number is expected\n"
        "calibration.toml:17: calibration[1].point[1].axis_elevation_deg: 1e+09 is not within -36000…36000\n"
        "calibration.toml:20: calibration[1].point[1].sigma_deg: 0 is not within 1e-06…90\n"
        "calibration.toml:21: calibration[1].point[1].used: true or false is expected");
}

TEST(RecordText, RefusesWhatIsNoHistory)
{
    const std::string good = written(CalibrationHistory({full()}, 1));
    EXPECT_EQ(recordReason(good), "accepted");
    EXPECT_THAT(recordReason(""), HasSubstr("version: is missing"));
    EXPECT_THAT(recordReason("version = "), StartsWith("calibration.toml:1: "));
    EXPECT_THAT(recordReason(replaced(good, "version = 1", "version = 2")),
                HasSubstr("2: version: 2 is not within 1…1"));
    EXPECT_THAT(recordReason(replaced(good, "in_force = 1", "in_force = 0.5")),
                HasSubstr("a whole number is expected"));
    EXPECT_THAT(recordReason(replaced(good, "sense = \"clockwise\"", "sense = \"sideways\"")),
                HasSubstr("\"clockwise\" or \"counterclockwise\" is expected"));
    EXPECT_THAT(recordReason(replaced(good, "\"Sun\"", "\"S\\nun\"")), HasSubstr("without control characters"));
    EXPECT_THAT(recordReason("version = 1\nin_force = 0\ncalibration = 3\n"),
                HasSubstr("\"[[calibration]]\" is expected"));
    EXPECT_THAT(recordReason("version = 1\nin_force = 0\ncalibration = [3]\n"),
                HasSubstr("calibration[1]: a table is expected"));
}

TEST(RecordText, WritesNothingThatCannotBeReadAgain)
{
    CalibrationRecord broken = full();
    broken.points[0].axes.azimuth = Angle::fromDegrees(std::nan(""));
    const auto text = toText(CalibrationHistory({broken}, 1));
    ASSERT_FALSE(text.has_value());
    EXPECT_THAT(textOf(text.error()), HasSubstr("axis_azimuth_deg"));
    CalibrationRecord controls = full();
    controls.title = QStringLiteral("two\nlines");
    EXPECT_THAT(written(CalibrationHistory({controls}, 1)), HasSubstr("title = \"two?lines\""));
}

}  // namespace
}  // namespace boresight::calibration
