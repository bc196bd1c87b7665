// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/inputs/station_tables.h"

#include "tests/core/station/moving_station.h"
#include "tests/fakes/text_of.h"
#include "tests/fakes/wait_until.h"

#include <QFile>
#include <QTemporaryDir>

#include <gmock/gmock.h>

#include <algorithm>
#include <chrono>
#include <optional>

namespace boresight {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

// The file is read by a thread.
constexpr std::chrono::milliseconds kRealTime{20};

class TableFolder : public testing::Test
{
protected:
    QString write(const char* name, const QByteArray& text) const
    {
        QFile file(folder.filePath(QLatin1String(name)));
        EXPECT_TRUE(file.open(QIODevice::WriteOnly));
        file.write(text);
        return file.fileName();
    }
    // Rows from `start` on, 4° apart, for three minutes.
    static QByteArray rowsFrom(UtcTime start)
    {
        QByteArray text;
        for (int i = 0; i <= 3; ++i) {
            const auto time = std::chrono::floor<std::chrono::seconds>(start.time_since_epoch()).count() + 60 * i;
            text += QByteArray::number(qint64{time}) + ' ' + QByteArray::number(4 * i) + " 20\n";
        }
        return text;
    }

    QTemporaryDir folder;
};

// The result of a reading.
struct Outcome
{
    std::optional<Result<targets::Target>> table;

    StationTables::Then taker()
    {
        return [this](const Result<targets::Target>& read) { table = read; };
    }
    [[nodiscard]] std::string problem() const { return table && !*table ? textOf(table->error()) : std::string(); }
};

// REQ-STATION-950: The file of a table is read outside the station thread. The caller is answered once: with the table,
// or with the file, the line and the reason. A relative path is refused.
TEST_F(TableFolder, IsReadBesideTheStation)
{
    StationTables tables(nullptr);
    Outcome good;
    tables.read(write("way.txt", rowsFrom(UtcTime(std::chrono::hours(480'000)))), good.taker());
    EXPECT_FALSE(good.table) << "not at once";
    ASSERT_TRUE(fakes::waitUntil([&] { return good.table.has_value(); }));
    ASSERT_TRUE(*good.table) << good.problem();
    EXPECT_EQ((*good.table)->name, QStringLiteral("way.txt"));
    Outcome bad;
    const QString path = write("bad.txt", "1700000000 1 2\n1700000060 1 200\n");
    tables.read(path, bad.taker());
    ASSERT_TRUE(fakes::waitUntil([&] { return bad.table.has_value(); }));
    EXPECT_THAT(bad.problem(), StartsWith(path.toStdString() + ":2: The elevation is 200°."));
    Outcome relative;
    tables.read(QStringLiteral("way.txt"), relative.taker());
    ASSERT_TRUE(fakes::waitUntil([&] { return relative.table.has_value(); }));
    EXPECT_EQ(relative.problem(), "\"way.txt\" is not the whole path of a file. It must begin with /.");
}

// REQ-STATION-951: A command for the mount ends the waiting for a file, so that no motion starts later by surprise. A
// request for another file ends it too. A request that only reads does not end it.
TEST_F(TableFolder, AnotherCommandEndsTheWaiting)
{
    const QString path = write("way.txt", rowsFrom(UtcTime(std::chrono::hours(480'000))));
    StationTables tables(nullptr);
    Outcome held;
    tables.read(path, held.taker());
    tables.noticed(request::AcknowledgeAlarms{});
    EXPECT_FALSE(held.table);
    tables.noticed(request::Hold{});
    EXPECT_EQ(held.problem(), "Another command came before the file was read. Track it again.");
    held.table.reset();
    Outcome first;
    Outcome second;
    tables.read(path, first.taker());
    tables.read(path, second.taker());
    EXPECT_THAT(first.problem(), StartsWith("Another command came"));
    ASSERT_TRUE(fakes::waitUntil([&] { return second.table.has_value(); }));
    EXPECT_TRUE(*second.table);
    EXPECT_FALSE(held.table) << "answered once";
}

// REQ-STATION-953: The waiting for a file also ends when the mount starts another motion, and after 30 s, because the
// folder of a file may hang.
TEST_F(TableFolder, AnotherErrandAndTimeEndTheWaiting)
{
    const QString path = write("way.txt", rowsFrom(UtcTime(std::chrono::hours(480'000))));
    StationTables tables(nullptr);
    const SteadyTime start{};
    Outcome other;
    tables.read(path, other.taker());
    tables.tick(7, start);
    tables.tick(7, start + std::chrono::seconds(1));
    EXPECT_FALSE(other.table);
    tables.tick(8, start + std::chrono::seconds(2));
    EXPECT_THAT(other.problem(), StartsWith("Another command came"));
    Outcome late;
    tables.read(path, late.taker());
    tables.tick(8, start);
    tables.tick(8, start + std::chrono::milliseconds(29'999));
    EXPECT_FALSE(late.table);
    tables.tick(8, start + kLongestTableReading);
    EXPECT_EQ(late.problem(), "The file was not read within 30 s. Nothing moves. Track it again.");
    tables.tick(9, start + std::chrono::seconds(31));
}

// REQ-STATION-952: The whole way from the file to the mount: the operator's request is answered when the file is read.
// Then the station tracks the table, or reports the error and moves nothing.
TEST_F(TableFolder, TheStationTracksAFile)
{
    MovingStation rig(folder.path());
    const QString bad = write("bad.txt", "az el\n");
    rig.station->request({.id = 1, .request = request::TrackFile{bad}});
    const auto refused = rig.answerTo(1, kRealTime);
    ASSERT_TRUE(refused && refused->error);
    EXPECT_EQ(textOf(*refused->error),
              bad.toStdString() + ":1: There is no row. A row is a time, an azimuth and an elevation.");
    EXPECT_FALSE(rig.station->status().tracked);

    rig.station->request({.id = 2, .request = request::TrackFile{write("way.txt", rowsFrom(rig.clock.utc()))}});
    const auto accepted = rig.answerTo(2, kRealTime);
    ASSERT_TRUE(accepted);
    EXPECT_FALSE(accepted->error) << textOf(*accepted->error);
    ASSERT_TRUE(rig.station->status().tracked);
    EXPECT_EQ(rig.station->status().tracked->name, QStringLiteral("way.txt"));

    rig.station->request({.id = 3, .request = request::TrackFile{folder.filePath(QStringLiteral("way.txt"))}});
    rig.station->request({.id = 4, .request = request::Hold{}});
    const auto overtaken = rig.answerTo(3, kRealTime);
    ASSERT_TRUE(overtaken && overtaken->error);
    EXPECT_THAT(textOf(*overtaken->error), HasSubstr("Another command came before the file was read."));
    rig.run(Seconds(1.0));
    EXPECT_FALSE(rig.station->status().tracked) << "Hold stands";
}

// REQ-STATION-238: A mount that tracks does not jump when the clock of this computer is set, neither forwards nor
// backwards, until the operator uses the new time. Alarms and log have the clock of the computer.
TEST_F(TableFolder, AClockThatIsSetDoesNotMoveWhatIsTracked)
{
    MovingStation rig(folder.path());
    rig.clock.setSynchronised(false);
    rig.station->request({.id = 1, .request = request::TrackFile{write("way.txt", rowsFrom(rig.clock.utc()))}});
    const auto accepted = rig.answerTo(1, kRealTime);
    ASSERT_TRUE(accepted && !accepted->error);
    rig.run(Seconds(60.0));
    const auto azimuth = [&] { return rig.station->status().commanded->azimuth.degrees(); };
    for (const double step : {90.0, -90.0 - 3600.0, 3600.0 + 45.0}) {
        const double before = azimuth();
        rig.clock.stepUtc(Seconds(step));
        rig.run(Seconds(3.0));
        EXPECT_NEAR(azimuth(), before + 0.2, 0.05) << step << " s: the table moves 4° in a minute";
        const StationStatus status = rig.station->status();
        EXPECT_TRUE(status.tracked) << step;
        ASSERT_FALSE(status.alarms.empty());
        const auto kept = std::ranges::find(status.alarms, QStringLiteral("clock.kept"), &Alarm::name);
        ASSERT_NE(kept, status.alarms.end());
        EXPECT_LT(std::chrono::abs(rig.clock.utc() - kept->since), std::chrono::seconds(5)) << step;
        EXPECT_EQ(computerUtc(status), rig.clock.utc()) << step;
    }
    EXPECT_EQ(rig.station->status().clock.ahead, Seconds(45.0));
    const double before = azimuth();
    rig.station->request({.id = 2, .request = request::UseNewTime{}});
    rig.run(Seconds(5.0));
    EXPECT_NEAR(azimuth(), before + 3.0 + 0.33, 0.1);
}

}  // namespace
}  // namespace boresight
