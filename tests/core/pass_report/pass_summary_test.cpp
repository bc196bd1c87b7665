// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/pass_report/pass_summary.h"

#include "core/pass_report/report_table.h"
#include "tests/core/pass_report/driven_pass.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace boresight::pass_report {
namespace {

using recording::Event;
using recording::EventKind;
using recording::EventLevel;
using recording::Recording;

constexpr double kTiny = 1e-9;

PassSummary summarised(const Recording& recording)
{
    const Result<PassSummary> summary = summaryOf(recording);
    EXPECT_TRUE(summary.has_value());
    return summary.value_or(PassSummary{});
}

// The values of the row with this label, below the heading.
QStringList rowValues(const std::vector<ReportRow>& rows, const char* heading, const char* label)
{
    const auto head = std::ranges::find_if(
        rows, [heading](const ReportRow& row) { return row.isHeading() && row.label == QString::fromLatin1(heading); });
    const auto found = std::find_if(head, rows.end(),
                                    [label](const ReportRow& row) { return row.label == QString::fromLatin1(label); });
    return found != rows.end() ? found->values : QStringList();
}

// REQ-REPORT-01: The report has RMS, median, 95 % and peak of the pointing error, and the time beyond half of the beam,
// after the first second on target.
TEST(PassSummaryTest, TheErrorCountsAfterTheFirstSecondOnTarget)
{
    const PassSummary summary = summarised(drivenPass());
    EXPECT_NEAR(summary.untilOnTarget.value().count(), 1.0, kTiny);
    const ErrorSummary error = summary.error.value();
    EXPECT_NEAR(error.counted.count(), 2.0, kTiny);
    // (16 · 0.09 + 3 · 0.16 + 1.44) / 20 = 0.168
    EXPECT_NEAR(error.rms.degrees(), std::sqrt(0.168), kTiny);
    EXPECT_NEAR(error.median.degrees(), 0.3, kTiny);
    EXPECT_NEAR(error.most95.degrees(), 0.4, kTiny);
    EXPECT_NEAR(error.peak.degrees(), 1.2, kTiny);
    EXPECT_EQ(error.peakAt, drivenAt(37));
    EXPECT_NEAR(error.peakTarget.value().elevation.degrees(), 47.0, kTiny);
    EXPECT_FALSE(error.peakLoss) << "1.2 deg is beyond the main lobe of 1 deg";
    EXPECT_NEAR(error.beyond.value().count(), 0.1, kTiny);
    EXPECT_NEAR(summary.highest.value().elevation.degrees(), 49.0, kTiny);
}

// The target is crossed for 0.9 s during the slew.
TEST(PassSummaryTest, ABeamThatCrossesTheTargetIsNotOnTarget)
{
    std::vector<double> errors(5, 9.0);
    errors.insert(errors.end(), 9, 0.2);
    errors.insert(errors.end(), 6, 9.0);
    errors.insert(errors.end(), 12, 0.1);
    EXPECT_NEAR(summarised(drivenPass(errors)).untilOnTarget.value().count(), 2.0, kTiny);
    const PassSummary never = summarised(drivenPass(std::vector<double>(30, 2.0)));
    EXPECT_FALSE(never.untilOnTarget);
    EXPECT_NEAR(never.error.value().rms.degrees(), 2.0, kTiny);
    EXPECT_NEAR(never.error.value().beyond.value().count(), 3.0, kTiny);
}

TEST(PassSummaryTest, WithoutABeamWidthThereIsNoTimeBeyondIt)
{
    Recording recording = drivenPass();
    recording.header.beamWidth = Angle();
    const ErrorSummary error = summarised(recording).error.value();
    EXPECT_FALSE(error.beyond);
    EXPECT_FALSE(error.peakLoss);
    EXPECT_NEAR(error.peak.degrees(), 1.2, kTiny);
    recording.ticks[12].error.reset();
    EXPECT_TRUE(summarised(recording).error);
}

// REQ-REPORT-02: The report has the largest torque and the highest speed of each axis, with the time and the angle of
// the axis.
TEST(PassSummaryTest, TheLargestTorqueHasItsPlace)
{
    Recording recording = drivenPass();
    recording.ticks[5].axes[0].torque = -2.5;
    recording.ticks[7].axes[1].rate = AngularRate::fromDegrees(-4.0);
    const PassSummary summary = summarised(recording);
    const Extreme torque = summary.axis(Axis::Azimuth).torque.value();
    EXPECT_NEAR(torque.value, -2.5, kTiny);
    EXPECT_EQ(torque.utc, drivenAt(5));
    EXPECT_NEAR(torque.position.value().degrees(), 460.0, kTiny);
    EXPECT_NEAR(summary.axis(Axis::Azimuth).meanTorque.value(), (39 * 0.5 + 2.5) / 40, kTiny);
    EXPECT_NEAR(summary.axis(Axis::Elevation).rate.value().value, -4.0, kTiny);
    EXPECT_EQ(summary.axis(Axis::Elevation).rate.value().utc, drivenAt(7));
}

// REQ-REPORT-03: The report compares the pass with its plan: the expected error, and how far the axes were from the
// plan.
TEST(PassSummaryTest, ThePlanStandsBesideWhatWasDriven)
{
    Recording recording = drivenPass();
    recording.plan = planOfDrivenPass(0, 39);
    const PlanSummary plan = summarised(recording).plan.value();
    EXPECT_EQ(plan.way, plan::PlanWay::OverTheTop);
    EXPECT_NEAR(plan.azimuthOff.value().degrees(), 0.5, 1e-6);
    EXPECT_NEAR(plan.elevationOff.value().degrees(), 0.0, 1e-6);
    // The target is hidden in the tick with 1.2°, and the pass ends after the next one.
    recording.plan = planOfDrivenPass(0, 38);
    recording.plan->moments[37].isHidden = true;
    const ErrorSummary error = summarised(recording).error.value();
    EXPECT_NEAR(error.peak.degrees(), 0.4, kTiny);
    EXPECT_NEAR(error.counted.count(), 1.8, kTiny);
    recording.plan = planOfDrivenPass(5000, 5010);  // of another pass
    EXPECT_FALSE(summarised(recording).plan);
}

// REQ-REPORT-04: The report has the lost ticks and the time without ticks. Its numbers contain neither.
TEST(PassSummaryTest, AGapIsCounted)
{
    Recording recording = drivenPass();
    for (std::size_t i = 20; i < 40; ++i) {
        recording.ticks[i].utc += std::chrono::seconds(5);
    }
    recording.gaps.push_back({.from = drivenAt(20), .to = drivenAt(69), .ticks = 50});
    const PassSummary summary = summarised(recording);
    EXPECT_EQ(summary.lostTicks, 50U);
    EXPECT_NEAR(summary.withoutTicks.count(), 5.0, kTiny);
    EXPECT_NEAR(summary.error.value().counted.count(), 2.0, kTiny);
}

// REQ-REPORT-05: A recording without ticks gives no report. A sentence says why. A report of a damaged recording says
// that parts are missing.
TEST(PassSummaryTest, AnEmptyRecordingHasNoReport)
{
    Recording empty = drivenPass({});
    EXPECT_EQ(summaryOf(empty).error().text,
              QStringLiteral("The recording has no ticks. It ended before the mount was measured."));
    empty.problems << QStringLiteral("Bytes 10 to 20 are damaged.");
    EXPECT_EQ(summaryOf(empty).error().text,
              QStringLiteral("The recording has no readable ticks. Bytes 10 to 20 are damaged."));
    Recording cut = drivenPass();
    EXPECT_EQ(cautionText(summarised(cut)), QString());
    cut.hasEnd = false;
    cut.problems << QStringLiteral("Bytes 10 to 20 are damaged.") << QStringLiteral("There is no end.");
    EXPECT_EQ(cautionText(summarised(cut)),
              QStringLiteral("Parts of the file could not be read: 1. The recording ended without an orderly end."));
}

// REQ-REPORT-06: The table has a column for each pass.
TEST(PassSummaryTest, TwoPassesStandSideBySide)
{
    Recording second = drivenPass(std::vector<double>(30, 0.25));
    second.header.client = QStringLiteral("rotctld 127.0.0.1:51234");
    second.plan = planOfDrivenPass(0, 39);
    const std::array passes{summarised(drivenPass()), summarised(second)};
    const std::vector<ReportRow> rows = tableOf(passes);
    EXPECT_EQ(rowValues(rows, "Pass", "Tracked by"),
              (QStringList{QStringLiteral("Boresight"), QStringLiteral("rotctld 127.0.0.1:51234")}));
    EXPECT_EQ(rowValues(rows, "Pass", "On target after"),
              (QStringList{QStringLiteral("1.0 s"), QStringLiteral("0.0 s")}));
    EXPECT_EQ(rowValues(rows, "Pointing error", "RMS"),
              (QStringList{QStringLiteral("0.410°"), QStringLiteral("0.250°")}));
    EXPECT_EQ(rowValues(rows, "Pointing error", "Peak"),
              (QStringList{QStringLiteral("1.200°, beyond the main lobe"), QStringLiteral("0.250°, −0.75 dB")}));
    EXPECT_EQ(rowValues(rows, "Pointing error", "Peak at"),
              (QStringList{QStringLiteral("11:06:43, 100.0° / 47.0°"), QStringLiteral("11:06:41, 100.0° / 20.0°")}));
    EXPECT_EQ(rowValues(rows, "Pointing error", "Beyond half of the beam"),
              (QStringList{QStringLiteral("0.1 s of 2.0 s"), QStringLiteral("0.0 s of 2.0 s")}));
    EXPECT_EQ(rowValues(rows, "Plan", "Way"), (QStringList{QStringLiteral("–"), QStringLiteral("over the top")}));
    EXPECT_EQ(rowValues(rows, "Plan", "Azimuth off the plan").back(), QStringLiteral("0.500°"));
    EXPECT_EQ(rowValues(rows, "Azimuth", "Largest torque").front(), QStringLiteral("0.50 Nm at 460.0°, 11:06:40"));
    EXPECT_EQ(targetText(second.header), QStringLiteral("NOAA 19 (33591)"));
    EXPECT_EQ(spanText(passes[0].from, passes[0].to), QStringLiteral("2026-11-18 11:06:40 to 11:06:43 UTC"));
}

// REQ-REPORT-07: If the page has no room for all events, alarms and warnings come before the beginnings of motions and
// other events. Lines of clients are not in the report.
TEST(PassSummaryTest, TheEventsThatMatterComeFirst)
{
    Recording recording = drivenPass();
    const auto event = [](int tick, EventKind kind, EventLevel level, const char* text) {
        return Event{.utc = drivenAt(tick), .kind = kind, .level = level, .text = QString::fromLatin1(text)};
    };
    recording.events = {event(0, EventKind::MotionStart, EventLevel::Advisory, "motion"),
                        event(1, EventKind::ClientLine, EventLevel::Alarm, "client"),
                        event(2, EventKind::Event, EventLevel::Advisory, "event"),
                        event(3, EventKind::Alarm, EventLevel::Warning, "warning"),
                        event(4, EventKind::Alarm, EventLevel::Alarm, "alarm")};
    const auto texts = [&recording](std::size_t most) {
        QStringList all;
        for (const Event& one : importantEvents(recording, most)) {
            all << one.text;
        }
        return all.join(QLatin1Char(' ')).toStdString();
    };
    EXPECT_EQ(texts(9), "motion event warning alarm");
    EXPECT_EQ(texts(3), "motion warning alarm");
    EXPECT_EQ(texts(1), "alarm");
    const PassSummary summary = summarised(recording);
    EXPECT_EQ(summary.alarms, 1U);
    EXPECT_EQ(summary.warnings, 1U);
    EXPECT_EQ(summary.motions, 1U);
}

// REQ-REPORT-07
TEST(PassSummaryTest, EventsLongBeforeTheFirstTickAreNotOfThePass)
{
    Recording recording = drivenPass();
    recording.events = {{.utc = drivenAt(-11), .kind = EventKind::Alarm, .level = EventLevel::Alarm},
                        {.utc = drivenAt(-1), .kind = EventKind::MotionStart}};
    EXPECT_EQ(summarised(recording).alarms, 0U);
    EXPECT_EQ(summarised(recording).motions, 1U);
    EXPECT_EQ(importantEvents(recording, 9).size(), 1U);
}

}  // namespace
}  // namespace boresight::pass_report
