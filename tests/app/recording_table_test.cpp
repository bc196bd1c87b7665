// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/recordings/recording_table.h"

#include "app/recordings/recording_options.h"
#include "tests/core/recording/recorded_pass.h"

#include <gmock/gmock.h>

namespace boresight::ctl {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;
using testing::StartsWith;

recording::Recording recordedPass(std::size_t ticks)
{
    return {.header = recording::recordedHeader(),
            .ticks = recording::RecordedPass().ticks(ticks),
            .events = {{.utc = recording::kRecordedFrom + std::chrono::milliseconds(1'500),
                        .kind = recording::EventKind::MotionStart,
                        .source = QStringLiteral("operator"),
                        .text = QStringLiteral("tracks NOAA 19, again")}},
            .plan = plan::PlanVariant{.moments = {{.utc = recording::kRecordedFrom, .error = 0.5_deg}}},
            .gaps = {{.from = recording::kRecordedFrom + std::chrono::seconds(1),
                      .to = recording::kRecordedFrom + std::chrono::seconds(2),
                      .ticks = 50}},
            .hasEnd = true};
}

std::string csvOf(const RecordTable& table)
{
    return table.text(TableFormat::Csv);
}

}  // namespace

// REQ-RECORD-10: `export` prints the ticks of a recording with all channels, each with its unit, its events, its plan
// and what it is about, as CSV, JSON or a table.
TEST(RecordingTable, ATickHasAllChannels)
{
    recording::Recording pass = recordedPass(2);
    pass.ticks[1] = recording::Tick{.utc = recording::kRecordedFrom, .state = 2};
    const std::string csv = csvOf(tickTable(pass, 0, 2));
    EXPECT_THAT(csv, StartsWith("t_utc,state,actual_azimuth_deg,actual_elevation_deg,commanded_azimuth_deg,"
                                "commanded_elevation_deg,target_azimuth_deg,target_elevation_deg,error_deg,"
                                "sensor_azimuth_deg,sensor_elevation_deg,wind_m_s,azimuth_actual_deg,"));
    EXPECT_THAT(csv, HasSubstr(",elevation_motor_temperature_degC,elevation_state\n"));
    EXPECT_THAT(csv, HasSubstr(",MOVING\n2026-11-18T11:06:40.000Z,TRACK,,,,"));
    EXPECT_THAT(tickTable(recordedPass(10), 8, 5).rows, SizeIs(2));
}

// REQ-RECORD-10
TEST(RecordingTable, EventsPlanAndFactsHaveTheirTables)
{
    const recording::Recording pass = recordedPass(100);
    EXPECT_EQ(
        csvOf(eventTable(pass)),
        "t_utc,kind,level,source,text\n2026-11-18T11:06:41.500Z,motion,advisory,operator,\"tracks NOAA 19, again\"\n");
    EXPECT_EQ(csvOf(plannedTable(pass)),
              "t_utc,az_deg,el_deg,target_az_deg,target_el_deg,error_deg,hidden\n"
              "2026-11-18T11:06:40.000Z,0.0000,0.0000,0.0000,0.0000,0.5000,no\n");
    EXPECT_THAT(plannedTable({}).rows, IsEmpty());
    const std::string about = csvOf(aboutTable(pass));
    EXPECT_THAT(about, HasSubstr("\ntarget,NOAA 19\nnorad,33591\nclient,rotctld 127.0.0.1:51234\npart,1\n"));
    EXPECT_THAT(about, HasSubstr("\nticks,100\nlost_ticks,50\nevents,1\nplan,direct\nerror_rms_deg,0.01"));
    EXPECT_THAT(about, HasSubstr("\ncomplete,yes\n"));
    EXPECT_THAT(csvOf(aboutTable({})), HasSubstr("\nerror_rms_deg,\n"));
    recording::Recording slewed = pass;
    slewed.plan.reset();
    slewed.ticks.front().error = 40_deg;  // before the beam was on target
    EXPECT_THAT(csvOf(aboutTable(slewed)), HasSubstr("\nerror_peak_deg,0.0"));
}

// REQ-RECORD-11: `replay` prints a status line for each second, and each event at its time.
TEST(RecordingTable, AReplayHasALineForEachSecond)
{
    const std::vector<ReplayLine> lines = replayLines(recordedPass(151));
    ASSERT_THAT(lines, SizeIs(6));  // 4 seconds, a gap, an event
    EXPECT_LT(lines[0].at, Seconds(0.05));
    EXPECT_THAT(lines[0].text.toStdString(), HasSubstr("Z  SLEW  azimuth "));
    EXPECT_THAT(lines[0].text.toStdString(), HasSubstr("  off by 0.0"));
    EXPECT_THAT(lines[3].text.toStdString(), HasSubstr("operator: tracks NOAA 19, again"));
    EXPECT_NEAR(lines[3].at.count(), 1.5, 0.05);
    EXPECT_THAT(lines[5].text.toStdString(), HasSubstr("  TRACK  "));
    EXPECT_THAT(replayLines({}), IsEmpty());
}

TEST(RecordingOptions, AreReadWithTheFileFirst)
{
    const std::vector<std::string> line{"a.recording", "--what", "plan", "--format=json"};
    const auto read = parseExportOptions(line);
    ASSERT_TRUE(read);
    EXPECT_EQ(read->file, QStringLiteral("a.recording"));
    EXPECT_EQ(read->part, RecordedPart::Plan);
    EXPECT_EQ(read->format, TableFormat::Json);
    const std::vector<std::string> fast{"a.recording", "--speed", "60"};
    EXPECT_EQ(parseReplayOptions(fast)->speed, 60.0);
}

TEST(RecordingOptions, NameWhatIsWrong)
{
    using Line = std::vector<std::string>;
    EXPECT_FALSE(parseExportOptions(Line{}));
    EXPECT_FALSE(parseExportOptions(Line{"--what", "plan"}));
    EXPECT_FALSE(parseExportOptions(Line{"a", "--what", "all"}));
    EXPECT_FALSE(parseExportOptions(Line{"a", "--speed", "2"}));
    EXPECT_FALSE(parseReplayOptions(Line{"a", "--speed"}));
    EXPECT_EQ(parseReplayOptions(Line{"a", "--speed", "61"}).error().text,
              QStringLiteral("--speed \"61\": expected a number from 1 to 60"));
}

}  // namespace boresight::ctl
