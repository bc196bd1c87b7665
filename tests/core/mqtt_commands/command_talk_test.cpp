// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mqtt_commands/command_talk.h"

#include "tests/fakes/dummy_rotator.h"
#include "tests/fakes/manual_clock.h"

#include <QJsonDocument>
#include <QJsonObject>

#include <gmock/gmock.h>

#include <chrono>
#include <string>

namespace boresight::mqtt {
namespace {

using namespace std::chrono_literals;
using testing::HasSubstr;

constexpr Site kLisbon{.latitude = Angle::fromDegrees(38.72), .longitude = Angle::fromDegrees(-9.14)};

struct CommandTalkTest : ::testing::Test
{
    void connect(bool readsOnly = false)
    {
        talk = std::make_unique<CommandTalk>(
            rotctld::Client{.id = 7, .address = "topic boresight/command", .protocol = "MQTT", .readsOnly = readsOnly},
            rotator, clock, [] { return std::optional(kLisbon); },
            [this](const rotctld::Client& client) {
                ++stops;
                EXPECT_EQ(client.id, 7U);
                return Result<>{};
            });
    }
    void SetUp() override
    {
        connect();
        wait(10s);
    }
    // The station runs.
    void wait(std::chrono::milliseconds time)
    {
        for (; time > 0ms; time -= 100ms) {
            clock.advance(100ms);
            talk->tick();
        }
    }

    static QJsonObject read(const std::optional<QByteArray>& answer)
    {
        return answer ? QJsonDocument::fromJson(*answer).object() : QJsonObject();
    }
    // Sends a message and returns the text of the answer.
    std::string say(const QByteArray& message, Retain retain = Retain::No)
    {
        const QJsonObject answer = read(talk->obey(message, retain));
        const std::string text = answer[QStringLiteral("answer")].toString().toStdString();
        EXPECT_EQ(answer[QStringLiteral("ok")].toBool(), !text.starts_with("error: ") && !text.empty());
        return text;
    }

    fakes::ManualClock clock;
    fakes::DummyRotator rotator{clock};
    int stops = 0;
    std::unique_ptr<CommandTalk> talk;
};

// REQ-MQTTCOMMANDS-01: A message on the topic `command` is one command in the language of `core/pairs_server`. Each
// command is answered by one line of JSON with the command, whether it is accepted, and the answer.
TEST_F(CommandTalkTest, ObeysTheWordsOfThePairs)
{
    EXPECT_EQ(talk->obey("120.5 30", Retain::No), R"({"answer":"OK","command":"120.5 30","ok":true})");
    EXPECT_NEAR(rotator.lastRequest->azimuth.degrees(), 120.5, 1e-9);
    wait(30s);
    EXPECT_EQ(say("  125.5 60 \n"), "OK");
    wait(30s);
    EXPECT_EQ(say("?"), "125.5 60.0");
    for (const char* const message : {"+5 -3", "60"}) {
        EXPECT_THAT(say(message), HasSubstr("a message may arrive twice")) << message;
    }
    EXPECT_NEAR(rotator.lastRequest->azimuth.degrees(), 125.5, 1e-9);
    EXPECT_EQ(say("bearing JN58td"), "OK");
    EXPECT_EQ(say("park"), "OK");
    clock.advance(1s);
    EXPECT_EQ(say("hold"), "OK");
    EXPECT_EQ(stops, 0) << "the motion ends, and STOP is not latched";
    rotator.became = QStringLiteral("90.0° 90.0°, at the elevation limit");
    EXPECT_EQ(say("90 90"), "OK: 90.0° 90.0°, at the elevation limit");
}

// REQ-MQTTCOMMANDS-02: A message that is no command moves nothing, and the answer gives the reason. The same holds for
// a message of several lines, of more than 200 bytes or without text.
TEST_F(CommandTalkTest, RefusesWhatIsNoCommand)
{
    for (const QByteArray& message :
         {QByteArray(), QByteArray("\n"), QByteArray("PRESS"), QByteArray("10 20\n30 40"),
          QByteArray("\xff\xfe\x00", 3), QByteArray("{\"az\": 10}"), QByteArray("10 95 1"), QByteArray("nan 20"),
          QByteArray("1e999 20"), QByteArray("4000 20"), QByteArray("10 181"), QByteArray("bearing XX00"),
          QByteArray(201, '1'), QByteArray(64 * 1024, ' ') + "x" + QByteArray(300, 'y')}) {
        clock.advance(1s);
        EXPECT_THAT(say(message), HasSubstr("error: ")) << message.left(40).toStdString();
        EXPECT_EQ(rotator.actions, 0);
    }
    EXPECT_EQ(talk->obey("10\xe2\x82", Retain::No)->contains("error: "), true) << "half a letter";
    EXPECT_EQ(rotator.actions, 0);
    EXPECT_THAT(say("PRESS"), HasSubstr("The commands are ELEVATION, AZIMUTH ELEVATION"));
    EXPECT_THAT(rotator.remarks.back(), HasSubstr("\"PRESS\" refused: ")) << "the log has it";
    EXPECT_THAT(say(QByteArray(201, '1')), HasSubstr("at most 200 bytes"));
}

// REQ-MQTTCOMMANDS-03: A retained message is never obeyed, not even a STOP. The answer gives the reason.
TEST_F(CommandTalkTest, NeverObeysWhatTheBrokerKept)
{
    for (const char* const message : {"10 20", "park", "hold", "?", "stop", "now stop"}) {
        EXPECT_THAT(say(message, Retain::Yes), HasSubstr("The broker kept this message, so it is old.")) << message;
    }
    EXPECT_THAT(read(talk->stop("", Retain::Yes))[QStringLiteral("answer")].toString().toStdString(),
                HasSubstr("The broker kept this message"));
    EXPECT_EQ(rotator.actions, 0);
    EXPECT_EQ(stops, 0);
}

// REQ-MQTTCOMMANDS-04: For 2 s after the connection to the broker, after a suspend of the computer, and after the
// program was stopped or blocked for 2 s, every motion is refused. Stopping and reading are possible.
TEST_F(CommandTalkTest, MovesNothingRightAfterTheConnection)
{
    connect();
    for (const char* const message : {"10 20", "park", "bearing JN58td"}) {
        EXPECT_THAT(say(message), HasSubstr("less than 2 s ago. This command may be old. Send it again.")) << message;
    }
    EXPECT_EQ(rotator.actions, 0);
    EXPECT_EQ(say("?"), "0.0 0.0");
    EXPECT_EQ(say("hold"), "OK");
    EXPECT_EQ(say("stop"), "OK");
    EXPECT_EQ(stops, 1);
    wait(2s);
    EXPECT_EQ(say("10 20"), "OK");
}

// The connection may have survived the suspend, with a command waiting in the network.
// REQ-MQTTCOMMANDS-04
TEST_F(CommandTalkTest, MovesNothingRightAfterTheComputerSlept)
{
    clock.sleep(30min);
    EXPECT_THAT(say("10 20"), HasSubstr("This command may be old. Send it again."));
    clock.advance(1s);
    EXPECT_THAT(say("10 20"), HasSubstr("This command may be old. Send it again."));
    EXPECT_EQ(rotator.actions, 0);
    clock.advance(1s);
    EXPECT_EQ(say("10 20"), "OK");
}

// Story: the steady clock continues during a sleep. So after a sleep of 1.9 s a command was obeyed almost at once.
// REQ-MQTTCOMMANDS-04
TEST_F(CommandTalkTest, MovesNothingRightAfterAShortSleep)
{
    for (const auto sleep : {200ms, 1900ms}) {
        clock.sleep(sleep);
        talk->tick();
        clock.advance(1900ms);
        EXPECT_THAT(say("10 20"), HasSubstr("This command may be old. Send it again.")) << sleep.count();
        clock.advance(100ms);
        EXPECT_EQ(say("10 20"), "OK") << sleep.count();
    }
}

// Story: a program that was stopped (SIGSTOP) for an hour obeyed the commands that waited in its socket. The message
// may be read before the next tick, or after it.
// REQ-MQTTCOMMANDS-04
TEST_F(CommandTalkTest, MovesNothingRightAfterTheProgramWasStopped)
{
    for (const bool ticksFirst : {false, true}) {
        clock.advance(1h);
        if (ticksFirst) {
            talk->tick();
        }
        EXPECT_THAT(say("10 20"), HasSubstr("This command may be old. Send it again.")) << ticksFirst;
        EXPECT_EQ(say("hold"), "OK");
        EXPECT_EQ(say("stop"), "OK") << "always";
        wait(1900ms);
        EXPECT_THAT(say("10 20"), HasSubstr("This command may be old. Send it again.")) << ticksFirst;
        EXPECT_FALSE(rotator.lastRequest);
        wait(200ms);
    }
    EXPECT_EQ(say("10 20"), "OK");
}

// REQ-MQTTCOMMANDS-05: With `mqtt.commands = "stop"` a sender may read and stop. Every motion is refused.
TEST_F(CommandTalkTest, MayBeForStoppingOnly)
{
    connect(true);
    wait(10s);
    for (const char* const message : {"10 20", "park", "bearing JN58td"}) {
        EXPECT_THAT(say(message), HasSubstr("only stopping and reading by MQTT (mqtt.commands)")) << message;
    }
    EXPECT_EQ(rotator.actions, 0);
    EXPECT_EQ(say("?"), "0.0 0.0");
    EXPECT_EQ(say("hold"), "OK");
    EXPECT_EQ(say("stop"), "OK");
    EXPECT_EQ(stops, 1);
}

// REQ-MQTTCOMMANDS-06: `stop` on the topic `command`, and any message on the topic `stop`, latch STOP. `stop` as the
// last word of a message is enough, whatever precedes it.
TEST_F(CommandTalkTest, LatchesStop)
{
    int expected = 0;
    for (const QByteArray& message : {QByteArray("stop"), QByteArray("STOP\r\n"), QByteArray("120 30 stop"),
                                      QByteArray("120 30\nstop\n"), QByteArray(64 * 1024 - 5, 'x') + " stop"}) {
        EXPECT_EQ(say(message), "OK") << message.left(40).toStdString();
        EXPECT_EQ(stops, ++expected);
    }
    for (const QByteArray& message : {QByteArray(), QByteArray("stop"), QByteArray("PRESS"), QByteArray("\xff", 1)}) {
        EXPECT_EQ(talk->stop(message, Retain::No), R"({"answer":"OK","command":"stop","ok":true})");
        EXPECT_EQ(stops, ++expected);
    }
    EXPECT_EQ(rotator.actions, 0) << "the control stops, not the client";
    EXPECT_THAT(say("nonstop"), HasSubstr("error: "));
    EXPECT_THAT(say("stop now"), HasSubstr("error: "));
    EXPECT_EQ(stops, expected);
}

// REQ-MQTTCOMMANDS-07: If more than 20 commands arrive in a second, the others are ignored. Only the first ignored
// command is answered. STOP and hold are always obeyed, in the order in which they arrive. Nothing displaces them.
TEST_F(CommandTalkTest, BearsAFlood)
{
    int answers = 0;
    std::string last;
    for (int i = 0; i < 1000; ++i) {
        if (const auto answer = talk->obey("10 20", Retain::No)) {
            ++answers;
            last = answer->toStdString();
        }
    }
    EXPECT_EQ(rotator.actions, 20);
    EXPECT_EQ(answers, 21);
    EXPECT_THAT(last, HasSubstr("More than 20 commands arrived in one second."));
    EXPECT_EQ(rotator.remarks.size(), 1U);
    for (int i = 0; i < 100; ++i) {
        EXPECT_FALSE(talk->obey("stop", Retain::No)) << "no answer, but";
    }
    EXPECT_EQ(stops, 100);
    clock.advance(1s);
    EXPECT_EQ(say("30 20"), "OK");
}

// Story: the hold of an operator was ignored, because a script flooded the same topic.
// REQ-MQTTCOMMANDS-07
TEST_F(CommandTalkTest, ObeysAHoldInAFlood)
{
    for (int i = 0; i < 20; ++i) {
        EXPECT_EQ(say("10 20"), "OK");
    }
    EXPECT_EQ(say("hold"), "OK") << "one more than the others may be";
    EXPECT_EQ(rotator.actions, 21);
    for (int i = 0; i < 50; ++i) {
        EXPECT_FALSE(talk->obey("10 20", Retain::No));
        EXPECT_FALSE(talk->obey(" HOLD\n", Retain::No)) << "no answer, but";
    }
    EXPECT_EQ(rotator.actions, 71);
    EXPECT_FALSE(talk->obey("hold", Retain::Yes));
    EXPECT_EQ(rotator.actions, 71) << "an old one";
}

// REQ-MQTTCOMMANDS-07
TEST_F(CommandTalkTest, KnowsWhatIsUrgent)
{
    for (const QByteArray& message :
         {QByteArray("stop"), QByteArray("10 20\nstop"), QByteArray(300, 'x') + " stop", QByteArray("hold stop")}) {
        EXPECT_EQ(CommandTalk::urgencyOf(message), Urgency::Stop) << message.toStdString();
    }
    for (const QByteArray& message : {QByteArray("hold"), QByteArray(" HOLD\r\n"), "hold" + QByteArray(300, ' ')}) {
        EXPECT_EQ(CommandTalk::urgencyOf(message), Urgency::Hold) << message.toStdString();
    }
    for (const QByteArray& message :
         {QByteArray(), QByteArray("10 20"), QByteArray("hold on"), QByteArray("?"), QByteArray("park"),
          QByteArray("nonstop"), QByteArray(300, ' ') + QByteArray("?")}) {
        EXPECT_EQ(CommandTalk::urgencyOf(message), Urgency::None) << message.toStdString();
    }
}

// The facts that the list of clients shows.
TEST_F(CommandTalkTest, KeepsItsHabits)
{
    EXPECT_FALSE(talk->habits().lastMotion());
    (void)say("10 20");
    EXPECT_EQ(talk->habits().lastMotion(), clock.now());
    EXPECT_EQ(talk->habits().lastInWords(), QStringLiteral("10 20"));
    (void)say("PRESS");
    EXPECT_EQ(talk->habits().oddCommands(), 1U);
    EXPECT_THAT(talk->habits().lastInWords().toStdString(), HasSubstr("PRESS: refused. "));
    rotator.fault = Error{.code = ErrorCode::Refused, .text = QStringLiteral("STOP is latched. Reset STOP first.")};
    for (const char* const message : {"10 20", "park", "?"}) {
        EXPECT_EQ(say(message), "error: STOP is latched. Reset STOP first.") << message;
    }
}

}  // namespace
}  // namespace boresight::mqtt
