// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/rotctld/session.h"

#include "tests/fakes/dummy_rotator.h"
#include "tests/fakes/manual_clock.h"

#include <gtest/gtest.h>

#include <array>
#include <string>

namespace boresight::rotctld {
namespace {

struct SessionFixture : public ::testing::Test
{
    std::string answer(std::string_view bytes)
    {
        session.receive(bytes);
        std::string reply;
        while (session.step(reply)) {
        }
        return reply;
    }

    fakes::ManualClock clock;
    fakes::DummyRotator rotator{clock};
    Session session{{.id = 7, .address = "127.0.0.1:5"}, rotator, clock, DumpStateForm::OldAndNew};
};

using RotctldSession = SessionFixture;

// REQ-ROTCTLD-04: A position is a direction: azimuth -3600°…3600°, elevation -90°…180°. Anything else is answered with
// RPRT -1 and never reaches the Rotator.
TEST_F(RotctldSession, RefusesWhatIsNoPosition)
{
    for (const char* command :
         {"P nan 10\n", "P 10 nan\n", "P inf 0\n", "P 0 -inf\n", "P 1e400 0\n", "P abc 5\n", "P ?\n", "P 1e38 10\n",
          "P -3600.5 10\n", "P 10 180.5\n", "P 10 -90.5\n", "\\set_pos x y\n", "P - -\n"}) {
        EXPECT_EQ(answer(command), "RPRT -1\n") << command;
    }
    EXPECT_FALSE(rotator.lastRequest.has_value());
    EXPECT_EQ(answer("P 1000.5 -90\n"), "RPRT -1\n");  // every wrap reaches the Rotator, and this one has limits
    EXPECT_NEAR(rotator.lastRequest->azimuth.degrees(), 1000.5, 1e-4);
    EXPECT_NEAR(rotator.lastRequest->elevation.degrees(), -90.0, 1e-9);
}

// Story: the log showed "elevation 200.00.. is outside -90........180..".
// REQ-ROTCTLD-09b: The log shows what a client sent and why it was refused, with every printable character.
TEST_F(RotctldSession, RefusedLinesKeepTheirDegreeSigns)
{
    EXPECT_EQ(answer("P 10° 200\n"), "RPRT -1\n");
    ASSERT_FALSE(rotator.remarks.empty());
    EXPECT_EQ(rotator.remarks.back(), "\"P 10° 200\" refused: elevation 200.00° is outside -90°…180°");
    EXPECT_EQ(answer("P 1e38 10\n"), "RPRT -1\n");
    EXPECT_EQ(rotator.remarks.back(), "\"P 1e38 10\" refused: azimuth 1e+38° is outside -3600°…3600°");
    EXPECT_EQ(answer("P \xff\x1b[2J 5\n"), "RPRT -1\n");
    EXPECT_EQ(rotator.remarks.back().find('\x1b'), std::string::npos);
}

// Found by the fuzzer: the minutes in seconds exceeded the largest number, and the client received "inf" degrees.
TEST_F(RotctldSession, AnswersNoInfiniteNumber)
{
    EXPECT_EQ(answer("E 0 1e308 0\n"), "RPRT -1\n");
    EXPECT_EQ(answer("E 10 30 1\n"), "-10.500000\n");
}

TEST_F(RotctldSession, HandsTheRotatorsErrorsOn)
{
    const std::array<std::pair<ErrorCode, const char*>, 8> codes{{{ErrorCode::OutOfRange, "RPRT -1\n"},
                                                                  {ErrorCode::NoAnswer, "RPRT -6\n"},
                                                                  {ErrorCode::NoDevice, "RPRT -6\n"},
                                                                  {ErrorCode::Io, "RPRT -6\n"},
                                                                  {ErrorCode::Protocol, "RPRT -8\n"},
                                                                  {ErrorCode::Refused, "RPRT -9\n"},
                                                                  {ErrorCode::Busy, "RPRT -9\n"},
                                                                  {ErrorCode::NotAvailable, "RPRT -11\n"}}};
    for (const auto& [code, reply] : codes) {
        rotator.fault = Error{.code = code, .text = QStringLiteral("for the test")};
        EXPECT_EQ(answer("P 10 5\n"), reply);
        EXPECT_EQ(answer("K\n"), reply);
        EXPECT_EQ(answer("M UP 5\n"), reply);
        EXPECT_EQ(answer("p\n"), reply);
        EXPECT_EQ(answer("+p\n"), std::string("get_pos:\n") + reply);
    }
    EXPECT_TRUE(session.ending().isEmpty());
}

// REQ-ROTCTLD-08: Clients can change neither limits nor other settings of the profile.
TEST_F(RotctldSession, RefusesConfiguration)
{
    for (const char* token : {"min_az", "max_az", "min_el", "max_el", "south_zero"}) {
        EXPECT_EQ(answer(std::string("C ") + token + " 0\n"), "RPRT -9\n");
    }
    EXPECT_EQ(answer("C timeout 0\n"), "RPRT -1\n");
    EXPECT_EQ(rotator.remarks.at(0), "wanted to change min_az: refused");
    EXPECT_EQ(rotator.limits().maxAzimuth, 450_deg);
}

// Hamlib 4.0 … 4.5.0 reads lines 3 to 6 by position, later versions the tagged lines (core/rotctld/HAMLIB.md).
TEST_F(RotctldSession, DumpsItsStateForOldAndNewClients)
{
    EXPECT_EQ(answer("\\dump_state\n"),
              "1\n1\n-180.000000\n450.000000\n0.000000\n90.000000\nmin_az=-180.000000\nmax_az=450.000000\n"
              "min_el=0.000000\nmax_el=90.000000\nsouth_zero=0\nrot_type=AzEl\ndone\n");
}

TEST_F(RotctldSession, PausesByItsOwnClock)
{
    EXPECT_EQ(answer("\\pause 2\np\n"), "");
    EXPECT_TRUE(session.paused());
    clock.advance(Seconds(1.9));
    EXPECT_EQ(answer(""), "");
    clock.advance(Seconds(0.1));
    EXPECT_EQ(answer(""), "RPRT 0\n0.00\n0.00\n");
    EXPECT_EQ(answer("\\pause -1\n"), "RPRT -1\n");
}

TEST_F(RotctldSession, RunsNothingBehindAPauseOfWhoLeft)
{
    EXPECT_EQ(answer("\\pause 60\nK\n"), "");
    session.endOfInput();
    EXPECT_EQ(answer(""), "");
    EXPECT_EQ(session.ending().toStdString(), "closed the connection during the pause it asked for");
    EXPECT_EQ(rotator.actions, 0);
}

TEST_F(RotctldSession, BoundsWhatWaitsBehindAPause)
{
    EXPECT_EQ(answer("\\pause 60\n"), "");
    EXPECT_EQ(answer(std::string(5000, 'p')), "");
    EXPECT_EQ(session.ending().toStdString(), "sent more than 4096 bytes during the pause it asked for");
}

TEST_F(RotctldSession, CountsAndTellsOddCommands)
{
    EXPECT_EQ(answer("Z what\n\\foo\nP nan 1\nv FOO\n"), "RPRT -1\nRPRT -1\n");
    EXPECT_EQ(session.habits().oddCommands(), 4U);
    ASSERT_EQ(rotator.remarks.size(), 3U);  // further ones are only counted
    EXPECT_EQ(rotator.remarks[0], "unknown command \"Z what\"");
    EXPECT_EQ(session.habits().lastCommand().toStdString(), "v FOO");
    EXPECT_EQ(answer("0\n0\n0\n0\n0\np\n0\n"), "0.00\n0.00\n");  // a good command in between restarts the count
    EXPECT_EQ(answer("0\n0\n0\n0\n0\n0\n0\np\n"), "");
    EXPECT_EQ(session.ending().toStdString(), "sent 8 unknown commands in a row");
    EXPECT_TRUE(session.dropped());
}

// Story: a shell that sent the mount to 95° of elevation received RPRT 0, and the mount went to 90°.
// REQ-ROTCTLD-1413: get_outcome reports why the last command of the client was refused, or where the mount goes instead
// of the target. It is empty otherwise.
TEST_F(RotctldSession, ReportsTheOutcomeInWords)
{
    EXPECT_EQ(answer("\\get_outcome\n"), "\n");
    EXPECT_EQ(answer("P 10 170\n"), "RPRT -1\n");
    EXPECT_EQ(answer("+\\get_outcome\n"), "get_outcome:\nOutcome: outside the limits\nRPRT 0\n");
    rotator.became = QStringLiteral("30.0° / 90.0°: elevation 95.0° above limit 90.0°");
    EXPECT_EQ(answer("P 30 40\n"), "RPRT 0\n");
    EXPECT_EQ(answer("\\get_outcome\n"), "30.0° / 90.0°: elevation 95.0° above limit 90.0°\n");
    EXPECT_EQ(answer("\\get_outcome\n"), "30.0° / 90.0°: elevation 95.0° above limit 90.0°\n") << "asked again";
    rotator.became.clear();
    EXPECT_EQ(answer("P 30 40\n+\\get_outcome\n+_\n"),
              "RPRT 0\nget_outcome:\nOutcome: \nRPRT 0\nget_info:\nInfo: Dummy rotator\nRPRT 0\n");
    EXPECT_EQ(session.habits().oddCommands(), 0U);
}

// REQ-ROTCTLD-1413
TEST_F(RotctldSession, ReportsTheReasonOfEachRefusal)
{
    rotator.fault = Error{.code = ErrorCode::Refused, .text = QStringLiteral("STOP is latched. Reset STOP first.")};
    EXPECT_EQ(answer("K\n"), "RPRT -9\n");
    EXPECT_EQ(answer("\\get_outcome\n"), "STOP is latched. Reset STOP first.\n");
    rotator.fault.reset();
    EXPECT_EQ(answer("K\n"), "RPRT 0\n");
    EXPECT_EQ(answer("\\get_outcome\n"), "\n");
}

// Story: a Gpredict whose targets were all outside the limits had no program in the list of the clients.
// REQ-ROTCTLD-1421: The program of a client is recognised from every command that the server can read, also if the
// mount does not reach its target. An odd command shows nothing about the program.
TEST_F(RotctldSession, RecognisesTheProgramOfARefusedClient)
{
    EXPECT_EQ(answer("p\n"), "0.00\n0.00\n");
    EXPECT_EQ(answer("P nan 1.25\n"), "RPRT -1\n");
    EXPECT_EQ(session.habits().program(), "");
    EXPECT_EQ(answer("P 12.34 170.25\n"), "RPRT -1\n");
    EXPECT_EQ(session.habits().program(), "Gpredict or SatDump");
}

// REQ-ROTCTLD-1420
TEST_F(RotctldSession, CountsTheErrorsInARow)
{
    for (int i = 0; i < 3; ++i) {
        EXPECT_EQ(answer("P 12.34 170.25\n"), "RPRT -1\n");
        EXPECT_EQ(answer("p\n"), "0.00\n0.00\n");
    }
    EXPECT_EQ(session.habits().errors().inARow(), 3);
    EXPECT_EQ(session.habits().errors().error().value().code, ErrorCode::OutOfRange);
    EXPECT_EQ(answer("p\n"), "0.00\n0.00\n");
    EXPECT_EQ(session.habits().errors().inARow(), 0);
}

TEST_F(RotctldSession, HelpNamesEveryCommand)
{
    const std::string help = answer("??\n");
    for (const CommandSpec& spec : commandTable()) {
        EXPECT_NE(help.find(spec.name), std::string::npos) << spec.name;
    }
    EXPECT_NE(help.find("P: set_pos     (Azimuth, Elevation)\n"), std::string::npos);
}

struct Habit
{
    const char* bytes;
    const char* program;
};

class RotctldPrograms : public SessionFixture, public ::testing::WithParamInterface<Habit>
{};

TEST_P(RotctldPrograms, AreRecognised)
{
    answer(GetParam().bytes);
    EXPECT_EQ(session.habits().program(), GetParam().program);
}

INSTANTIATE_TEST_SUITE_P(
    Habits, RotctldPrograms,
    ::testing::Values(
        Habit{"p\nP 228.91 44.30\n", "Gpredict or SatDump"}, Habit{"p\nP 228,91 44,30\n", "Gpredict or SatDump"},
        Habit{"P 228.91 44.30\n", "predict or flyby"}, Habit{"\\dump_state\np\n", "Hamlib network client"},
        Habit{"P 12.500000 7.000000\n", "Hamlib network client"}, Habit{"+\\dump_state\n\n", "CQRLOG"},
        Habit{"+\\get_info\n", "HamClock"}, Habit{"set_pos 123.4 5.6\n", "Look4Sat"},
        Habit{"\\set_pos 123.4 5.6\n", "Look4Sat"}, Habit{"P 13.9709333812 1.67216844\n", "SatNOGS client"},
        Habit{"P 211.3 20.0\n", "radiosonde_auto_rx"}, Habit{"|\\set_pos 113 10\n", "shell script"},
        Habit{"P 123.456 4\n", "SDRangel"}, Habit{"p\n", ""}, Habit{"P 10 5\n", ""}));

}  // namespace
}  // namespace boresight::rotctld
