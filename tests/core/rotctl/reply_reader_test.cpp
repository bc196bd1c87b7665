// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/rotctl/reply_reader.h"

#include <gtest/gtest.h>

#include <sstream>
#include <string>

namespace boresight::rotctl {
namespace {

using Progress = ReplyReader::Progress;

// The result of these lines, read until they are complete or unknown. Empty: more lines are needed.
struct Outcome
{
    Progress progress = Progress::More;
    Reply reply;
    int lines = 0;
};

Outcome readAll(Question question, Form form, const std::string& text)
{
    ReplyReader reader(question, form);
    Outcome outcome;
    std::istringstream lines(text);
    for (std::string line; outcome.progress == Progress::More && std::getline(lines, line);) {
        outcome.progress = reader.take(line);
        ++outcome.lines;
    }
    outcome.reply = reader.reply();
    return outcome;
}

std::optional<AxisPosition> position(Form form, const std::string& text)
{
    const Outcome outcome = readAll(Question::Position, form, text);
    return outcome.progress == Progress::Whole ? outcome.reply.position : std::nullopt;
}

std::optional<RotatorState> state(Form form, const std::string& text)
{
    const Outcome outcome = readAll(Question::State, form, text);
    return outcome.progress == Progress::Whole ? outcome.reply.state : std::nullopt;
}

const RotatorState kDummy{.azimuth = {.min = -180_deg, .max = 450_deg},
                          .elevation = {.min = 0_deg, .max = 90_deg},
                          .type = RotatorType::AzEl};

// As rotctld of Hamlib 4.5.4 sends them.
const std::string kExtendedState =
    "dump_state:\nrotctld Protocol Ver: 1\nRotor Model: 1\nMinimum Azimuth: -180.000000\n"
    "Maximum Azimuth: 450.000000\nMinimum Elevation: 0.000000\nMaximum Elevation: 90.000000\nSouth Zero: 0\n"
    "rot_type=AzEl\ndone\nRPRT 0\n";
const std::string kPlainState =
    "1\n1\nmin_az=-180.000000\nmax_az=450.000000\nmin_el=0.000000\nmax_el=90.000000\nsouth_zero=0\nrot_type=AzEl\n"
    "done\n";

// REQ-ROTCTL-03: Positions are read in both forms that rotctld writes.
TEST(ReplyReader, ReadsAPosition)
{
    const AxisPosition there{.azimuth = Angle::fromDegrees(-12.5), .elevation = Angle::fromDegrees(5.25)};
    EXPECT_EQ(position(Form::Extended, "get_pos:\nAzimuth: -12.50\nElevation: 5.25\nRPRT 0\n"), there);
    EXPECT_EQ(position(Form::Plain, "-12.50\n5.25\n"), there);
    EXPECT_EQ(position(Form::Plain, "370.00\n5.00\n")->azimuth, 370_deg) << "370° is not 10°";
}

// REQ-ROTCTL-04: The limits are read from the replies of all versions of rotctld.
TEST(ReplyReader, ReadsTheLimitsOfAllAges)
{
    EXPECT_EQ(state(Form::Extended, kExtendedState), kDummy);
    EXPECT_EQ(state(Form::Plain, kPlainState), kDummy);
    RotatorState old = kDummy;
    old.type = RotatorType::Unknown;
    EXPECT_EQ(state(Form::Plain, "0\n1\n-180.000000\n450.000000\n0.000000\n90.000000\n"), old);
    const std::string both = "1\n1\n-180.000000\n450.000000\n0.000000\n90.000000\n" + kPlainState.substr(4);
    EXPECT_EQ(state(Form::Plain, both), kDummy);
    const std::string azimuthOnly = "1\n601\nmin_az=0.0\nmax_az=450.0\nmin_el=0.0\nmax_el=0.0\nrot_type=Az\ndone\n";
    EXPECT_EQ(state(Form::Plain, azimuthOnly)->type, RotatorType::Az);
}

// REQ-ROTCTL-05: An error of Hamlib is read in place of values, and as the reply to commands.
TEST(ReplyReader, ReadsErrors)
{
    const auto code = [](Question question, Form form, const std::string& text) {
        const Outcome outcome = readAll(question, form, text);
        return outcome.progress == Progress::Whole ? std::optional(outcome.reply.code) : std::nullopt;
    };
    EXPECT_EQ(code(Question::Position, Form::Plain, "RPRT -5\n"), -5);
    EXPECT_EQ(code(Question::Position, Form::Extended, "get_pos:\nRPRT -5\n"), -5);
    EXPECT_EQ(code(Question::State, Form::Extended, "RPRT -11\n"), -11) << "without its first line";
    EXPECT_EQ(code(Question::Order, Form::Extended, "set_pos: 10.00 5.00\nRPRT 0\n"), 0);
    EXPECT_EQ(code(Question::Order, Form::Extended, "set_pos: 500.00 5.00\nRPRT -1\n"), -1);
    EXPECT_EQ(code(Question::Order, Form::Plain, "RPRT 0\n"), 0);
    EXPECT_EQ(code(Question::Stop, Form::Extended, "stop:\nRPRT 0\n"), 0);
    for (const char* const odd : {"RPRT 1\n", "RPRT\n", "RPRT -1x\n", "RPRT -100\n", "rprt 0\n", "RPRT 0.0\n"}) {
        EXPECT_EQ(readAll(Question::Stop, Form::Plain, odd).progress, Progress::Strange) << odd;
    }
}

// REQ-ROTCTL-06: A reply that does not belong to the query is reported as unknown: a damaged number, another command,
// another server.
TEST(ReplyReader, WhatIsNoAnswerIsStrange)
{
    for (const char* const odd :
         {"nan\n5.00\n", "inf\n5.00\n", "10.00\n1e9\n", "10,00\n5.00\n", "10.00 5.00\n", "10.0.0\n", "AZ=180  EL=090\n",
          "+0180+0090\n", "SSH-2.0-OpenSSH_9.2\n", "10.00\nRPRT 0\n", "RPRT 0\n"}) {
        EXPECT_EQ(readAll(Question::Position, Form::Plain, odd).progress, Progress::Strange) << odd;
    }
    for (const char* const odd :
         {"get_pos:\nAzimuth: 10.00\nRPRT 0\n", "get_pos:\nAzimuth: ten\nElevation: 5\nRPRT 0\n", "stop:\nRPRT 0\n",
          "10.00\n5.00\n", "RPRT 0\n", "HTTP/1.1 400 Bad Request\n", "get_pos:\nAzimuth: nan\n"}) {
        EXPECT_EQ(readAll(Question::Position, Form::Extended, odd).progress, Progress::Strange) << odd;
    }
    // The replies of a rigctld, whose port is the next one.
    EXPECT_EQ(readAll(Question::State, Form::Extended,
                      "dump_state:\n1\n1\n0\n150000.000000 1500000000.000000 0x1ff -1 -1 0x17e00007 0x1f\nRPRT 0\n")
                  .progress,
              Progress::Strange);
    EXPECT_EQ(readAll(Question::State, Form::Plain,
                      "1\n1\n0\n150000.000000 1500000000.000000 0x1ff -1 -1 0x17e00007 0x1f\n0 0 0 0 0 0 0\n")
                  .progress,
              Progress::Strange);
    std::string endless = "get_pos:\n";
    for (int line = 0; line < 100; ++line) {
        endless += "Label: value\n";
    }
    EXPECT_EQ(readAll(Question::Position, Form::Extended, endless).progress, Progress::Strange);
}

// REQ-ROTCTL-07: A reply without its end is not accepted.
TEST(ReplyReader, HalfAnAnswerIsNone)
{
    for (const auto& [form, text] : {std::pair{Form::Extended, kExtendedState}, {Form::Plain, kPlainState}}) {
        for (std::size_t size = 0; size + 1 < text.size(); ++size) {
            const std::string half = text.substr(0, size);
            const auto read = readAll(Question::State, form, half.substr(0, half.rfind('\n') + 1));
            EXPECT_EQ(read.progress, Progress::More) << half;
        }
    }
    EXPECT_EQ(readAll(Question::Position, Form::Plain, "10.00\n").progress, Progress::More);
}

}  // namespace
}  // namespace boresight::rotctl
