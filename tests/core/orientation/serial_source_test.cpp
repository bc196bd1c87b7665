// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/orientation_stream/serial_source.h"

#include "core/serial/port_holder.h"
#include "core/sim/simulated_sensor.h"
#include "tests/fakes/hand_turned_timers.h"
#include "tests/fakes/manual_clock.h"
#include "tests/fakes/program.h"
#include "tests/fakes/pseudo_terminal.h"
#include "tests/fakes/wait_until.h"

#include <QAbstractEventDispatcher>
#include <QCoreApplication>
#include <QFile>
#include <QSemaphore>
#include <QTemporaryDir>
#include <QThreadPool>

#include <fcntl.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>

namespace boresight::orientation {
namespace {

using namespace std::chrono_literals;

const QByteArray kSerialSourceSentence = "$PATRK,1771493857399,ms,47.33,dd,19.13,dd,0,revs,29,c,0,3,1,0*34\r\n";

struct SerialSourceTest : testing::Test
{
    static constexpr std::chrono::milliseconds kSilence{300};

    SerialSourceTest()
        : source({.port = terminal.path(), .firstRetry = 20ms, .longestRetry = 80ms, .silence = kSilence}, clock)
    {
        QObject::connect(&source, &SensorSource::received, &source, [this](const Orientation& value) {
            values.push_back(value);
            countsThen.push_back(source.status().counts.accepted);
        });
        QObject::connect(&source, &SensorSource::statusChanged, &source,
                         [this](const SourceStatus& status) { changes.push_back(status); });
    }

    [[nodiscard]] bool hears(std::size_t count)
    {
        return fakes::waitUntil([&] { return values.size() >= count; });
    }
    [[nodiscard]] bool becomes(bool open)
    {
        return fakes::waitUntil([&] { return source.status().open == open; });
    }
    [[nodiscard]] bool complains(const char* of)
    {
        return fakes::waitUntil([&] { return says(of); });
    }

    // Sends a line that is no sentence, and waits until it was read.
    void chat(const QByteArray& line)
    {
        const auto before = source.status().counts.chatter;
        terminal.write(line + "\r\n");
        ASSERT_TRUE(fakes::waitUntil([&] { return source.status().counts.chatter > before; }));
    }
    [[nodiscard]] bool says(const char* of) const { return source.status().problem.contains(QLatin1String(of)); }

    // Waits until the program that has the port is known and reported.
    static void letLookUpsEnd()
    {
        ASSERT_TRUE(QThreadPool::globalInstance()->waitForDone(60'000));
        QCoreApplication::processEvents();
    }

    fakes::ManualClock clock;
    fakes::PseudoTerminal terminal;
    SerialSource source;
    std::vector<Orientation> values;
    std::vector<std::uint64_t> countsThen;
    std::vector<SourceStatus> changes;
};

// An adapter that ignores the baud rate may send any amount of data.
// REQ-ORIENTATION-06 (SerialSourceTest.*): A port that is absent, busy, silent or gone is reported in one line with its
// remedy, and is tried again with growing pauses. If something other than sentences arrives, a lasting change of it is
// reported again. The search for the program that has the port runs outside this thread. Nothing is ever sent.
// REQ-ORIENTATION-06a: Whatever a port sends, at most 2 kB are read every 10 ms, because the same thread serves the
// drives.
TEST_F(SerialSourceTest, AFloodIsReadInSmallHelpings)
{
    source.open();
    ASSERT_TRUE(becomes(true)) << qPrintable(source.status().problem);
    std::size_t most = 0;
    std::size_t before = 0;
    const auto turn =
        QObject::connect(QAbstractEventDispatcher::instance(), &QAbstractEventDispatcher::awake, &source, [&] {
            most = std::max(most, values.size() - before);
            before = values.size();
        });
    const int sentences = 3 * static_cast<int>(SerialSource::kBytesAtOnce / kSerialSourceSentence.size());
    for (int written = 0; written < sentences;) {  // as much as the terminal accepts
        for (int i = 0; i < 50 && written < sentences; ++i, ++written) {
            terminal.write(kSerialSourceSentence);
        }
        ASSERT_TRUE(hears(static_cast<std::size_t>(written)));
    }
    QObject::disconnect(turn);
    EXPECT_LE(most, static_cast<std::size_t>(SerialSource::kBytesAtOnce / kSerialSourceSentence.size() + 1));
}

TEST_F(SerialSourceTest, HearsSentencesOfAPort)
{
    EXPECT_EQ(source.name(), QStringLiteral("serial ") + terminal.path());
    source.open();
    ASSERT_TRUE(becomes(true)) << qPrintable(source.status().problem);
    clock.advance(Seconds(3.0));
    terminal.write("BNO055 initialised...\r\n" + kSerialSourceSentence.left(30));
    terminal.write(kSerialSourceSentence.mid(30) + kSerialSourceSentence + "$PATRK,x*00\r\n");
    ASSERT_TRUE(hears(2));
    EXPECT_EQ(values[0].arrival, clock.now());
    EXPECT_NEAR(values[0].heading.angle().degrees(), 47.33, 1e-9);
    EXPECT_EQ(countsThen[0], 1U) << "the counts are right when a value is told";
    ASSERT_TRUE(fakes::waitUntil([&] { return source.status().counts.allRefused() == 1; }));
    EXPECT_EQ(source.status().counts.chatter, 1U);
    EXPECT_EQ(source.status().problem, QString());
    EXPECT_EQ(terminal.takeWritten(), QByteArray()) << "nothing is ever sent to the sensor";
}

TEST_F(SerialSourceTest, HearsTheSimulatedSensorOnAPort)
{
    sim::SimulatedSensor sensor({.mountingOffset = 37.4_deg, .noise = Angle{}});
    source.open();
    ASSERT_TRUE(becomes(true));
    for (int reading = 0; reading < 60; ++reading) {
        clock.advance(sim::SimulatedSensor::kReadingPeriod);
        if (const auto message = sensor.read(clock.now(), clock.utc(), {.azimuth = 100_deg, .elevation = 35_deg})) {
            terminal.write(QByteArray::fromStdString(sim::toSentence(*message)));
        }
    }
    ASSERT_TRUE(hears(11));
    EXPECT_NEAR(values.back().heading.angle().degrees(), 62.6, 0.006);
    EXPECT_NEAR(values.back().elevation.degrees(), 35.0, 0.006);
    EXPECT_EQ(source.status().counts.allRefused(), 0U);
}

TEST_F(SerialSourceTest, ALostPortIsFoundAgain)
{
    const QTemporaryDir folder;
    const QString link = folder.filePath(QStringLiteral("sensor"));
    ASSERT_TRUE(QFile::link(terminal.path(), link));
    SerialSource linked({.port = link, .firstRetry = 20ms, .longestRetry = 80ms, .silence = 300ms}, clock);
    int heard = 0;
    QObject::connect(&linked, &SensorSource::received, &linked, [&heard] { ++heard; });
    linked.open();
    ASSERT_TRUE(fakes::waitUntil([&] { return linked.status().open; }));
    terminal.write(kSerialSourceSentence);
    ASSERT_TRUE(fakes::waitUntil([&] { return heard == 1; }));
    terminal.unplug();
    ASSERT_TRUE(fakes::waitUntil([&] { return !linked.status().open; }));
    EXPECT_TRUE(linked.status().problem.contains(QLatin1String("is gone"))) << qPrintable(linked.status().problem);

    fakes::PseudoTerminal other;
    ASSERT_TRUE(QFile::remove(link) && QFile::link(other.path(), link));
    ASSERT_TRUE(fakes::waitUntil([&] { return linked.status().open; })) << qPrintable(linked.status().problem);
    other.write(kSerialSourceSentence);
    ASSERT_TRUE(fakes::waitUntil([&] { return heard == 2; }));
    EXPECT_EQ(linked.status().problem, QString());
}

TEST_F(SerialSourceTest, OneTroubleIsToldOnceHoweverOftenItIsTried)
{
    SerialSource absent({.port = QStringLiteral("/nowhere/sensor"), .firstRetry = 10ms, .longestRetry = 20ms}, clock);
    int told = 0;
    QObject::connect(&absent, &SensorSource::statusChanged, &absent, [&told] { ++told; });
    fakes::HandTurnedTimers timers(absent, clock);
    absent.open();
    EXPECT_TRUE(absent.status().problem.contains(QLatin1String("does not exist")));
    timers.elapse(1s);
    EXPECT_EQ(told, 1);
    absent.close();
    EXPECT_EQ(absent.status().problem, QString());
}

TEST_F(SerialSourceTest, SaysWhatComesInPlaceOfSentences)
{
    fakes::HandTurnedTimers timers(source, clock);
    source.open();
    ASSERT_TRUE(becomes(true));
    timers.elapse(kSilence);
    EXPECT_TRUE(says("No data"));
    terminal.write("Initial begin() failed!\r\n");
    source.close();
    source.open();
    ASSERT_TRUE(becomes(true));
    chat("Initial begin() failed!");
    timers.elapse(kSilence);
    EXPECT_TRUE(says("Initial begin() failed!"));
    source.close();
    source.open();
    ASSERT_TRUE(becomes(true));
    chat("\xfe\x80\x99");
    timers.elapse(kSilence);
    EXPECT_TRUE(says("sensor.baud (115200)"));
    terminal.write("\xff\r\n" + kSerialSourceSentence);
    ASSERT_TRUE(hears(1));
    EXPECT_EQ(source.status().problem, QString());
}

// Story: the box was switched on without its chip, and the line still said that nothing arrives.
TEST_F(SerialSourceTest, WhatComesInPlaceOfSentencesIsLookedAtAgain)
{
    fakes::HandTurnedTimers timers(source, clock);
    source.open();
    ASSERT_TRUE(becomes(true));
    timers.elapse(kSilence);
    EXPECT_TRUE(says("No data"));
    for (int look = 0; look < 2; ++look) {
        chat("Initial begin() failed!");
        timers.elapse(kSilence);
    }
    EXPECT_TRUE(says("Initial begin() failed!"));
    timers.elapse(2 * kSilence);
    EXPECT_TRUE(says("No data"));
}

TEST_F(SerialSourceTest, ChatterWithANumberInItIsNotToldEachTime)
{
    fakes::HandTurnedTimers timers(source, clock);
    source.open();
    ASSERT_TRUE(becomes(true));
    chat("round trip 0 ms");
    timers.elapse(kSilence);
    EXPECT_TRUE(says("round trip"));
    changes.clear();
    for (int number = 1; number <= 5; ++number) {
        chat("round trip " + QByteArray::number(number) + " ms");
        timers.elapse(kSilence);
    }
    EXPECT_TRUE(changes.empty());
}

TEST_F(SerialSourceTest, ClosedItHearsNothing)
{
    source.open();
    ASSERT_TRUE(becomes(true));
    source.close();
    EXPECT_FALSE(source.status().open);
    SerialSource other({.port = terminal.path()}, clock);
    bool heard = false;
    QObject::connect(&other, &SensorSource::received, [&heard] { heard = true; });
    other.open();
    ASSERT_TRUE(fakes::waitUntil([&other] { return other.status().open; }));
    terminal.write(kSerialSourceSentence);
    ASSERT_TRUE(fakes::waitUntil([&heard] { return heard; }));
    EXPECT_TRUE(values.empty());
}

TEST_F(SerialSourceTest, ClosedByWhoTookAValueItTellsNoMoreOfTheSamePiece)
{
    QObject::connect(&source, &SensorSource::received, &source, [this] { source.close(); });
    source.open();
    ASSERT_TRUE(becomes(true));
    terminal.write(kSerialSourceSentence + kSerialSourceSentence + kSerialSourceSentence);
    ASSERT_TRUE(hears(1));
    QCoreApplication::processEvents();
    EXPECT_EQ(values.size(), 1U);
    EXPECT_FALSE(source.status().open);
}

TEST_F(SerialSourceTest, ClosedWhileThePortIsLookedAtItStaysClosed)
{
    source.open();
    source.close();
    letLookUpsEnd();
    EXPECT_FALSE(source.status().open);
    source.open();
    source.close();
    source.open();
    EXPECT_TRUE(becomes(true));
}

// Story: each attempt searched the open files of all programs, 9 to 21 ms on the thread that serves the drives.
TEST_F(SerialSourceTest, WhoHasThePortIsLookedUpBesideTheThread)
{
    fakes::Program holder(
        QStringLiteral("/bin/sh"),
        {QStringLiteral("-c"), QStringLiteral("echo has it; exec sleep 60 <'%1'").arg(terminal.path())});
    ASSERT_TRUE(holder.waitForLine(QStringLiteral("has it")));
    ASSERT_TRUE(fakes::waitUntil(
        [&] { return portHolder(terminal.path()).value_or(QString()).startsWith(QLatin1String("sleep")); }));
    source.open();
    EXPECT_TRUE(changes.empty()) << "open() does not wait for the answer";
    ASSERT_TRUE(complains("is in use by sleep (process"));
    EXPECT_FALSE(source.status().open);
    holder.kill();
    EXPECT_EQ(holder.waitForEnd(), -1);
    ASSERT_TRUE(becomes(true));
    EXPECT_EQ(changes.size(), 2U) << "told once, however often it was tried";
    terminal.write(kSerialSourceSentence);
    EXPECT_TRUE(hears(1));
}

// Story: choosing another source delayed the drives for as long as the search took. Here the search cannot begin before
// the source is deleted: each thread of the pool waits for that.
TEST_F(SerialSourceTest, DeletedWhileThePortIsLookedAtItWaitsForNothing)
{
    QThreadPool& pool = *QThreadPool::globalInstance();
    const int threads = pool.maxThreadCount();
    QSemaphore deleted;
    std::atomic<int> inTime = 0;
    for (int thread = 0; thread < threads; ++thread) {
        pool.start([&] { inTime += deleted.tryAcquire(1, 30'000) ? 1 : 0; });
    }
    auto other = std::make_unique<SerialSource>(SerialSettings{.port = terminal.path()}, clock);
    other->open();
    other.reset();
    deleted.release(threads);
    letLookUpsEnd();  // and the result has no receiver
    EXPECT_EQ(inTime, threads);
}

TEST_F(SerialSourceTest, WhatIsNoPortIsNoPort)
{
    SerialSource file({.port = QStringLiteral("/dev/null")}, clock);
    file.open();
    EXPECT_TRUE(fakes::waitUntil([&] { return !file.status().problem.isEmpty(); }));
    EXPECT_FALSE(file.status().open);
}

}  // namespace
}  // namespace boresight::orientation
