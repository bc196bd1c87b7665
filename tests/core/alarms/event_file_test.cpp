// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/alarms/event_file.h"

#include "tests/fakes/manual_clock.h"

#include <QDeadlineTimer>
#include <QDir>
#include <QElapsedTimer>
#include <QFile>
#include <QTemporaryDir>

#include <gmock/gmock.h>
#include <sys/stat.h>

#include <functional>
#include <thread>

namespace boresight {
namespace {

using testing::ElementsAre;
using testing::EndsWith;
using testing::HasSubstr;

class EventFileTest : public testing::Test
{
protected:
    void build(const QString& stateDir)
    {
        m_path = stateDir + QStringLiteral("/events.log");
        file = std::make_unique<EventFile>(stateDir, log, clock);
        QObject::connect(file.get(), &EventFile::failed,
                         [this](const QString& reason) { failures.push_back(reason.toStdString()); });
        QObject::connect(file.get(), &EventFile::written, [this] { ++written; });
    }
    void add(const QString& text) { log.add(Severity::Advisory, QStringLiteral("test"), text); }
    // Ticks until the worker has answered this number of times. The clock stands still.
    [[nodiscard]] bool writes(int count)
    {
        return ticksUntil([this, count] { return written >= count; });
    }
    [[nodiscard]] bool fails(std::size_t count)
    {
        return ticksUntil([this, count] { return failures.size() >= count; });
    }
    [[nodiscard]] bool ticksUntil(const std::function<bool()>& condition)
    {
        const QDeadlineTimer limit(std::chrono::minutes(1));
        while (!condition() && !limit.hasExpired()) {
            file->tick();
            std::this_thread::yield();
        }
        return condition();
    }
    [[nodiscard]] std::vector<std::string> lines() const
    {
        QFile read(m_path);
        EXPECT_TRUE(read.open(QIODevice::ReadOnly));
        std::vector<std::string> all;
        while (!read.atEnd()) {
            all.push_back(read.readLine().trimmed().toStdString());
        }
        return all;
    }

    QTemporaryDir dir;
    fakes::ManualClock clock;
    EventLog log{clock};
    std::unique_ptr<EventFile> file;
    std::vector<std::string> failures;
    int written = 0;
    QString m_path;
};

// REQ-ALARMS-47 (EventFileTest.*): A worker writes the log file, never a tick, so a slow disk delays nothing. A write
// that fails raises an alarm and is tried again every 5 s. The alarm ends when a write succeeds. Meanwhile the newest
// 2000 entries wait, and the file says how many older ones were lost. The last entries are on the disk before the
// program ends, unless the disk hangs for 2 s.
TEST_F(EventFileTest, EachEntryIsOneLine)
{
    build(dir.path());
    file->tick();
    add(QStringLiteral("one"));
    add(QStringLiteral("two"));
    ASSERT_TRUE(writes(1));
    add(QStringLiteral("three"));
    ASSERT_TRUE(writes(2));
    EXPECT_THAT(lines(),
                ElementsAre("2026-11-21T00:00:00.000Z test: one", EndsWith("test: two"), EndsWith("test: three")));
    EXPECT_THAT(failures, ElementsAre());
}

TEST_F(EventFileTest, TheLastEntriesAreWrittenAtTheEnd)
{
    build(dir.path());
    add(QStringLiteral("one"));
    file->tick();
    add(QStringLiteral("two"));
    file.reset();
    EXPECT_THAT(lines(), ElementsAre(EndsWith("one"), EndsWith("two")));
}

TEST_F(EventFileTest, ALargeFileBecomesTheOldOne)
{
    build(dir.path());
    for (int i = 0; i < 8; ++i) {
        add(QString(1'000'000, QLatin1Char('x')));
    }
    file->tick();
    ASSERT_TRUE(writes(1));
    EXPECT_TRUE(QFile::exists(dir.filePath(QStringLiteral("events.log.1"))));
    EXPECT_LT(QFile(m_path).size(), EventFile::kLargest);
}

// Story: after one failed write nothing more was written to the file until the program was restarted.
TEST_F(EventFileTest, AFailedWriteIsTriedAgainAndNothingIsLost)
{
    const QString absent = dir.filePath(QStringLiteral("absent"));
    build(absent);
    add(QStringLiteral("one"));
    file->tick();
    ASSERT_TRUE(fails(1));
    EXPECT_THAT(failures.front(), HasSubstr("cannot write " + m_path.toStdString()));
    add(QStringLiteral("two"));
    file->tick();
    clock.advance(EventFile::kRetry - Seconds(0.1));
    file->tick();
    clock.advance(Seconds(0.2));
    file->tick();
    ASSERT_TRUE(fails(2));
    EXPECT_EQ(failures.size(), 2U) << "not at each tick";
    ASSERT_TRUE(QDir().mkdir(absent));
    clock.advance(EventFile::kRetry);
    file->tick();
    ASSERT_TRUE(writes(1));
    EXPECT_THAT(lines(), ElementsAre(EndsWith("one"), EndsWith("two")));
}

TEST_F(EventFileTest, AFullDiskIsToldAndTriedAgain)
{
    build(dir.path());
    ASSERT_TRUE(QFile::link(QStringLiteral("/dev/full"), m_path));
    add(QStringLiteral("one"));
    file->tick();
    ASSERT_TRUE(fails(1));
    ASSERT_TRUE(QFile::remove(m_path));
    clock.advance(EventFile::kRetry);
    file->tick();
    ASSERT_TRUE(writes(1));
    EXPECT_THAT(lines(), ElementsAre(EndsWith("one")));
}

TEST_F(EventFileTest, HowManyLinesWereLostIsWritten)
{
    const QString absent = dir.filePath(QStringLiteral("absent"));
    build(absent);
    for (std::size_t i = 0; i < EventLog::kCapacity + 37; ++i) {
        add(QString::number(i));
    }
    file->tick();
    ASSERT_TRUE(fails(1));
    ASSERT_TRUE(QDir().mkdir(absent));
    clock.advance(EventFile::kRetry);
    file->tick();
    ASSERT_TRUE(writes(1));
    const auto all = lines();
    ASSERT_EQ(all.size(), 1 + EventLog::kCapacity);
    EXPECT_THAT(all[0], HasSubstr("log: 37 lines were lost"));
    EXPECT_THAT(all[1], EndsWith("test: 37"));
    EXPECT_THAT(all.back(), EndsWith("test: " + std::to_string(EventLog::kCapacity + 36)));
}

// Story: the file was written in the tick, and a slow disk became a fault of the drives. In this test a pipe without a
// reader plays the disk: opening it blocks for ever.
TEST_F(EventFileTest, ADiskThatHangsHoldsUpNobody)
{
    build(dir.path());
    ASSERT_EQ(mkfifo(QFile::encodeName(m_path).constData(), 0600), 0);
    add(QStringLiteral("one"));
    for (int i = 0; i < 1000; ++i) {
        file->tick();
    }
    EXPECT_EQ(written, 0);
    QElapsedTimer time;
    time.start();
    file.reset();
    EXPECT_GE(time.elapsed(), EventFile::kPatience.count() - 1) << "it is given its time, and then given up";
    QFile reader(m_path);  // the worker waits for this reader
    ASSERT_TRUE(reader.open(QIODevice::ReadOnly));
    EXPECT_THAT(reader.readLine().toStdString(), EndsWith("test: one\n"));
}

}  // namespace
}  // namespace boresight
