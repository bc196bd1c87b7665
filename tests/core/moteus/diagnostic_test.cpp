// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/moteus/diagnostic.h"

#include "core/moteus/frame_server.h"
#include "tests/core/moteus/recording_device.h"
#include "tests/fakes/text_of.h"

#include <gtest/gtest.h>

#include <functional>

namespace boresight::moteus {
namespace {

using Lines = DiagnosticClient::Lines;

// A client and the console of a drive, with a bus in between that the test disturbs.
class MoteusDiagnostic : public testing::Test
{
protected:
    Result<Lines> run(const char* command, const std::string& answer)
    {
        EXPECT_TRUE(client.start(command));
        device.received.clear();
        for (int turn = 0; turn < 2'000 && !client.isFinished(); ++turn) {
            const auto frame = client.nextFrame();
            if (!frame) {
                ADD_FAILURE() << "nothing to send, nothing awaited";
                break;
            }
            exchange(*frame);
            if (device.received.ends_with('\n')) {
                received = device.received;
                device.text += answer;
                device.received.clear();
            }
        }
        return client.takeAnswer();
    }

    void exchange(const CanFrame& frame)
    {
        ++frames;
        auto reply = serve(frame);
        if (!fromCanId(frame.id).replyWanted) {
            EXPECT_FALSE(reply);
            return;
        }
        if (repeatsReplies && previous) {
            client.handleReply(*previous);
        }
        if (reply) {
            previous = *decodeReply(*reply);
        }
        if (reply && !isLost(frames)) {
            client.handleReply(*decodeReply(*reply));
        } else {
            client.handleSilence();
        }
    }

    std::optional<CanFrame> serve(const CanFrame& frame)
    {
        if (oldFirmware && frame.data[0] == 0x44) {
            CanFrame empty = *server.serve(frame, {}, idle);
            empty.size = 0;
            return empty;
        }
        return server.serve(frame, {}, device);
    }

    RecordingDevice device;
    RecordingDevice idle;
    FrameServer server;
    DiagnosticClient client{{.destination = 1, .maxEmptyAnswers = 20}};
    bool oldFirmware = false;
    bool repeatsReplies = false;  // the previous reply arrives once more, late
    std::optional<Reply> previous;
    std::function<bool(int)> isLost = [](int) { return false; };
    int frames = 0;
    std::string received;
};

// REQ-MOTEUS-09 (MoteusDiagnostic.*): Console answers arrive complete in spite of lost replies. Old firmware without
// flow control works. There a lost reply is an error, not a shortened answer. Every wait ends.
// REQ-MOTEUS-11
TEST_F(MoteusDiagnostic, TelemetryIsABlockOfBytesOrLines)
{
    const std::string bytes("\x01\n\r\nOK\r\nERR\0", 13);
    const auto block = run("tel get motor_position", "emit motor_position\r\n" + std::string("\x0d\0\0\0", 4) + bytes);
    ASSERT_TRUE(block) << textOf(block.error());
    EXPECT_EQ(*block, Lines{bytes});
    const auto empty = run("tel get nothing", std::string("emit nothing\r\n\0\0\0\0", 18));
    ASSERT_TRUE(empty);
    EXPECT_EQ(*empty, Lines{std::string()});
    const auto lines = run("tel get git", "git.dirty 0\r\ngit.timestamp 7\r\nOK\r\n");
    ASSERT_TRUE(lines);
    EXPECT_EQ(*lines, (Lines{"git.dirty 0", "git.timestamp 7"}));
    EXPECT_EQ(run("tel get x", "ERR unknown name\r\n").error().code, ErrorCode::Refused);
}

TEST_F(MoteusDiagnostic, ABlockThatNeverEndsIsGivenUp)
{
    const auto cut = run("tel get git", std::string("emit git\r\n\x40\0\0\0half", 18));
    ASSERT_FALSE(cut);
    EXPECT_EQ(cut.error().code, ErrorCode::NoAnswer);
    const auto endless = run("tel get git", "emit git\r\n\xff\xff\xff\xff");
    EXPECT_FALSE(endless);
}

TEST_F(MoteusDiagnostic, ConfGetEndsWithItsOneLine)
{
    EXPECT_EQ(run("conf get id.id", "1\r\n"), Lines{"1"});
    EXPECT_EQ(received, "conf get id.id\n");
}

TEST_F(MoteusDiagnostic, OtherAnswersEndWithOk)
{
    EXPECT_EQ(run("conf set id.id 2", "OK\r\n"), Lines{});
    EXPECT_EQ(run("conf list", "id\r\nservo\r\nOK\r\n"), (Lines{"id", "servo"}));
}

TEST_F(MoteusDiagnostic, AnErrorIsToldInTheDrivesWords)
{
    const auto answer = run("conf get nothing", "ERR unknown group\r\n");
    ASSERT_FALSE(answer);
    EXPECT_EQ(answer.error(), (Error{ErrorCode::Refused, QStringLiteral("The drive answers: ERR unknown group")}));
}

TEST_F(MoteusDiagnostic, LongCommandsTravelInParts)
{
    const std::string command = "conf set servo." + std::string(80, 'x') + " 1";
    EXPECT_EQ(run(command.c_str(), "OK\r\n"), Lines{});
    EXPECT_EQ(received, command + '\n');
}

TEST_F(MoteusDiagnostic, LongAnswersArriveWholeThroughLostReplies)
{
    std::string answer;
    Lines lines;
    for (int i = 0; i < 200; ++i) {
        lines.push_back("servo.value." + std::to_string(i) + " 0.100000");
        answer += lines.back() + "\r\n";
    }
    isLost = [](int frame) { return frame % 3 == 0 || frame % 7 == 0; };
    EXPECT_EQ(run("conf enumerate", answer + "OK\r\n"), lines);
}

TEST_F(MoteusDiagnostic, LateCopiesOfRepliesAddNothing)
{
    repeatsReplies = true;
    isLost = [](int frame) { return frame % 5 == 0; };
    const std::string line(150, 'a');
    EXPECT_EQ(run("conf list", line + "\r\nb\r\nOK\r\n"), (Lines{line, "b"}));
}

TEST_F(MoteusDiagnostic, OldTextIsDroppedFirst)
{
    device.text = "left over from somebody else\r\nOK\r\n";
    EXPECT_EQ(run("conf get id.id", "7\r\n"), Lines{"7"});
}

TEST_F(MoteusDiagnostic, TelStopWorksWhileTelemetryRuns)
{
    device.text = std::string(300, '~') + "\r\n";
    EXPECT_TRUE(run("tel stop", "OK\r\n"));
}

TEST_F(MoteusDiagnostic, OldFirmwareIsPolledWithoutFlowControl)
{
    oldFirmware = true;
    EXPECT_EQ(run("conf get id.id", "1\r\n"), Lines{"1"});
    EXPECT_EQ(run("conf list", std::string(100, 'a') + "\r\nOK\r\n"), Lines{std::string(100, 'a')});
}

TEST_F(MoteusDiagnostic, WithoutFlowControlALostReplyFailsTheCommand)
{
    oldFirmware = true;
    EXPECT_TRUE(run("conf get id.id", "1\r\n"));
    const int before = frames;
    isLost = [before](int frame) { return frame == before + 4; };
    const auto answer = run("conf list", std::string(100, 'a') + "\r\nOK\r\n");
    ASSERT_FALSE(answer);
    EXPECT_EQ(answer.error(),
              (Error{ErrorCode::NoAnswer, QStringLiteral("Part of the answer was lost. Repeat the command.")}));
}

TEST_F(MoteusDiagnostic, ASilentDriveIsGivenUp)
{
    isLost = [](int) { return true; };
    const auto answer = run("conf get id.id", "1\r\n");
    ASSERT_FALSE(answer);
    EXPECT_EQ(answer.error(), (Error{ErrorCode::NoAnswer, QStringLiteral("Drive 1 does not answer on its console.")}));
    EXPECT_EQ(frames, 5);
}

TEST_F(MoteusDiagnostic, AnAnswerThatNeverComesIsGivenUp)
{
    const auto answer = run("conf get id.id", "");
    ASSERT_FALSE(answer);
    EXPECT_EQ(answer.error(),
              (Error{ErrorCode::NoAnswer, QStringLiteral("The console of the drive did not answer the command.")}));
    EXPECT_EQ(run("conf get id.id", "1\r\n"), Lines{"1"});
}

TEST_F(MoteusDiagnostic, RepliesToTheMotionCommandsAreLeftAlone)
{
    ASSERT_TRUE(client.start("conf get id.id"));
    ASSERT_TRUE(client.nextFrame());
    client.handleReply({.source = 1, .destination = kHostId, .values = {{Register::Mode, Resolution::Int8, 10}}});
    client.handleReply({.source = 2, .destination = kDiagnosticHostId, .texts = {{1, 5, "x"}}});
    EXPECT_FALSE(client.nextFrame());  // still waiting
}

TEST_F(MoteusDiagnostic, RefusesWhatItCannotDo)
{
    const auto code = [this](const std::string& command) {
        const auto started = client.start(command);
        return started ? std::nullopt : std::optional(started.error().code);
    };
    EXPECT_EQ(code(""), ErrorCode::OutOfRange);
    EXPECT_EQ(code(std::string(101, 'a')), ErrorCode::OutOfRange);
    EXPECT_EQ(code("conf get a\nd pos 1 0 1"), ErrorCode::InvalidInput);
    EXPECT_EQ(code("conf schema servo"), ErrorCode::NotAvailable);
    EXPECT_EQ(code("conf list"), std::nullopt);
    EXPECT_EQ(code("conf list"), ErrorCode::Busy);
    EXPECT_FALSE(client.takeAnswer());
}

}  // namespace
}  // namespace boresight::moteus
