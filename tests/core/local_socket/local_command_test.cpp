// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/local_socket/local_command.h"

#include <QDir>
#include <QFile>
#include <QTemporaryDir>

#include <gtest/gtest.h>

namespace boresight::local {
namespace {

// REQ-LOCALSOCKET-01: The commands are take, release, stop, reset-stop, override-wind, use-new-time, satellites,
// status, transmit, antennas, those of the schedule, track with a target, antenna with a name, simulate with a fault,
// console with a line, console-lines, protocol-log-on, protocol-log-off, and protocol-lines with a number. No other
// word is a command. The answer is ok and the lines of the answer, or one line with error and the reason.
TEST(LocalCommandTest, EachHasItsWord)
{
    for (const char* const word :
         {"take", "release", "stop", "reset-stop", "override-wind", "use-new-time", "satellites", "antennas",
          "schedule-list", "schedule-arm", "schedule-disarm", "schedule-report", "schedule-rehearse",
          "schedule-rehearsal", "status", "transmit", "console-lines", "protocol-log-on", "protocol-log-off"}) {
        const auto request = parseRequest(word);
        ASSERT_TRUE(request) << word;
        EXPECT_EQ(wordOf(request->command), word);
        EXPECT_EQ(requestLine(*request), QByteArray(word) + '\n');
        EXPECT_EQ(parseRequest(QByteArray(word) + "\r"), *request) << word;
    }
    const LocalRequest track{.command = LocalCommand::Track, .target = "cas a"};
    EXPECT_EQ(parseRequest("track cas a"), track);
    EXPECT_EQ(parseRequest(" track   cas a \r"), track);
    EXPECT_EQ(requestLine(track), "track cas a\n");
    const LocalRequest antenna{.command = LocalCommand::UseAntenna, .target = "70 cm"};
    EXPECT_EQ(parseRequest("antenna 70 cm\r"), antenna);
    EXPECT_EQ(requestLine(antenna), "antenna 70 cm\n");
    const LocalRequest gust{.command = LocalCommand::Simulate, .target = "wind az:60Nm+3"};
    EXPECT_EQ(parseRequest("simulate wind az:60Nm+3"), gust);
    EXPECT_EQ(requestLine(gust), "simulate wind az:60Nm+3\n");
    const LocalRequest lines{.command = LocalCommand::ProtocolLines, .target = "149"};
    EXPECT_EQ(parseRequest("protocol-lines 149"), lines);
    EXPECT_EQ(requestLine(lines), "protocol-lines 149\n");
    for (const char* const other :
         {"", "simulate", "protocol-lines", "protocol-log-on now", "Stop", "stop now", "reset_stop", "P 10 20",
          "take\nstop", "track", "track ", "tracks moon", "satellites all", "antenna", "antennas 70 cm"}) {
        EXPECT_FALSE(parseRequest(other)) << other;
    }
}

// REQ-LOCALSOCKET-01
TEST(LocalCommandTest, TheAnswerIsOkOrTheReason)
{
    EXPECT_EQ(answerText(QByteArray()), "ok\n");
    EXPECT_EQ(answerText(QByteArray("Moon\n")), "ok\nMoon\n");
    const LocalAnswer refused = failure(ErrorCode::Refused, QStringLiteral("STOP is latched.\nReset STOP first."));
    EXPECT_EQ(answerText(refused), "error: STOP is latched. Reset STOP first.\n");
    EXPECT_EQ(parseAnswer("ok\n").value(), "");
    EXPECT_EQ(parseAnswer("ok\nMoon\n").value(), "Moon\n");
    const auto reason = parseAnswer(answerText(refused));
    ASSERT_FALSE(reason);
    EXPECT_EQ(reason.error().code, ErrorCode::Refused);
    EXPECT_EQ(reason.error().text, QStringLiteral("STOP is latched. Reset STOP first."));
    for (const char* const other : {"RPRT 0\n", "", "o", "okay\n"}) {
        EXPECT_EQ(parseAnswer(other).error().code, ErrorCode::Protocol) << other;
    }
}

// REQ-LOCALSOCKET-940: A satellite is a line with its number, its epoch to the millisecond and its name. An incomplete
// list is refused.
TEST(LocalCommandTest, SatellitesAreLines)
{
    const UtcTime epoch(std::chrono::milliseconds(1'764'000'000'123));
    const std::vector<KnownSatellite> known{{.number = 25544, .epoch = epoch, .name = QStringLiteral("ISS (ZARYA)")},
                                            {.number = 7, .epoch = epoch, .name = {}}};
    const QByteArray lines = satelliteLine(known[0]) + satelliteLine(known[1]);
    EXPECT_EQ(lines, "25544\t1764000000123\tISS (ZARYA)\n7\t1764000000123\t\n");
    EXPECT_EQ(parseSatellites(lines).value(), known);
    EXPECT_TRUE(parseSatellites({}).value().empty());
    EXPECT_EQ(satelliteLine({.number = 1, .name = QStringLiteral("a\tb\nc")}), "1\t0\ta b c\n");
    for (const char* const bad : {"25544\t1\tISS", "x\t1\tISS\n", "1\tx\tISS\n", "1\t1\n", "1\t1\ta\tb\n", "\n"}) {
        EXPECT_FALSE(parseSatellites(bad)) << bad;
    }
}

// REQ-ANTENNA-940: An antenna is a line: whether it is in use, beam width and offsets in degrees, and its name. An
// incomplete list is refused.
TEST(LocalCommandTest, AntennasAreLines)
{
    const std::vector<KnownAntenna> known{
        {.antenna = {.beamWidth = 10_deg}, .isInUse = false},
        {.antenna = {.name = "70 cm", .beamWidth = 20.5_deg, .across = -2_deg, .up = 3.25_deg}, .isInUse = true}};
    const QByteArray lines = antennaLine(known[0]) + antennaLine(known[1]);
    EXPECT_EQ(lines, "0\t10.000000\t0.000000\t0.000000\tmain\n1\t20.500000\t-2.000000\t3.250000\t70 cm\n");
    const auto read = parseAntennas(lines);
    ASSERT_TRUE(read);
    ASSERT_EQ(read->size(), 2U);
    EXPECT_EQ(read->at(1).antenna.name, "70 cm");
    EXPECT_TRUE(read->at(1).isInUse);
    EXPECT_NEAR(read->at(1).antenna.across.degrees(), -2.0, 1e-9);
    for (const char* const bad : {"1\t1\t2\t3\tx", "2\t1\t2\t3\tx\n", "1\tnan\t2\t3\tx\n", "1\t1\t2\tx\n", "\n"}) {
        EXPECT_FALSE(parseAntennas(bad)) << bad;
    }
}

// REQ-LOCALSOCKET-930: A station of the same user is tried before the system service. The socket of the service is in
// the folder that systemd creates for it.
TEST(LocalCommandTest, TheServiceIsAskedWhereTheUserHasNoStation)
{
    constexpr std::uint16_t kPort = 4533;
    const QTemporaryDir user;
    const QTemporaryDir system;
    const QString own = socketPath(user.path(), kPort);
    const auto asked = [&] { return socketToAsk(user.path(), system.path(), kPort); };
    EXPECT_EQ(socketToAsk({}, system.path(), kPort), QString());
    EXPECT_EQ(asked(), own) << "it may come";
    ASSERT_TRUE(QDir(system.path()).mkdir(QStringLiteral("boresight")));
    EXPECT_EQ(asked(), socketPath(system.path(), kPort)) << "even if this user cannot see the socket";
    EXPECT_EQ(socketToAsk({}, system.path(), kPort), socketPath(system.path(), kPort));
    ASSERT_TRUE(QDir(user.path()).mkdir(QStringLiteral("boresight")));
    EXPECT_EQ(asked(), socketPath(system.path(), kPort)) << "the folder of a station that has ended";
    QFile socket(own);
    ASSERT_TRUE(socket.open(QIODevice::WriteOnly));
    EXPECT_EQ(asked(), own);
}

}  // namespace
}  // namespace boresight::local
