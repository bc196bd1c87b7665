// SPDX-License-Identifier: GPL-3.0-or-later
// The local socket of a whole station, with a real socket.
#include "tests/core/clients/shell_rig.h"
#include "tests/core/station/linked_station.h"
#include "tests/fakes/azel_writer.h"

#include <QTcpServer>

#include <gmock/gmock.h>

#include <algorithm>

namespace boresight {
namespace {

using testing::HasSubstr;
using testing::Not;

// The name of the socket contains the port of the rotctld server.
QString socketOf(const StationStatus& status, const QTemporaryDir& runtime)
{
    return local::socketPath(runtime.path(), status.listening.section(QLatin1Char(':'), -1).toUShort());
}

std::string logOf(LinkedStation& rig)
{
    rig.station->updateTaken();
    rig.station->publish();
    QStringList lines;
    for (const StationUpdate& update : rig.updates) {
        for (const LogEntry& entry : update.log) {
            lines.append(entry.source + QStringLiteral(": ") + entry.text);
        }
    }
    return lines.join(u'\n').toStdString();
}

// REQ-STATION-200: A command of the local socket is a request of the operator, with the name "shell" in the log. take
// and release change the control authority, stop latches at once, and reset-stop ends the latch. A refusal is answered
// and logged.
TEST(StationShell, AsksAsTheOperator)
{
    const QTemporaryDir runtime;
    LinkedStation rig;
    rig.station->serveShell(runtime.path());
    rig.station->openAll();
    rig.run(5);
    const QString path = socketOf(rig.station->status(), runtime);
    EXPECT_EQ(rig.station->status().authority, Authority::Clients);
    EXPECT_EQ(askShell(path, "take\n"), "ok\n");
    EXPECT_EQ(rig.station->status().authority, Authority::Operator);
    EXPECT_EQ(askShell(path, "release\n"), "ok\n");
    EXPECT_EQ(rig.station->status().authority, Authority::Clients);
    const std::uint64_t tick = rig.station->status().tick;
    EXPECT_EQ(askShell(path, "stop\n"), "ok\n");
    EXPECT_TRUE(rig.station->status().stopLatched);
    EXPECT_EQ(rig.station->status().tick, tick + 1) << "STOP does not wait for the next tick";
    EXPECT_EQ(askShell(path, "release\n"), "error: STOP is latched. Reset STOP first.\n");
    EXPECT_EQ(rig.station->status().authority, Authority::Operator);
    EXPECT_EQ(askShell(path, "reset-stop\n"), "ok\n");
    EXPECT_EQ(askShell(path, "use-new-time\n"), "error: Boresight already uses the time of this computer.\n");
    EXPECT_FALSE(rig.station->status().stopLatched);
    EXPECT_EQ(rig.station->status().authority, Authority::Operator);
    const std::string log = logOf(rig);
    EXPECT_THAT(log, HasSubstr("shell: listening on " + path.toStdString()));
    EXPECT_THAT(log, HasSubstr("shell: STOP is latched"));
    EXPECT_THAT(log, HasSubstr("shell: release refused: STOP is latched"));
}

// REQ-STATION-966: The shell asks the simulated mount for a fault, and the log names the fault. Without a simulated
// mount the request is refused with the reason.
TEST(StationShell, ShowsAFaultOfTheSimulatedMount)
{
    const QTemporaryDir runtime;
    LinkedStation rig;
    rig.station->serveShell(runtime.path());
    rig.station->openAll();
    rig.run(5);
    const QString path = socketOf(rig.station->status(), runtime);
    EXPECT_THAT(askShell(path, "simulate wind az:60\n"), HasSubstr("error: This station moves a real mount"));
    rig.station->setFaults([](std::string_view text) { return QStringLiteral("begins: ") + toQString(text); });
    EXPECT_EQ(askShell(path, "simulate wind az:60\n"), "ok\nbegins: wind az:60\n");
    const std::string log = logOf(rig);
    EXPECT_THAT(log, HasSubstr("shell: simulate refused: This station moves a real mount"));
    EXPECT_THAT(log, HasSubstr("shell: begins: wind az:60"));
}

// REQ-STATION-940: The shell lets the station track a target by the rules of a go-to. It is refused while STOP is
// latched, and while a client has control. Then `take` must come first. Afterwards the operator has control.
TEST(StationShell, TracksWhereAClientOfThisComputerCouldMoveTheMount)
{
    ShellRig rig;
    EXPECT_EQ(rig.answerTo("track azel 20,30\n"), "ok\n20.00° 30.00°\n");
    rig.run(Seconds(0.1));
    const StationStatus status = rig.control.status();
    EXPECT_EQ(status.authority, Authority::Operator);
    ASSERT_TRUE(status.tracked);
    EXPECT_EQ(status.commander.name, QStringLiteral("shell"));
    EXPECT_EQ(rig.answerTo("track azel 25,30\n"), "ok\n25.00° 30.00°\n") << "the operator has the control";
    EXPECT_THAT(rig.answerTo("track nothing\n"), HasSubstr("error: \"nothing\" is not a known satellite"));

    ASSERT_EQ(rig.answerTo("release\n"), "ok\n");
    ASSERT_TRUE(rig.point(30.0, 30.0, kClient));
    rig.run(Seconds(0.1));
    EXPECT_THAT(rig.answerTo("track azel 20,30\n"), HasSubstr("error: rotctld 1 has control."));
    EXPECT_THAT(rig.answerTo("track azel 20,30\n"), HasSubstr("Take the control first.\n"));
    EXPECT_FALSE(rig.control.status().tracked);
    EXPECT_EQ(rig.control.status().authority, Authority::Clients);
    ASSERT_EQ(rig.answerTo("take\n"), "ok\n");
    EXPECT_EQ(rig.answerTo("track azel 20,30\n"), "ok\n20.00° 30.00°\n");
    ASSERT_EQ(rig.answerTo("stop\n"), "ok\n");
    EXPECT_THAT(rig.answerTo("track azel 20,30\n"), HasSubstr("error: STOP is latched"));
}

// REQ-ANTENNA-941: The shell lists the antennas with their beams, and lets the station use one of them. A refusal gives
// its reason.
TEST(StationShell, ListsAntennasAndUsesOne)
{
    ShellRig rig;
    EXPECT_EQ(rig.answerTo("antennas\n"),
              "ok\n1\t10.000000\t0.000000\t0.000000\tmain\n0\t20.000000\t0.000000\t3.000000\t70 cm\n");
    EXPECT_EQ(rig.answerTo("antenna 70 cm\n"), "error: There is no antenna \"70 cm\". The profile has \"main\".\n");
    profile::Profile profile = rig.profile;
    profile.antennas = {{.name = "70 cm", .beamWidth = 20_deg, .up = 3_deg}};
    rig.setProfile(profile);
    EXPECT_EQ(rig.answerTo("antenna 70 cm\n"), "ok\n");
    EXPECT_EQ(rig.control.status().antenna, "70 cm");
}

// REQ-STATION-244: Without a screen, the shell reports with the status the next rise or set of the tracked target, and
// the active alarms with their sentences.
TEST(StationShell, ReportsTheNextEventAndTheAlarms)
{
    ShellRig rig;
    rig.tracked = TrackedTarget{.name = QStringLiteral("ISS"), .next = UtcTime(std::chrono::hours(34))};
    EXPECT_THAT(rig.answerTo("status\n"), HasSubstr(R"("rises":"1970-01-02T10:00:00.000Z")"));
    rig.tracked->isUp = true;
    EXPECT_THAT(rig.answerTo("status\n"), HasSubstr(R"("sets":"1970-01-02T10:00:00.000Z")"));
    rig.alarms = {{.what = QStringLiteral("It failed."),
                   .action = QStringLiteral("It stands."),
                   .remedy = QStringLiteral("Mend it.")},
                  {.what = QStringLiteral("Over."), .active = false}};
    EXPECT_THAT(rig.answerTo("status\n"), HasSubstr(R"("alarms":["It failed. It stands. Mend it."])"));
}

// REQ-STATION-243: Without a screen, the shell confirms the new time of a clock that was set, and reports with the
// status by how much it was set while the station uses the old time.
TEST(StationShell, ConfirmsAClockThatWasSet)
{
    ShellRig rig;
    EXPECT_THAT(rig.answerTo("status\n"), Not(HasSubstr("clockSetBy")));
    rig.watched.ahead = Seconds(90.0);
    EXPECT_THAT(rig.answerTo("status\n"), HasSubstr(R"("clockSetBy":90)"));
    EXPECT_EQ(rig.answerTo("use-new-time\n"), "ok\n");
}

// REQ-STATION-940
TEST(StationShell, ALockedMountIsNotItsOwn)
{
    ShellRig rig;
    profile::Profile locked = rig.profile;
    locked.rotctld.control = profile::ControlRule::Locked;
    locked.rotctld.lockedTo = "10.0.0.7";
    rig.setProfile(locked);
    EXPECT_EQ(rig.answerTo("track azel 20,30\n"), "error: The mount is locked to 10.0.0.7. Take the control first.\n");
}

// REQ-STATION-941: The shell lists the satellites that the station knows, and tracks them by name. A refusal gives the
// reason of the station.
TEST(StationShell, ListsTheSatellites)
{
    ShellRig rig;
    EXPECT_EQ(rig.answerTo("satellites\n"), "ok\n25544\t1728000000000\tISS (ZARYA)\n");
    EXPECT_EQ(rig.answerTo("track iss\n"), "error: The site of the mount is not set. Enter it in the profile.\n");
}

// REQ-STATION-942: The shell lets the station track the table of a file, and is answered when the file has been read.
// Permission is checked before and after the reading.
TEST(StationShell, TracksTheTableOfAFile)
{
    ShellRig rig;
    const QString path = local::socketPath(rig.runtime.path(), ShellRig::kPort);
    QLocalSocket socket;
    socket.connectToServer(path);
    socket.write("track table /tmp/way.txt\n");
    ASSERT_TRUE(fakes::waitUntil([&] { return bool(rig.answer); }));
    EXPECT_EQ(rig.asked, QStringLiteral("/tmp/way.txt"));
    rig.answer(targets::Target{.name = QStringLiteral("way.txt"), .kind = SkyPointing{20_deg, 30_deg}});
    ASSERT_TRUE(fakes::waitUntil([&] { return socket.state() == QLocalSocket::UnconnectedState; }));
    EXPECT_EQ(socket.readAll(), "ok\nway.txt\n");
    rig.run(Seconds(0.1));
    ASSERT_TRUE(rig.control.status().tracked);

    rig.answer = {};
    QLocalSocket other;
    other.connectToServer(path);
    other.write("track oem /tmp/one.oem\n");
    ASSERT_TRUE(fakes::waitUntil([&] { return bool(rig.answer); }));
    ASSERT_EQ(rig.answerTo("stop\n"), "ok\n");
    rig.answer(targets::Target{.name = QStringLiteral("ONE"), .kind = SkyPointing{20_deg, 30_deg}});
    ASSERT_TRUE(fakes::waitUntil([&] { return other.state() == QLocalSocket::UnconnectedState; }));
    EXPECT_THAT(other.readAll().toStdString(), HasSubstr("error: STOP is latched"));

    ShellRig locked;
    profile::Profile profile = locked.profile;
    profile.rotctld.control = profile::ControlRule::Locked;
    profile.rotctld.lockedTo = "10.0.0.7";
    locked.setProfile(profile);
    EXPECT_THAT(locked.answerTo("track table /tmp/way.txt\n"), HasSubstr("error: The mount is locked to 10.0.0.7."));
    EXPECT_FALSE(locked.answer) << "nothing is read in vain";
}

// REQ-STATION-201: A station without a local socket works, and its log gives the reason. Without a rotctld server there
// is no local socket.
TEST(StationShell, TheStationWorksWithoutIt)
{
    LinkedStation rig;
    rig.station->serveShell({});
    rig.station->openAll();
    rig.run(5);
    EXPECT_FALSE(rig.station->status().listening.isEmpty());
    EXPECT_THAT(logOf(rig), HasSubstr("shell: The local socket did not open: XDG_RUNTIME_DIR is not set. Commands of"));

    QTcpServer taken;
    ASSERT_TRUE(taken.listen(QHostAddress::LocalHost));
    const QTemporaryDir runtime;
    profile::Profile profile = anyPort();
    profile.rotctld.listen.port = taken.serverPort();
    LinkedStation deaf(profile);
    deaf.station->serveShell(runtime.path());
    deaf.station->openAll();
    EXPECT_TRUE(deaf.station->status().listening.isEmpty());
    EXPECT_FALSE(QFile::exists(runtime.filePath(QStringLiteral("boresight"))));
}

// REQ-SCHEDULE-916: The shell lists, arms, disarms and reports the schedule. Arming follows the rules for the operator.
TEST(StationShell, HasTheSchedule)
{
    const QTemporaryDir runtime;
    LinkedStation rig;
    rig.station->serveShell(runtime.path());
    rig.station->openAll();
    rig.run(5);
    const QString path = socketOf(rig.station->status(), runtime);
    EXPECT_THAT(askShell(path, "schedule-list\n"), HasSubstr("ok\n{\"armed\":false,"));
    EXPECT_THAT(askShell(path, "schedule-report\n"), HasSubstr("\"done\":0,"));
    EXPECT_EQ(askShell(path, "schedule-arm\n"), "error: The watch list of the profile is empty.\n");
    EXPECT_EQ(askShell(path, "schedule-disarm\n"), "ok\n");
    EXPECT_EQ(askShell(path, "schedule-rehearse\n"), "ok\n");
    EXPECT_TRUE(fakes::waitUntil([&] {
        return askShell(path, "schedule-rehearsal\n") ==
               "ok\n{\"night\":null,\"problem\":\"The watch list of the profile is empty.\",\"progress\":null}\n";
    }));
    EXPECT_EQ(rig.station->status().authority, Authority::Clients) << "nothing was taken";
}

// REQ-AZEL-923: "track azel.dat" tracks the Moon of WSJT-X, by the rules of any other target.
TEST(StationShell, TracksTheMoonOfWsjtx)
{
    ShellRig rig;
    EXPECT_THAT(rig.answerTo("track azel.dat\n"), HasSubstr("error: azel.dat cannot be used: "));
    ASSERT_EQ(rig.answerTo("stop\n"), "ok\n");
    EXPECT_THAT(rig.answerTo("track azel.dat\n"), HasSubstr("error: STOP is latched"));
    ASSERT_TRUE(rig.ask(request::ResetStop{}));
    fakes::AzelWriter writer(Site{});
    for (int second = 0; second < 2; ++second) {
        (void)rig.control.receive(writer.readingAt(rig.clock.utc() + std::chrono::seconds(second)));
    }
    EXPECT_EQ(rig.answerTo("track azel.dat\n"), "ok\nazel.dat\n");
    rig.run(Seconds(0.1));
    EXPECT_NE(rig.control.status().azel.phase, AzelPhase::Off);
}

// REQ-STATION-963: "track rotctld:HOST:PORT" is answered when that rotctld has reported a position. Permission is
// checked before and after the waiting.
TEST(StationShell, FollowsAnotherRotator)
{
    ShellRig rig;
    QLocalSocket socket;
    socket.connectToServer(local::socketPath(rig.runtime.path(), ShellRig::kPort));
    socket.write("track rotctld:10.0.0.7:4533\n");
    ASSERT_TRUE(fakes::waitUntil([&] { return bool(rig.found); }));
    const RotatorReport first{.name = rig.asked, .direction = SkyPointing{20_deg, 30_deg}};
    EXPECT_EQ(first.name, QStringLiteral("rotctld:10.0.0.7:4533"));
    (void)rig.control.receive(first);
    EXPECT_TRUE(rig.found(first.name));
    ASSERT_TRUE(fakes::waitUntil([&] { return socket.state() == QLocalSocket::UnconnectedState; }));
    EXPECT_EQ(socket.readAll(), "ok\nrotctld:10.0.0.7:4533\n");
    ASSERT_EQ(rig.answerTo("release\n"), "ok\n");

    rig.found = {};
    QLocalSocket other;
    other.connectToServer(local::socketPath(rig.runtime.path(), ShellRig::kPort));
    other.write("track rotctld:10.0.0.7:4533\n");
    ASSERT_TRUE(fakes::waitUntil([&] { return bool(rig.found); }));
    ASSERT_TRUE(rig.point(30.0, 30.0, kClient));
    EXPECT_FALSE(rig.found(first.name));
    ASSERT_TRUE(fakes::waitUntil([&] { return other.state() == QLocalSocket::UnconnectedState; }));
    EXPECT_THAT(other.readAll().toStdString(), HasSubstr("Take the control first.\n"));
}

// REQ-POSITION-41: "track position" tracks the object that reports its position, by the rules of any other target.
TEST(StationShell, TracksWhatReportsItsPosition)
{
    ShellRig rig;
    EXPECT_EQ(rig.answerTo("track position\n"), "error: No position to track: the site of the mount is not set\n");
    profile::Profile there = rig.profile;
    there.site = {.known = true, .latitude = 38_deg, .longitude = -9_deg};
    rig.setProfile(there);
    EXPECT_TRUE(rig.control.receive(
        position::PositionText{.site = {.latitude = 38.1_deg, .longitude = -9_deg, .heightMetres = 5000.0}}));
    EXPECT_EQ(rig.answerTo("track position\n"), "ok\nposition\n");
    rig.run(Seconds(0.2));
    EXPECT_EQ(rig.control.status().position.phase, PositionPhase::Following);
}

// Story: while the mount tracked the Moon at 0.004°/s, boresightctl reported NOT MOVING.
// REQ-STATION-943: The shell reports the state, its reason and the motion with the same words as the header of the
// window.
TEST(StationShell, ReportsTheStateOfTheWindow)
{
    ShellRig rig;
    EXPECT_EQ(rig.answerTo("status\n"), "ok\n{\"motion\":\"\",\"reason\":\"\",\"state\":\"STANDBY\"}\n");
    EXPECT_EQ(rig.answerTo("track azel 20,30\n"), "ok\n20.00° 30.00°\n");
    rig.run(Seconds(1.0));
    EXPECT_THAT(rig.answerTo("status\n"),
                HasSubstr("{\"motion\":\"track 20.00° 30.00°\",\"reason\":\"\",\"state\":\"SLEW\"}"));
    EXPECT_EQ(rig.answerTo("stop\n"), "ok\n");
    EXPECT_THAT(rig.answerTo("status\n"), HasSubstr("\"state\":\"STOPPED\""));
}

}  // namespace
}  // namespace boresight
