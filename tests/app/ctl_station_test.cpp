// SPDX-License-Identifier: GPL-3.0-or-later
// boresightctl with a running station: boresightd with its simulated mount.
#include "tests/app/ctl_outcome.h"
#include "tests/fakes/wait_until.h"

#include <QFile>
#include <QRegularExpression>
#include <QTcpServer>
#include <QTcpSocket>
#include <QTemporaryDir>

#include <gmock/gmock.h>

namespace boresight {
namespace {

using testing::AnyOf;
using testing::HasSubstr;

class CtlStation : public testing::Test
{
protected:
    // Made before the daemon, which inherits the environment.
    struct OwnRuntimeFolder
    {
        OwnRuntimeFolder() { qputenv("XDG_RUNTIME_DIR", QFile::encodeName(folder.path())); }
        ~OwnRuntimeFolder() { qunsetenv("XDG_RUNTIME_DIR"); }
        OwnRuntimeFolder(const OwnRuntimeFolder&) = delete;
        OwnRuntimeFolder& operator=(const OwnRuntimeFolder&) = delete;
        QTemporaryDir folder;
    };

    void SetUp() override
    {
        ASSERT_TRUE(daemon.waitForLine(QStringLiteral("rotctld listening on ")));
        address = daemon.lines().constLast().section(QLatin1Char(' '), -1);
    }
    [[nodiscard]] Outcome ask(const char* line) const
    {
        return ctl(words(line) + QStringList{QStringLiteral("--station"), address});
    }
    // The program refuses until it has replies from both drives. If the computer ran nothing for longer than their
    // watchdog time, the drives have stopped: they are re-armed and commanded again.
    [[nodiscard]] bool isSentOff() const
    {
        return fakes::waitUntil([this] {
            const bool isSent = ask("goto 113 40").status == 0;
            if (!isSent) {
                rearm();
            }
            return isSent;
        });
    }
    void rearm() const
    {
        QTcpSocket client;
        client.connectToHost(address.section(QLatin1Char(':'), 0, 0), address.section(QLatin1Char(':'), -1).toUShort());
        if (client.waitForConnected()) {
            client.write("R 1\n");
            client.waitForReadyRead();
        }
    }

    // Invented elements.
    [[nodiscard]] QString elements() const
    {
        const QString path = folder.filePath(QStringLiteral("one.tle"));
        QFile file(path);
        EXPECT_TRUE(file.open(QIODevice::WriteOnly));
        file.write(
            "FIRST\n"
            "1 90001U 26001A   26001.50000000  .00001000  00000-0  20000-4 0   104\n"
            "2 90001  51.6000 100.0000 0010000  90.0000 270.0000 15.50000000000016\n");
        return path;
    }

    OwnRuntimeFolder runtime;
    QTemporaryDir folder;
    fakes::Program daemon{
        QStringLiteral(BORESIGHTD),
        {QStringLiteral("--simulate"), QStringLiteral("--state-dir"), folder.path(), QStringLiteral("--listen"),
         QStringLiteral("127.0.0.1:0"), QStringLiteral("--elements"), elements()}};
    QString address;
};

// REQ-CTL-300: goto, stop, park and status use the rotctld protocol of a running station. stop says that it does not
// latch.
TEST_F(CtlStation, IsSentStoppedAndParked)
{
    EXPECT_TRUE(isSentOff());
    EXPECT_TRUE(
        fakes::waitUntil([this] { return ask("status").output.find("state:    SLEW\n") != std::string::npos; }));
    const Outcome status = ask("status --format json");
    EXPECT_EQ(status.status, 0);
    EXPECT_THAT(status.output, HasSubstr("\"azimuth\""));
    EXPECT_THAT(ask("status").output, HasSubstr("actual:   azimuth "));
    const Outcome stop = ask("stop");
    EXPECT_EQ(stop.status, 0) << stop.errors;
    EXPECT_THAT(stop.output, HasSubstr("STOP is not latched"));
    EXPECT_EQ(ask("park").status, 0);
}

// Story: goto beyond the limits reported the target as accepted, and the mount went elsewhere.
// REQ-CTL-306
TEST_F(CtlStation, ReportsWhereTheMountGoes)
{
    ASSERT_TRUE(isSentOff());
    const Outcome below = ask("goto 30 -5");
    EXPECT_EQ(below.status, 1);
    EXPECT_EQ(below.output, "");
    EXPECT_THAT(below.errors, HasSubstr("goto: Elevation -5.0° below limit 0.0°. The mount goes to 30.0° / 0.0°, the "
                                        "nearest permitted direction."));
    const Outcome turn = ask("goto 400 30");
    EXPECT_EQ(turn.status, 0) << turn.errors;
    EXPECT_THAT(turn.output, HasSubstr("The station accepted the target azimuth 40.00°, elevation 30.00°."));
}

// REQ-CTL-302: take, release, stop --latched and reset-stop use the local socket of the station on this computer. None
// of them starts a motion. A refusal contains the reason of the station.
TEST_F(CtlStation, GivesAndTakesControlAndLatchesStop)
{
    EXPECT_TRUE(isSentOff());
    const Outcome take = ask("take");
    EXPECT_EQ(take.status, 0) << take.errors;
    const Outcome refused = ask("goto 113 40");
    EXPECT_EQ(refused.status, 1);
    EXPECT_THAT(refused.errors, HasSubstr("refused: The operator has control."));
    EXPECT_THAT(ask("park").errors, HasSubstr("refused: The operator has control."));
    EXPECT_EQ(ask("release").status, 0);
    EXPECT_TRUE(isSentOff());
    const Outcome stop = ask("stop --latched");
    EXPECT_EQ(stop.status, 0) << stop.errors;
    EXPECT_THAT(stop.output, HasSubstr("STOP is latched"));
    const Outcome latched = ask("goto 113 40");
    EXPECT_EQ(latched.status, 1);
    EXPECT_THAT(latched.errors, HasSubstr("refused: STOP is latched."));
    const Outcome release = ask("release");
    EXPECT_EQ(release.status, 1);
    EXPECT_THAT(release.errors, HasSubstr("refused: STOP is latched. Reset STOP first."));
    EXPECT_TRUE(fakes::waitUntil([this] { return ask("reset-stop").status == 0; })) << "still braking until then";
    EXPECT_EQ(ask("goto 113 40").status, 1) << "the operator still has the control";
    EXPECT_EQ(ask("release").status, 0);
    EXPECT_THAT(ask("status").output, HasSubstr("state:    STANDBY\n"));
    EXPECT_TRUE(isSentOff());
    EXPECT_TRUE(daemon.waitForError(QStringLiteral("shell: STOP is latched"))) << daemon.errors().toStdString();
}

// REQ-CTL-1000: protocol-log begins and ends the protocol log of the station, and prints its lines: time, client, line,
// meaning, answer.
TEST_F(CtlStation, ShowsTheProtocolLog)
{
    EXPECT_TRUE(isSentOff());
    EXPECT_EQ(ask("protocol-log show").output, "") << "it is off after a start";
    const Outcome on = ask("protocol-log on");
    EXPECT_EQ(on.status, 0) << on.errors;
    EXPECT_TRUE(isSentOff());
    const Outcome off = ask("protocol-log off");
    EXPECT_EQ(off.status, 0) << off.errors;
    const Outcome shown = ask("protocol-log show");
    EXPECT_EQ(shown.status, 0) << shown.errors;
    EXPECT_THAT(shown.output, HasSubstr("Z\trotctld 127.0.0.1:"));
    EXPECT_THAT(shown.output, HasSubstr("go to 113.0° / 40.0°"));
    EXPECT_EQ(ask("protocol-log all").status, 2);
    EXPECT_THAT(ask("protocol-log all").errors, HasSubstr("\"all\" is none of on, off, show and follow"));
}

// REQ-CTL-960: track lets the station track a target given in words. Afterwards the operator has control: goto is
// refused until release. A target that the station does not know, or may not track now, is refused with the reason
// (exit status 1). Without a target the command line is invalid (2).
TEST_F(CtlStation, TracksATarget)
{
    const auto tracks = [this] { return ask("track azel 113,40").status == 0; };
    ASSERT_TRUE(isSentOff());
    EXPECT_TRUE(fakes::waitUntil(tracks)) << "goto came from the same computer";
    const Outcome again = ask("track AZEL 120,40");
    EXPECT_EQ(again.status, 0) << again.errors;
    EXPECT_THAT(again.output, HasSubstr("The station tracks 120.00° 40.00°. The operator has control"));
    EXPECT_EQ(ask("goto 113 40").status, 1);
    EXPECT_EQ(ask("release").status, 0);
    const Outcome unknown = ask("track noaa 99");
    EXPECT_EQ(unknown.status, 1);
    EXPECT_THAT(unknown.errors, HasSubstr("refused: \"noaa 99\" is not a known satellite, a body or a locator"));
    EXPECT_EQ(ask("track").status, 2);
    EXPECT_EQ(ask("track moon --norad 5").status, 2);
    EXPECT_EQ(ask("stop --latched").status, 0);
    const Outcome stopped = ask("track azel 113,40");
    EXPECT_EQ(stopped.status, 1);
    EXPECT_THAT(stopped.errors, HasSubstr("refused: STOP is latched"));
}

// REQ-CTL-961: satellites lists the satellites known to the station: name, number, epoch and age. track accepts their
// numbers.
TEST_F(CtlStation, ListsTheSatellites)
{
    const std::string start = "name,norad,epoch_utc,age_days\nFIRST,90001,2026-01-01T12:00:00Z,";
    EXPECT_TRUE(fakes::waitUntil([&] { return ask("satellites").output.starts_with(start); })) << "read at its start";
    EXPECT_THAT(ask("satellites --format json").output, HasSubstr("\"norad\": 90001"));
    EXPECT_EQ(ask("satellites --format text").status, 2);
    EXPECT_EQ(ask("satellites all").status, 2);
    Outcome track;
    const auto knowsTheDrives = [&] {
        track = ask("track 90001");
        return track.errors.find("The drive check is running") == std::string::npos;
    };
    EXPECT_TRUE(fakes::waitUntil(knowsTheDrives));
    EXPECT_EQ(track.status, 1);
    // If the computer ran nothing for long at the start, the program does not know the cable wrap of its drives.
    EXPECT_THAT(track.errors, AnyOf(HasSubstr("refused: The site of the mount is not set."),
                                    HasSubstr("refused: The cable wrap of the ")));
}

// REQ-CTL-303: The local socket belongs to one computer and one user: another host is an invalid command line (exit
// status 2), a missing socket means that no station answers (3).
TEST_F(CtlStation, IsAskedOnItsOwnComputer)
{
    for (const char* const line :
         {"take --station mast.example:4533", "release --station 192.168.1.7:4533",
          "stop --latched --station 0.0.0.0:4533", "reset-stop --station mast.example:4533",
          "override-wind --station mast.example:4533", "use-new-time --station mast.example:4533"}) {
        const Outcome other = ctl(words(line));
        EXPECT_EQ(other.status, 2) << line;
        EXPECT_THAT(other.errors, HasSubstr("only on the computer of the station"));
    }
    const QString port = address.section(QLatin1Char(':'), -1);
    for (const char* const host : {"localhost", "[::1]"}) {
        EXPECT_EQ(ctl({QStringLiteral("take"), QStringLiteral("--station"), QLatin1String(host) + u':' + port}).status,
                  0);
    }
    const Outcome sameTime = ask("use-new-time");
    EXPECT_EQ(sameTime.status, 1);
    EXPECT_THAT(sameTime.errors, HasSubstr("refused: Boresight already uses the time of this computer."));
    EXPECT_EQ(ask("goto 1 2 --latched").status, 2);
    daemon.terminate();
    EXPECT_EQ(daemon.waitForEnd(), 0);
    EXPECT_EQ(ask("take").status, 3);
    EXPECT_FALSE(QFile::exists(QStringLiteral("%1/boresight/%2.sock").arg(runtime.folder.path(), port)));
    qunsetenv("XDG_RUNTIME_DIR");
    const Outcome without = ask("take");
    EXPECT_EQ(without.status, 3);
    EXPECT_THAT(without.errors, HasSubstr("XDG_RUNTIME_DIR is not set"));
}

// REQ-CTL-301: The exit status is 1, with the reason, when the station refuses, 2 for an invalid command line, 3 when
// no station answers.
TEST(CtlStationOutcome, SaysWhyNothingWasDone)
{
    QTcpServer station;
    ASSERT_TRUE(station.listen(QHostAddress::LocalHost));
    QObject::connect(&station, &QTcpServer::newConnection, &station, [&station] {
        QTcpSocket* const client = station.nextPendingConnection();
        QObject::connect(client, &QTcpSocket::readyRead, client, [client] {
            client->readAll();
            client->write("set_pos: 1 2\nRPRT -9\n");  // to each question: it reports no reason
        });
    });
    const QString address = QStringLiteral("127.0.0.1:%1").arg(station.serverPort());
    const QStringList point = words("goto 1 2 --station") + QStringList{address};
    const Outcome refused = ctl(point);
    EXPECT_EQ(refused.status, 1);
    EXPECT_THAT(refused.errors, HasSubstr("refused: STOP is latched"));
    station.close();
    EXPECT_EQ(ctl(point).status, 3);
    for (const char* line :
         {"goto", "goto 1", "goto north 2", "goto 1 200", "stop now", "park --station mast", "status --format xml"}) {
        EXPECT_EQ(ctl(words(line)).status, 2) << line;
    }
}

}  // namespace
}  // namespace boresight
