// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mqtt/state_publisher.h"

#include <gtest/gtest.h>

namespace boresight::mqtt {
namespace {

// 2026-11-21T18:17:30.250Z
const UtcTime kWhen{std::chrono::milliseconds{1795285050250}};

// REQ-MQTT-08 (MqttStateMessage.*)
TEST(MqttStateMessage, IsOneLineInTheSensorsStyle)
{
    const PublishedState state{.utc = kWhen,
                               .state = QStringLiteral("TRACK"),
                               .limited = true,
                               .simulated = true,
                               .actual = SkyPointing{12.345678_deg, 33.3_deg},
                               .commanded = SkyPointing{12.35_deg, 33.25_deg},
                               .target = SkyPointing{13.0_deg, 34.0_deg},
                               .azimuthAxis = 372.345678_deg,
                               .elevationAxis = 33.3_deg,
                               .targetText = QStringLiteral("P 13.00 34.00"),
                               .commander = QStringLiteral("rotctld 127.0.0.1:51234"),
                               .isLinked = true,
                               .brake = PublishedBrake{.state = QStringLiteral("open"), .problem = QString()},
                               .endSwitches = {{.end = QStringLiteral("azimuth upper"),
                                                .state = QStringLiteral("unread"),
                                                .problem = QStringLiteral("no message for 5 s")}},
                               .alarms = {{.id = QStringLiteral("sun.near"),
                                           .about = QString(),
                                           .severity = QStringLiteral("warning"),
                                           .text = QStringLiteral("The beam is near the Sun.")}}};
    EXPECT_EQ(
        toJson(state).toStdString(),
        R"({"alarms":[{"about":"","id":"sun.near","severity":"warning","text":"The beam is near the Sun."}],)"
        R"("axes":{"azimuth":372.3457,"elevation":33.3},"azimuth":12.3457,"brake":{"problem":"","state":"open"},)"
        R"("commanded":{"azimuth":12.35,"elevation":33.25},"commander":"rotctld 127.0.0.1:51234",)"
        R"("dateTime":"2026-11-21T18:17:30Z","elevation":33.3,"endSwitches":[{"end":"azimuth upper","problem":"no message for 5 s","state":"unread"}],"fault":"","limited":true,)"
        R"("link":{"problem":"","up":true},"simulated":true,)"
        R"("state":"TRACK","stopLatched":false,"target":{"azimuth":13,"elevation":34},)"
        R"("targetText":"P 13.00 34.00","ts":"1795285050250",)"
        R"("units":{"orientation":"decimal degrees","ts":"milliseconds"}})");
}

TEST(MqttStateMessage, SaysNullForWhatIsNotKnown)
{
    const PublishedState state{.utc = kWhen,
                               .state = QStringLiteral("FAULT"),
                               .fault = QStringLiteral("azimuth: \"38\""),
                               .stopLatched = true,
                               .linkProblem = QStringLiteral("no answer")};
    EXPECT_EQ(
        toJson(state).toStdString(),
        R"({"alarms":[],"axes":{"azimuth":null,"elevation":null},"azimuth":null,"brake":null,"commanded":null,)"
        R"("commander":"","dateTime":"2026-11-21T18:17:30Z","elevation":null,"endSwitches":[],"fault":"azimuth: \"38\"","limited":false,)"
        R"("link":{"problem":"no answer","up":false},"simulated":false,"state":"FAULT","stopLatched":true,"target":null,"targetText":"",)"
        R"("ts":"1795285050250","units":{"orientation":"decimal degrees","ts":"milliseconds"}})");
}

}  // namespace
}  // namespace boresight::mqtt
