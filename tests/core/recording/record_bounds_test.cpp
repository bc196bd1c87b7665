// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/recording/block.h"
#include "core/recording/record_reader.h"
#include "core/recording/record_writer.h"
#include "tests/core/recording/recorded_pass.h"

#include <QtEndian>

#include <gmock/gmock.h>

#include <vector>

// Files that no program of Boresight writes. The reader runs in the process that moves the mount, so it has bounds.
// REQ-RECORD-18 (RecordBounds.*): No file costs the reader much time or memory: ticks, events, gaps, plans, blocks,
// problems and times have bounds. What is beyond them is left out, with a problem.
namespace boresight::recording {
namespace {

using testing::IsEmpty;
using testing::SizeIs;

Recording bounded(const QByteArray& blocks)
{
    const auto read = readRecording(fileStart(recordedHeader()) + blocks + fileEnd());
    EXPECT_TRUE(read) << read.error().text.toStdString();
    return read.value_or(Recording{});
}

// The beginning of a block of this length, without its content.
QByteArray blockClaim(std::uint32_t length)
{
    QByteArray bytes = kBlockMarker.toByteArray() + kEventBlock + QByteArray(4, '\0');
    qToLittleEndian(length, bytes.data() + kBlockMarker.size() + 1);
    return bytes;
}

TEST(RecordBounds, EventsHaveALimit)
{
    const QByteArray block = eventBlock(std::vector<Event>(50'000, {.utc = kRecordedFrom}));
    const Recording read = bounded(block.repeated(5));
    EXPECT_THAT(read.events, SizeIs(kMostEvents));
    EXPECT_THAT(read.problems, SizeIs(1));
    EXPECT_TRUE(read.hasEnd);
}

TEST(RecordBounds, GapsHaveALimit)
{
    const QByteArray block = gapBlock({.from = kRecordedFrom, .to = kRecordedFrom, .ticks = 1});
    const Recording read = bounded(block.repeated(kMostGaps + 2));
    EXPECT_THAT(read.gaps, SizeIs(kMostGaps));
    EXPECT_THAT(read.problems, SizeIs(2));
}

TEST(RecordBounds, PlansHaveALimit)
{
    const auto planned = [](Seconds toStart) {
        return planBlock({.moments = {{.utc = kRecordedFrom}}, .toStart = toStart});
    };
    const Recording read = bounded(planned(Seconds(1.0)).repeated(kMostPlans) + planned(Seconds(2.0)));
    ASSERT_TRUE(read.plan);
    EXPECT_EQ(read.plan->toStart, Seconds(1.0));
    EXPECT_THAT(read.problems, SizeIs(1));
}

TEST(RecordBounds, ProblemsHaveALimit)
{
    const QByteArray strange = blockBytes(kEventBlock, "no JSON");
    const auto read = readRecording(fileStart(recordedHeader()) + strange.repeated(500));
    ASSERT_TRUE(read);
    ASSERT_THAT(read->problems, SizeIs(kMostProblems + 1));
    EXPECT_EQ(read->problems[kMostProblems - 1], QStringLiteral("further damage is not listed"));
    EXPECT_THAT(read->problems.last().toStdString(), testing::HasSubstr("has no end"));
    EXPECT_THAT(bounded(strange.repeated(99)).problems.last().toStdString(), testing::HasSubstr("not readable"));
}

TEST(RecordBounds, AHugeBlockIsDamage)
{
    const QByteArray fits = blockBytes('q', QByteArray(kMostContent, 'x'));
    EXPECT_TRUE(blockAt(fits));
    const QByteArray huge = blockBytes('q', QByteArray(kMostContent + 1, 'x'));
    EXPECT_EQ(coveredBytes(huge), 0);
    EXPECT_FALSE(blockAt(huge));
}

// Markers that promise large blocks, one in the other: each CRC would cover all that follow.
TEST(RecordBounds, ManyMarkersTakeNoLongTime)
{
    const std::vector<Tick> ticks = RecordedPass().ticks(10);
    const QByteArray claims = blockClaim(3'000'000).repeated(400'000);
    const Recording read = bounded(tickBlock(ticks) + claims + tickBlock(ticks));
    EXPECT_EQ(read.ticks, ticks) << "the rest is left out";
    EXPECT_THAT(read.problems, SizeIs(2)) << "the damage, and the missing end";
    const Recording few = bounded(tickBlock(ticks) + claims.first(900) + tickBlock(ticks));
    EXPECT_THAT(few.ticks, SizeIs(20));
}

TEST(RecordBounds, AUnitHasAPlausibleNumberOfSteps)
{
    const QByteArray header = fileStart(recordedHeader());
    const QByteArray json = blockAt(QByteArrayView(header).sliced(kFileMark.size() + 1))->content.toByteArray();
    const auto reads = [&json](const QByteArray& steps) {
        QByteArray other = json;
        other.replace("\"per_unit\":10000,", "\"per_unit\":" + steps + ",");
        EXPECT_NE(other, json);
        return readHeader(kFileMark.toByteArray() + kFormatVersion + blockBytes(kHeaderBlock, other)).has_value();
    };
    EXPECT_TRUE(reads("1e-6"));
    EXPECT_TRUE(reads("1e9"));
    for (const char* strange : {"9e-7", "1.1e9", "0", "-1", "1e-320", "\"x\""}) {
        EXPECT_FALSE(reads(strange)) << strange;
    }
}

TEST(RecordBounds, OtherCenturiesAreLeftOut)
{
    constexpr UtcTime kEarly{std::chrono::sys_days{std::chrono::year{1999} / 12 / 31}};
    constexpr UtcTime kLate{std::chrono::sys_days{std::chrono::year{2200} / 1 / 1}};
    for (const UtcTime strange : {kEarly, kLate, UtcTime()}) {
        const Recording read = bounded(
            tickBlock(std::vector{Tick{.utc = strange}}) + eventBlock(std::vector{Event{.utc = strange}}) +
            gapBlock({.from = kRecordedFrom, .to = strange, .ticks = 1}) + planBlock({.moments = {{.utc = strange}}}));
        EXPECT_THAT(read.ticks, IsEmpty());
        EXPECT_THAT(read.events, IsEmpty());
        EXPECT_THAT(read.gaps, IsEmpty());
        EXPECT_FALSE(read.plan);
        EXPECT_THAT(read.problems, SizeIs(4));
    }
}

// REQ-RECORD-19: Control characters in the texts of a recording do not reach a terminal, a window or a report.
TEST(RecordTexts, ControlCharactersAreReplaced)
{
    Header header = recordedHeader();
    header.target = QStringLiteral("NOAA\x1b[2J 19");
    header.stateWords = {QStringLiteral("HOLD\n")};
    const Event event{.utc = kRecordedFrom, .source = QStringLiteral("a\rb"), .text = QStringLiteral("é\t\u009b°")};
    const auto read = readRecording(fileStart(header) + eventBlock(std::vector{event}) + fileEnd());
    ASSERT_TRUE(read);
    EXPECT_EQ(read->header.target, QStringLiteral("NOAA\uFFFD[2J 19"));
    EXPECT_EQ(read->header.stateWords, QStringList{QStringLiteral("HOLD\uFFFD")});
    ASSERT_THAT(read->events, SizeIs(1));
    EXPECT_EQ(read->events[0].source, QStringLiteral("a\uFFFDb"));
    EXPECT_EQ(read->events[0].text, QStringLiteral("é\uFFFD\uFFFD°"));
}

}  // namespace
}  // namespace boresight::recording
