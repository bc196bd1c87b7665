// SPDX-License-Identifier: GPL-3.0-or-later
// Commands by MQTT and the control of the mount.
#include "core/clients/station_rotator.h"
#include "core/mqtt_commands/command_talk.h"
#include "tests/core/control/station_rig.h"

#include <QJsonDocument>
#include <QJsonObject>

#include <gmock/gmock.h>

#include <memory>
#include <string>

namespace boresight {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

struct CommandRig : StationRig
{
    CommandRig()
    {
        run(Seconds(0.2));
        connect(7);
        onTick = [this] { talk->tick(); };
        run(Seconds(2.5));
    }
    void connect(std::uint64_t id)
    {
        talk = std::make_unique<mqtt::CommandTalk>(
            rotctld::Client{
                .id = id, .address = "topic boresight/command", .protocol = "MQTT", .keepsControlByReading = false},
            rotator, clock, [] { return std::optional<Site>(); },
            [this](const rotctld::Client& client) { return control.request(request::Stop{}, clientSource(client)); });
        rotator.clientConnected(talk->client());
    }
    std::string say(const QByteArray& message)
    {
        const auto answer = talk->obey(message, mqtt::Retain::No);
        return answer ? QJsonDocument::fromJson(*answer).object()[QStringLiteral("answer")].toString().toStdString()
                      : std::string();
    }
    Result<QString> otherPoints(double azimuth)
    {
        return rotator.pointTo(other, {.azimuth = Angle::fromDegrees(azimuth), .elevation = 20_deg});
    }

    StationRotator rotator{control, inForce, log, clock};
    std::unique_ptr<mqtt::CommandTalk> talk;
    const rotctld::Client other{.id = 3, .address = "127.0.0.1:50000"};
};

// REQ-MQTTCOMMANDS-08 (CommandControl.*): All senders of commands by MQTT together are one client of the mount. For
// this client the rule for clients, the operator, STOP, faults and re-arm apply as for a rotctld client.
TEST(CommandControl, IsOneClient)
{
    CommandRig rig;
    rig.rotator.clientConnected(rig.other);
    EXPECT_EQ(rig.say("40 30"), "OK");
    EXPECT_EQ(rig.control.status().commander.name, QStringLiteral("client MQTT topic boresight/command"));
    EXPECT_FALSE(rig.otherPoints(90.0)) << "another client has control";
    rig.settle();
    EXPECT_NEAR(rig.azimuthDegrees(), 40.0, 0.1);
    EXPECT_EQ(rig.say("45 30"), "OK");
    EXPECT_EQ(rig.say("50 30"), "OK");
    rig.settle();
    EXPECT_NEAR(rig.azimuthDegrees(), 50.0, 0.1);
}

// REQ-MQTTCOMMANDS-09: If the sender sends no motion any more or the broker is lost, the sender keeps control for at
// most 10 s. Its last target stays.
TEST(CommandControl, EndsWithItsSilence)
{
    CommandRig rig;
    rig.rotator.clientConnected(rig.other);
    ASSERT_EQ(rig.say("40 30"), "OK");
    rig.run(Seconds(9.5));
    EXPECT_FALSE(rig.otherPoints(90.0));
    rig.run(Seconds(1.0));
    EXPECT_TRUE(rig.otherPoints(90.0)) << "10 s";
    EXPECT_THAT(rig.say("50 30"), HasSubstr("has control. It sent its last command"));
    rig.rotator.clientGone(rig.other, QStringLiteral("closed"));
    rig.run(Seconds(10.5));
    ASSERT_EQ(rig.say("60 30"), "OK");
    ASSERT_EQ(rig.say("61 30"), "OK");
    rig.rotator.clientGone(rig.talk->client(), QStringLiteral("the broker is lost"));
    rig.settle();
    EXPECT_NEAR(rig.azimuthDegrees(), 61.0, 0.1);
    EXPECT_TRUE(rig.otherPoints(90.0)) << "at once";
}

// Story: a dashboard that asked for the position each 5 s kept control for ever after one motion.
// REQ-MQTTCOMMANDS-14: A question by MQTT does not keep control of the mount.
TEST(CommandControl, IsNotKeptByAQuestion)
{
    CommandRig rig;
    rig.rotator.clientConnected(rig.other);
    for (int i = 0; i < 5; ++i) {  // a stream of points, which other clients confirm by reading
        ASSERT_EQ(rig.say("40." + QByteArray::number(i) + " 30"), "OK");
        rig.run(Seconds(1.0));
    }
    for (int i = 0; i < 4; ++i) {
        EXPECT_FALSE(rig.otherPoints(90.0)) << i;
        rig.run(Seconds(2.2));
        EXPECT_THAT(rig.say("?"), Not(StartsWith("error: ")));
    }
    rig.run(Seconds(0.5));
    EXPECT_TRUE(rig.otherPoints(90.0)) << "10.3 s after the last motion";
}

TEST(CommandControl, YieldsToTheOperator)
{
    CommandRig rig;
    ASSERT_EQ(rig.say("200 30"), "OK");
    rig.run(Seconds(1.0));
    ASSERT_TRUE(rig.ask(request::Hold{}));
    rig.settle();
    const double stood = rig.azimuthDegrees();
    for (const char* const motion : {"200 30", "park"}) {
        EXPECT_EQ(rig.say(motion), "error: The operator has control. Press Hand over first.") << motion;
    }
    rig.run(Seconds(2.0));
    EXPECT_NEAR(rig.azimuthDegrees(), stood, 0.01);
    EXPECT_THAT(rig.say("?"), Not(StartsWith("error: ")));
    ASSERT_TRUE(rig.ask(request::GiveAuthority{}));
    rig.run(Seconds(2.0));
    EXPECT_NEAR(rig.azimuthDegrees(), stood, 0.01) << "nothing moves by itself";
    EXPECT_EQ(rig.say("200 30"), "OK");
}

// A stop works whoever has control.
TEST(CommandControl, StopsWhatOthersMove)
{
    CommandRig rig;
    ASSERT_TRUE(rig.ask(request::PointSky{{.azimuth = 200_deg, .elevation = 30_deg}}));
    rig.run(Seconds(1.0));
    EXPECT_EQ(rig.say("hold"), "OK");
    rig.settle();
    EXPECT_LT(rig.azimuthDegrees(), 100.0);
    EXPECT_FALSE(rig.control.status().stopLatched);

    ASSERT_TRUE(rig.ask(request::PointSky{{.azimuth = 200_deg, .elevation = 30_deg}}));
    rig.run(Seconds(0.2));
    EXPECT_EQ(rig.say("stop"), "OK");
    rig.settle();
    EXPECT_TRUE(rig.control.status().stopLatched);
    EXPECT_LT(rig.azimuthDegrees(), 150.0);
    const double stood = rig.azimuthDegrees();
    EXPECT_THAT(rig.say("40 30"), StartsWith("error: "));
    EXPECT_FALSE(rig.otherPoints(90.0)) << "for all";
    ASSERT_TRUE(rig.ask(request::ResetStop{}));
    EXPECT_THAT(rig.say("40 30"), StartsWith("error: ")) << "the operator hands over first";
    rig.run(Seconds(2.0));
    EXPECT_NEAR(rig.azimuthDegrees(), stood, 0.01);
    ASSERT_TRUE(rig.ask(request::GiveAuthority{}));
    EXPECT_EQ(rig.say("40 30"), "OK");
}

TEST(CommandControl, MovesNothingBetweenAFaultAndARearm)
{
    CommandRig rig;
    ASSERT_EQ(rig.say("200 30"), "OK");
    rig.run(Seconds(1.0));
    rig.azimuth.silent = true;
    rig.run(Seconds(1.0));
    rig.azimuth.silent = false;
    rig.run(Seconds(2.0));
    ASSERT_TRUE(rig.control.faultLatched());
    const double stood = rig.azimuthDegrees();
    for (const char* const motion : {"200 30", "park"}) {
        EXPECT_THAT(rig.say(motion), StartsWith("error: ")) << motion;
    }
    EXPECT_EQ(rig.say("stop"), "OK") << "STOP is always obeyed";
    ASSERT_TRUE(rig.control.status().stopLatched);
    rig.run(Seconds(2.0));
    EXPECT_NEAR(rig.azimuthDegrees(), stood, 0.01);
}

TEST(CommandControl, RefusesABearingWithoutASite)
{
    CommandRig rig;
    EXPECT_THAT(rig.say("40 30"), "OK");
    rig.settle();
    EXPECT_THAT(rig.say("bearing JN58"), HasSubstr("The site of the mount is unknown."));
    rig.run(Seconds(1.0));
    EXPECT_NEAR(rig.elevationDegrees(), 30.0, 0.1);
}

}  // namespace
}  // namespace boresight
