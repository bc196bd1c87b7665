// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/recording/block.h"
#include "core/recording/record_reader.h"
#include "core/recording/record_writer.h"
#include "tests/core/recording/recorded_pass.h"

#include <QFile>
#include <QTemporaryDir>

#include <gmock/gmock.h>

#include <algorithm>
#include <limits>
#include <span>

namespace boresight::recording {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using testing::SizeIs;

const std::vector<Event>& recordedEvents()
{
    static const std::vector<Event> all{{.utc = kRecordedFrom + std::chrono::milliseconds(40),
                                         .kind = EventKind::MotionStart,
                                         .level = EventLevel::Advisory,
                                         .source = QStringLiteral("rotctld 127.0.0.1:51234"),
                                         .text = QStringLiteral("tracks P 180.00 10.00")},
                                        {.utc = kRecordedFrom + std::chrono::seconds(2),
                                         .kind = EventKind::Alarm,
                                         .level = EventLevel::Warning,
                                         .source = QStringLiteral("azimuth drive"),
                                         .text = QStringLiteral("The board is hot: 71 °C")},
                                        {.utc = kRecordedFrom + std::chrono::seconds(3),
                                         .kind = EventKind::ClientLine,
                                         .level = EventLevel::Advisory,
                                         .source = QStringLiteral("rotctld 127.0.0.1:51234"),
                                         .text = QStringLiteral("P 180.00 10.00 -> RPRT 0")}};
    return all;
}

plan::PlanVariant recordedPlan()
{
    plan::PlanVariant variant{
        .way = plan::PlanWay::OverTheTop,
        .forecast =
            {.peak = 0.125_deg, .rms = 0.0625_deg, .beyond = Seconds(1.5), .hidden = Seconds(2.0), .peakLoss = 0.25},
        .ramp = plan::PlanSpan{kRecordedFrom + std::chrono::seconds(100), kRecordedFrom + std::chrono::seconds(120)},
        .toStart = Seconds(12.0),
        .margin = 90_deg};
    for (int i = 0; i < 100; ++i) {
        const Angle azimuth = Angle::fromDegrees((1'900'000 - 3'000 * i) / 1e4);
        variant.moments.push_back({.utc = kRecordedFrom + std::chrono::seconds(i),
                                   .target = {azimuth, 45_deg},
                                   .axes = {azimuth, 135_deg},
                                   .rates = {AngularRate::fromDegrees(-0.3), AngularRate{}},
                                   .error = Angle::fromDegrees(i / 1e4),
                                   .isHidden = i > 90});
    }
    return variant;
}

QByteArray wholeFile(const std::vector<Tick>& ticks)
{
    QByteArray bytes = fileStart(recordedHeader());
    bytes += planBlock(recordedPlan());
    bytes += eventBlock(recordedEvents());
    constexpr std::size_t kBlockTicks = 250;
    for (std::size_t i = 0; i < ticks.size(); i += kBlockTicks) {
        bytes += tickBlock(std::span(ticks).subspan(i, std::min(kBlockTicks, ticks.size() - i)));
    }
    bytes += gapBlock({.from = kRecordedFrom, .to = kRecordedFrom + std::chrono::seconds(4), .ticks = 200});
    return bytes + fileEnd();
}

TEST(RecordedFile, ReadsAsItWasWritten)
{
    const std::vector<Tick> ticks = RecordedPass().ticks(1'201);
    const auto read = readRecording(wholeFile(ticks));
    ASSERT_TRUE(read) << read.error().text.toStdString();
    EXPECT_EQ(read->header, recordedHeader());
    EXPECT_EQ(read->ticks, ticks);
    EXPECT_EQ(read->events, recordedEvents());
    EXPECT_EQ(read->plan, recordedPlan());
    EXPECT_THAT(read->gaps, ElementsAre(Gap{kRecordedFrom, kRecordedFrom + std::chrono::seconds(4), 200}));
    EXPECT_TRUE(read->hasEnd);
    EXPECT_THAT(read->problems, IsEmpty());
    EXPECT_EQ(read->header.stateWord(read->ticks.back().state), QStringLiteral("TRACK"));
}

// REQ-RECORD-05: The bytes of a recording do not change without a new version of the format.
TEST(RecordedFile, HasTheBytesOfThePage)
{
    EXPECT_EQ(crc32("123456789"), 0xCBF43926U);
    EXPECT_EQ(fileStart({}).first(13).toHex(), "8942504153530d0a01b5424c4b");
    EXPECT_EQ(fileEnd().toHex(), "b5424c4b5a000000002466d51b");
    // One row. The channel utc is the constant 10000 of 0.1 ms, and the other 35 channels are unknown.
    const Tick second{.utc = UtcTime(std::chrono::seconds(1))};
    EXPECT_EQ(tickBlock(std::vector{second}).toHex(), QByteArray("b5424c4b54"
                                                                 "28000000"
                                                                 "01"
                                                                 "01a09c01") +
                                                          QByteArray(70, '0') + "adcd7bfd");
    const QByteArray header = fileStart({});
    EXPECT_THAT(header.toStdString(), testing::HasSubstr(R"("channels":[{"name":"utc","per_unit":10000,"unit":"s"},)"));
}

TEST(RecordedFile, UnknownValuesStayUnknown)
{
    const std::vector<Tick> ticks{Tick{.utc = kRecordedFrom}, Tick{.utc = kRecordedFrom, .wind = 4.5}};
    const auto read = readRecording(fileStart({}) + tickBlock(ticks) + fileEnd());
    ASSERT_TRUE(read);
    EXPECT_EQ(read->ticks, ticks);
    EXPECT_EQ(read->header, Header{});
}

// A number that no sensor measures is no number in the file.
TEST(RecordedFile, NumbersBeyondAnyMeasurementAreUnknown)
{
    Tick strange{.utc = kRecordedFrom, .wind = std::numeric_limits<double>::infinity()};
    strange.axes[0].torque = std::numeric_limits<double>::quiet_NaN();
    strange.axes[1].torque = 1e300;
    const auto read = readRecording(fileStart({}) + tickBlock(std::vector{strange}) + fileEnd());
    ASSERT_TRUE(read);
    EXPECT_THAT(read->ticks, ElementsAre(Tick{.utc = kRecordedFrom}));
}

// REQ-RECORD-01: A recording that ends anywhere, as by a power loss, reads up to its last whole block.
TEST(RecordedFile, CutAnywhereItReadsUpToTheLastWholeBlock)
{
    const std::vector<Tick> ticks = RecordedPass().ticks(60);
    const QByteArray start = fileStart(recordedHeader());
    const QByteArray first = tickBlock(std::span(ticks).first(30));
    const QByteArray bytes = start + first + tickBlock(std::span(ticks).last(30)) + fileEnd();
    for (qsizetype size = 0; size < bytes.size(); ++size) {
        const auto read = readRecording(QByteArrayView(bytes).first(size));
        EXPECT_EQ(read.has_value(), size >= start.size()) << size;
        if (read) {
            const std::size_t whole = size < start.size() + first.size() ? 0 : 30;
            EXPECT_THAT(read->ticks, SizeIs(size < bytes.size() - kBlockFrame ? whole : 60)) << size;
            EXPECT_THAT(read->problems, testing::Not(IsEmpty()));
            EXPECT_FALSE(read->hasEnd);
        } else {
            EXPECT_FALSE(read.error().text.isEmpty());
        }
    }
}

// REQ-RECORD-02: A damaged byte costs its own block. The program names the bytes that it left out.
TEST(RecordedFile, ADamagedByteCostsItsOwnBlock)
{
    const std::vector<Tick> ticks = RecordedPass().ticks(60);
    const QByteArray start = fileStart(recordedHeader());
    const QByteArray first = tickBlock(std::span(ticks).first(30));
    const QByteArray bytes = start + first + tickBlock(std::span(ticks).last(30)) + fileEnd();
    for (qsizetype at = 0; at < bytes.size(); ++at) {
        for (const char change : {'\x01', '\x80', '\xff'}) {
            QByteArray damaged = bytes;
            damaged[at] = static_cast<char>(damaged[at] ^ change);
            const auto read = readRecording(damaged);
            EXPECT_EQ(read.has_value(), at >= start.size()) << at;
            if (read) {
                const bool isEnd = at >= bytes.size() - kBlockFrame;
                EXPECT_THAT(read->ticks, SizeIs(isEnd ? 60 : 30)) << at;
                EXPECT_EQ(read->hasEnd, !isEnd);
                const qsizetype block = at < start.size() + first.size() ? start.size() : start.size() + first.size();
                EXPECT_TRUE(isEnd || read->problems.first().contains(QString::number(block)))
                    << read->problems.first().toStdString();
            }
        }
    }
}

// Damage that the CRC does not show, as by a program that writes wrong contents.
TEST(RecordedFile, WrongContentsAreNamed)
{
    const std::vector<Tick> ticks = RecordedPass().ticks(40);
    const QByteArray start = fileStart(recordedHeader());
    for (const QByteArray& good :
         {tickBlock(ticks), planBlock(recordedPlan()), eventBlock(recordedEvents()), gapBlock(Gap{.ticks = 3})}) {
        const auto block = blockAt(good);
        ASSERT_TRUE(block);
        for (qsizetype at = 0; at < block->content.size(); ++at) {
            for (const char change : {'\x01', '\x80', '\xff'}) {
                QByteArray content = block->content.toByteArray();
                content[at] = static_cast<char>(content[at] ^ change);
                EXPECT_TRUE(readRecording(start + blockBytes(block->kind, content) + fileEnd()));
            }
            const QByteArray cut = block->content.first(at).toByteArray();
            const auto read = readRecording(start + blockBytes(block->kind, cut) + fileEnd());
            ASSERT_TRUE(read);
            EXPECT_THAT(read->problems, SizeIs(1)) << block->kind << at;
        }
    }
}

TEST(RecordedFile, ForeignBytesAreRefusedWithTheReason)
{
    EXPECT_THAT(readRecording({}).error().text.toStdString(), testing::HasSubstr("not a recording"));
    EXPECT_THAT(readRecording("id,utc\n1,2\n").error().text.toStdString(), testing::HasSubstr("not a recording"));
    QByteArray later = fileStart(recordedHeader());
    later[kFileMark.size()] = 9;
    EXPECT_THAT(readRecording(later).error().text.toStdString(), testing::HasSubstr("version 9"));
}

// REQ-RECORD-03: A program reads the recordings of later programs of the same format: it passes over blocks and
// channels that it does not know.
TEST(RecordedFile, BlocksAndChannelsOfLaterProgramsArePassedOver)
{
    QByteArray json =
        blockAt(QByteArrayView(fileStart(recordedHeader())).sliced(kFileMark.size() + 1))->content.toByteArray();
    ASSERT_EQ(json.count("\"wind\""), 1);
    json.replace("\"wind\"", "\"tide\"");
    const QByteArray start = kFileMark.toByteArray() + kFormatVersion + blockBytes(kHeaderBlock, json);
    const std::vector<Tick> ticks = RecordedPass().ticks(3);
    const auto read = readRecording(start + blockBytes('q', "new") + tickBlock(ticks) + fileEnd());
    ASSERT_TRUE(read);
    EXPECT_THAT(read->problems, IsEmpty());
    std::vector<Tick> without = ticks;
    std::ranges::for_each(without, [](Tick& tick) { tick.wind.reset(); });
    EXPECT_EQ(read->ticks, without);
}

// REQ-RECORD-04: A day of 50 ticks in each second with all channels, of a mount with noisy sensors, takes at most
// 200 MB.
TEST(RecordedFile, ADayTakesAtMost200Megabytes)
{
    RecordedPass pass;
    constexpr int kBlocks = 60;
    constexpr std::size_t kBlockTicks = 500;
    qsizetype bytes = 0;
    for (int i = 0; i < kBlocks; ++i) {
        bytes += tickBlock(pass.ticks(kBlockTicks)).size();
    }
    constexpr double kDayTicks = 50.0 * 86'400.0;
    const double perTick = static_cast<double>(bytes) / (kBlocks * kBlockTicks);
    RecordProperty("bytes_per_tick", std::to_string(perTick));
    EXPECT_LT(perTick * kDayTicks, 200e6) << perTick << " bytes in each tick";
}

TEST(RecordedFile, AFileIsReadByItsName)
{
    const QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("one.pass"));
    QFile file(path);
    ASSERT_TRUE(file.open(QIODevice::WriteOnly));
    file.write(wholeFile(RecordedPass().ticks(10)));
    file.close();
    EXPECT_THAT(loadRecording(path)->ticks, SizeIs(10));
    EXPECT_EQ(*loadHeader(path), recordedHeader());
    const auto missing = loadRecording(folder.filePath(QStringLiteral("none.pass")));
    ASSERT_FALSE(missing);
    EXPECT_THAT(missing.error().text.toStdString(), testing::HasSubstr("none.pass"));
}

}  // namespace
}  // namespace boresight::recording
