// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/recorder/pass_recorder.h"

#include "core/recording/record_reader.h"
#include "tests/core/recording/recorded_pass.h"
#include "tests/fakes/manual_clock.h"

#include <QDeadlineTimer>
#include <QDir>
#include <QFile>
#include <QTemporaryDir>

#include <gmock/gmock.h>

#include <atomic>
#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <thread>

namespace boresight::recorder {
namespace {

using namespace std::chrono_literals;
using testing::ElementsAre;
using testing::IsEmpty;
using testing::SizeIs;

// A disk that hangs or fails on request. Any thread.
class GatedDisk
{
public:
    [[nodiscard]] Result<> append(const QString& path, const QByteArray& bytes)
    {
        std::unique_lock lock(m_mutex);
        ++m_calls;
        m_changed.notify_all();
        m_changed.wait(lock, [this] { return !m_hangs; });
        return m_fails || QFile::exists(m_fullBy) ? failure(ErrorCode::Io, QStringLiteral("no space left on device"))
                                                  : appendWhole(path, bytes);
    }
    void setHanging(bool hangs)
    {
        change([&] { m_hangs = hangs; });
    }
    void setFailing(bool fails)
    {
        change([&] { m_fails = fails; });
    }
    // Nothing can be written while this file exists.
    void setFull(const QString& by)
    {
        change([&] { m_fullBy = by; });
    }
    // Returns when this number of writes has begun.
    void waitForCalls(int count)
    {
        std::unique_lock lock(m_mutex);
        m_changed.wait(lock, [&] { return m_calls >= count; });
    }

private:
    void change(const std::function<void()>& by)
    {
        const std::lock_guard lock(m_mutex);
        by();
        m_changed.notify_all();
    }

    std::mutex m_mutex;
    std::condition_variable m_changed;
    bool m_hangs = false;
    bool m_fails = false;
    QString m_fullBy;
    int m_calls = 0;
};

class PassRecorderTest : public testing::Test
{
protected:
    PassRecorderTest()
    {
        QObject::connect(m_recorder.get(), &PassRecorder::troubled,
                         [this](const QString& reason) { m_troubles.push_back(reason.toStdString()); });
    }

    void pass(std::size_t ticks)
    {
        for (std::size_t i = 0; i < ticks; ++i) {
            m_recorder->add(m_pass.next());
            m_clock.advance(20ms);
            m_recorder->tick();
        }
    }
    // Ticks until the condition is true. The clock stands still.
    [[nodiscard]] bool ticksUntil(const std::function<bool()>& condition)
    {
        const QDeadlineTimer limit(std::chrono::minutes(1));
        while (!condition() && !limit.hasExpired()) {
            m_recorder->tick();
            std::this_thread::yield();
        }
        return condition();
    }
    [[nodiscard]] QStringList files() const { return QDir(m_folder.path()).entryList(QDir::Files, QDir::Name); }
    [[nodiscard]] recording::Recording read(const QString& name) const
    {
        const auto loaded = recording::loadRecording(m_folder.filePath(name));
        EXPECT_TRUE(loaded) << loaded.error().text.toStdString();
        return loaded.value_or(recording::Recording{});
    }
    // Ends the recording, and waits until all is written.
    void finish()
    {
        m_recorder->end();
        EXPECT_TRUE(ticksUntil([this] { return m_recorder->isIdle(); }));
    }
    // The first file with such a name has ticks.
    [[nodiscard]] bool hasTicks(const QString& pattern = QStringLiteral("*")) const
    {
        const QStringList found = QDir(m_folder.path()).entryList({pattern}, QDir::Files, QDir::Name);
        const auto loaded = recording::loadRecording(m_folder.filePath(found.value(0)));
        return loaded && !loaded->ticks.empty();
    }
    // The only file, as soon as it is written completely.
    [[nodiscard]] recording::Recording finished()
    {
        finish();
        EXPECT_THAT(files(), SizeIs(1));
        return read(files().value(0));
    }

    QTemporaryDir m_folder;
    fakes::ManualClock m_clock;
    // Shared with the worker, which may outlive a recorder that has lost its patience.
    std::shared_ptr<GatedDisk> m_disk = std::make_shared<GatedDisk>();
    recording::RecordedPass m_pass;
    std::vector<std::string> m_troubles;
    std::unique_ptr<PassRecorder> m_recorder = std::make_unique<PassRecorder>(
        m_folder.path(), m_clock, nullptr,
        [disk = m_disk](const QString& path, const QByteArray& bytes) { return disk->append(path, bytes); });
};

// REQ-RECORD-07: A recording has every tick from its beginning to its end, the events and the plan.
TEST_F(PassRecorderTest, ARecordingHasEveryTick)
{
    m_recorder->begin(recording::recordedHeader());
    m_recorder->add(recording::Event{.utc = recording::kRecordedFrom, .text = QStringLiteral("begins")});
    m_recorder->notePlan({.moments = {{.utc = recording::kRecordedFrom}}});
    pass(1'234);
    EXPECT_TRUE(m_recorder->isRecording());
    const recording::Recording whole = finished();
    EXPECT_EQ(whole.ticks, recording::RecordedPass().ticks(1'234));
    EXPECT_EQ(whole.header, recording::recordedHeader());
    EXPECT_THAT(whole.events, SizeIs(1));
    EXPECT_TRUE(whole.plan);
    EXPECT_TRUE(whole.hasEnd);
    EXPECT_THAT(whole.problems, IsEmpty());
    EXPECT_THAT(m_troubles, IsEmpty());
}

TEST_F(PassRecorderTest, WithoutARecordingNothingIsStored)
{
    pass(1'000);
    m_recorder->add(recording::Event{.text = QStringLiteral("unheard")});
    m_recorder->notePlan({.moments = {{}}});
    EXPECT_TRUE(m_recorder->isIdle());
    EXPECT_THAT(files(), IsEmpty());
}

// REQ-RECORD-01
TEST_F(PassRecorderTest, APowerLossCostsAtMostTheLastBlock)
{
    m_recorder->begin(recording::recordedHeader());
    pass(501);
    ASSERT_TRUE(ticksUntil([this] { return hasTicks(); }));
    const recording::Recording early = read(files().first());
    EXPECT_GE(early.ticks.size(), 499U);
    EXPECT_FALSE(early.hasEnd);
}

// REQ-RECORD-08: A disk that does not answer delays no control tick. 10 minutes of ticks wait in memory. Further ticks
// are lost, the file has a gap with their number, and one alarm is raised until the disk answers.
TEST_F(PassRecorderTest, ADiskThatHangsDelaysNothingAndLeavesAGap)
{
    m_disk->setHanging(true);
    m_recorder->begin(recording::recordedHeader());
    pass(PassRecorder::kMostWaiting + 700);
    m_disk->waitForCalls(1);
    pass(300);
    EXPECT_EQ(m_recorder->lostTicks(), 1'000U);
    EXPECT_THAT(m_troubles, ElementsAre("the disk does not answer"));
    m_disk->setHanging(false);
    ASSERT_TRUE(ticksUntil([this] { return m_troubles.size() == 2; }));
    EXPECT_EQ(m_troubles.back(), "");
    pass(100);
    const recording::Recording whole = finished();
    const std::vector<recording::Tick> all = recording::RecordedPass().ticks(PassRecorder::kMostWaiting + 1'100);
    ASSERT_THAT(whole.gaps, SizeIs(1));
    EXPECT_EQ(whole.gaps[0].ticks, 1'000U);
    EXPECT_LE(abs(whole.gaps[0].from - all[PassRecorder::kMostWaiting].utc), 1ms);
    EXPECT_LE(abs(whole.gaps[0].to - all[PassRecorder::kMostWaiting + 999].utc), 1ms);
    ASSERT_THAT(whole.ticks, SizeIs(PassRecorder::kMostWaiting + 100));
    EXPECT_EQ(whole.ticks.back(), all.back());
}

// REQ-RECORD-09: A write that fails is repeated, and nothing is lost that fits into the memory.
TEST_F(PassRecorderTest, AFullDiskIsTriedAgain)
{
    m_disk->setFailing(true);
    m_recorder->begin(recording::recordedHeader());
    pass(502);
    ASSERT_TRUE(ticksUntil([this] { return !m_troubles.empty(); }));
    EXPECT_THAT(m_troubles, ElementsAre("no space left on device"));
    pass(10);
    m_disk->setFailing(false);
    pass(300);
    ASSERT_TRUE(ticksUntil([this] { return m_troubles.size() == 2; }));
    EXPECT_EQ(m_troubles.back(), "");
    EXPECT_EQ(finished().ticks, recording::RecordedPass().ticks(812));
}

TEST_F(PassRecorderTest, TheHeaderMayBecomeKnownWithinTheFirstBlock)
{
    recording::Header unnamed = recording::recordedHeader();
    unnamed.target.clear();
    m_recorder->begin(unnamed);
    pass(100);
    m_recorder->describe(recording::recordedHeader());
    EXPECT_EQ(finished().header, recording::recordedHeader());
}

TEST_F(PassRecorderTest, EachRecordingHasItsFile)
{
    m_recorder->begin(recording::recordedHeader());
    pass(10);
    m_recorder->begin(recording::recordedHeader());  // in the same second
    pass(20);
    finish();
    ASSERT_THAT(files(), SizeIs(2));
    EXPECT_EQ(read(files()[0]).ticks.size() + read(files()[1]).ticks.size(), 30U);
}

// A recording that somebody deletes goes on in a new file, which is readable.
TEST_F(PassRecorderTest, AFileThatIsDeletedBeginsAgain)
{
    m_recorder->begin(recording::recordedHeader());
    pass(501);
    ASSERT_TRUE(ticksUntil([this] { return hasTicks(); }));
    ASSERT_TRUE(QFile::remove(m_folder.filePath(files().first())));
    pass(5);
    EXPECT_THAT(finished().ticks, testing::Not(IsEmpty()));
}

// REQ-RECORD-06
TEST_F(PassRecorderTest, ABeginningRecordingDeletesOldOnes)
{
    const QString old = recordingName(recording::kRecordedFrom - 48h, QStringLiteral("OLD"));
    ASSERT_TRUE(appendWhole(m_folder.filePath(old), "old"));
    m_recorder->setLimits({.age = std::chrono::days(1)});
    m_recorder->begin(recording::recordedHeader());
    pass(10);
    EXPECT_THAT(finished().ticks, SizeIs(10));
    EXPECT_FALSE(QFile::exists(m_folder.filePath(old)));
}

TEST_F(PassRecorderTest, RecordingsThatWaitForTheDiskAreLimited)
{
    m_disk->setHanging(true);
    for (std::size_t i = 0; i < 3 * PassRecorder::kMostFiles; ++i) {
        m_recorder->begin(recording::recordedHeader());
        pass(2);
    }
    EXPECT_FALSE(m_recorder->isRecording());
    EXPECT_THAT(m_troubles, ElementsAre("the disk does not answer"));
    m_disk->setHanging(false);
    finish();
    EXPECT_THAT(files(), SizeIs(PassRecorder::kMostFiles));
}

// REQ-RECORD-14: A write that lasts more than 20 s raises the alarm, before ticks are lost. The alarm ends with the
// write.
TEST_F(PassRecorderTest, AWriteThatLastsLongIsReported)
{
    m_disk->setHanging(true);
    m_recorder->begin(recording::recordedHeader());
    pass(502);
    m_disk->waitForCalls(1);
    m_clock.advance(PassRecorder::kSlow - 1s);
    m_recorder->tick();
    EXPECT_THAT(m_troubles, IsEmpty());
    m_clock.advance(2s);
    m_recorder->tick();
    m_recorder->tick();
    EXPECT_THAT(m_troubles, ElementsAre("the disk does not answer"));
    m_disk->setHanging(false);
    ASSERT_TRUE(ticksUntil([this] { return m_troubles.size() == 2; }));
    EXPECT_EQ(m_troubles.back(), "");
    EXPECT_EQ(m_recorder->lostTicks(), 0U);
    finish();
}

// REQ-RECORD-15: If a write fails, expired recordings are deleted by the limits now in force, and the write is repeated
// at once. The file in writing is never deleted.
TEST_F(PassRecorderTest, AFullDiskGetsRoomFromOldRecordings)
{
    const QString old = recordingName(recording::kRecordedFrom - 1h, QStringLiteral("OLD"));
    ASSERT_TRUE(appendWhole(m_folder.filePath(old), QByteArray(5'000, 'x')));
    m_recorder->begin(recording::recordedHeader());
    pass(501);
    ASSERT_TRUE(ticksUntil([this] { return hasTicks(QStringLiteral("*NOAA*")); }));
    m_disk->setFull(m_folder.filePath(old));
    pass(502);
    ASSERT_TRUE(ticksUntil([this] { return !m_troubles.empty(); }));
    EXPECT_TRUE(QFile::exists(m_folder.filePath(old))) << "the limits permit it";
    m_recorder->setLimits({.age = std::nullopt, .bytes = 100});
    pass(300);
    ASSERT_TRUE(ticksUntil([this] { return m_troubles.size() == 2; }));
    EXPECT_EQ(m_troubles.back(), "");
    EXPECT_FALSE(QFile::exists(m_folder.filePath(old)));
    EXPECT_EQ(finished().ticks, recording::RecordedPass().ticks(1'303));
}

// REQ-RECORD-15
TEST_F(PassRecorderTest, TheFileInWritingIsNeverDeleted)
{
    m_recorder->setLimits({.age = std::nullopt, .bytes = 100});
    m_recorder->begin(recording::recordedHeader());
    pass(501);
    ASSERT_TRUE(ticksUntil([this] { return hasTicks(); }));
    m_disk->setFailing(true);
    pass(502);
    ASSERT_TRUE(ticksUntil([this] { return !m_troubles.empty(); }));
    m_disk->setFailing(false);
    m_clock.advance(PassRecorder::kRetry);
    EXPECT_EQ(finished().ticks, recording::RecordedPass().ticks(1'003));
}

// While the disk hangs, the target may become known after more than one job.
TEST_F(PassRecorderTest, TheHeaderMayBecomeKnownWhileTheDiskHangs)
{
    m_disk->setHanging(true);
    m_recorder->begin(recording::recordedHeader());
    pass(502);
    m_disk->waitForCalls(1);
    recording::Header unnamed = recording::recordedHeader();
    unnamed.target.clear();
    unnamed.began += 1h;
    m_recorder->begin(unnamed);
    pass(3 * RecordingJob::kMostTicks);
    recording::Header named = unnamed;
    named.target = QStringLiteral("NOAA 20");
    m_recorder->describe(named);
    m_disk->setHanging(false);
    finish();
    ASSERT_THAT(files(), SizeIs(2));
    EXPECT_EQ(read(files()[0]).header, recording::recordedHeader());
    EXPECT_EQ(read(files()[1]).header, named);
}

// At the end of the program all that waits is written.
TEST(PassRecorderEnd, WritesWhatWaits)
{
    const QTemporaryDir folder;
    const fakes::ManualClock clock;
    recording::RecordedPass source;
    {
        PassRecorder recorder(folder.path(), clock, nullptr, appendWhole, std::chrono::minutes(1));
        recorder.begin(recording::recordedHeader());
        for (std::size_t i = 0; i < 3 * RecordingJob::kMostTicks; ++i) {
            recorder.add(source.next());
        }
    }
    const QStringList files = QDir(folder.path()).entryList(QDir::Files);
    ASSERT_THAT(files, SizeIs(1));
    EXPECT_EQ(recording::loadRecording(folder.filePath(files[0]))->ticks,
              recording::RecordedPass().ticks(3 * RecordingJob::kMostTicks));
}

// REQ-RECORD-16: At the end of the program the recorder waits at most 2 s for the disk, for all that waits together.
TEST(PassRecorderEnd, BeginsNoWriteAfterItsPatience)
{
    const QTemporaryDir folder;
    const fakes::ManualClock clock;
    std::atomic<int> calls = 0;
    {
        PassRecorder recorder(
            folder.path(), clock, nullptr,
            [&calls](const QString&, const QByteArray&) {
                ++calls;
                return Result<>();
            },
            0ms);
        for (std::size_t i = 0; i < PassRecorder::kMostFiles; ++i) {
            recorder.begin(recording::recordedHeader());
        }
    }
    EXPECT_EQ(calls, 0) << "without patience no write begins";
}

}  // namespace
}  // namespace boresight::recorder
