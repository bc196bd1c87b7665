// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/profile/profile_diff.h"
#include "core/profile/profile_file.h"
#include "core/profile/setting.h"
#include "core/profile/unreliable_arcs.h"
#include "tests/fakes/text_of.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace boresight::profile {
namespace {

std::vector<std::string> keysOf(const Profile& profile)
{
    std::vector<std::string> keys;
    for (const Problem& problem : problemsOf(profile)) {
        keys.push_back(problem.key);
    }
    return keys;
}

// REQ-PROFILE-18 (SensorSettings.*): An orientation sensor is described completely or not used. Settings of the sensor
// that contradict each other are reported.
TEST(SensorSettings, WithoutThemThereIsNoSensor)
{
    EXPECT_EQ(Profile().sensor.source, SensorSource::None);
    EXPECT_TRUE(problemsOf(Profile()).empty());
}

TEST(SensorSettings, SurviveTheRoundTrip)
{
    Profile profile;
    profile.site.known = true;
    profile.sensor = {.source = SensorSource::Serial,
                      .port = "/dev/serial/by-id/usb-1a86_USB2.0-Serial-if00-port0",
                      .baud = 74880,
                      .orientationTopic = "mast/orientation",
                      .statusTopic = "mast/status",
                      .calibrationTopic = "mast/calibration",
                      .mounting = {.sense = orientation::Sense::CounterClockwise,
                                   .azimuthOffset = -123.456_deg,
                                   .elevationOffset = 1.25_deg},
                      .deviation = {.a1 = 8_deg,
                                    .b1 = -1.5_deg,
                                    .a2 = 0.25_deg,
                                    .b2 = 3_deg,
                                    .sigma = 1.6_deg,
                                    .elevation = 30_deg,
                                    .unreliable = {{40_deg, 80_deg}, {350.5_deg, 20_deg}}},
                      .declinationBy = geomagnetism::DeclinationBy::Boresight,
                      .declinationInSensor = 4.98_deg,
                      .declination = -1.5_deg,
                      .declinationFile = "/usr/share/wmm/WMM.COF",
                      .lost = Seconds(7.5),
                      .latency = Seconds(0.25),
                      .averaging = Seconds(0.0),
                      .disagreement = 4.5_deg,
                      .disagreementTime = Seconds(3.0),
                      .stillCurrent = 0.4,
                      .swingCurrent = 7.5};
    const auto again = parseProfile(toToml(profile), QStringLiteral("m.toml"));
    ASSERT_TRUE(again) << textOf(again.error());
    EXPECT_EQ(*again, profile);
}

TEST(SensorSettings, MakeSenseTogether)
{
    Profile profile;
    profile.sensor.source = SensorSource::Serial;
    EXPECT_EQ(keysOf(profile), std::vector<std::string>{"sensor.port"});
    profile.sensor.source = SensorSource::Simulated;
    EXPECT_TRUE(keysOf(profile).empty());
    EXPECT_EQ(problemsOfReal(profile).front().key, "sensor.source");
    profile.sensor.source = SensorSource::None;
    EXPECT_TRUE(problemsOfReal(profile).empty());

    Profile twice;
    twice.sensor.statusTopic = twice.sensor.calibrationTopic;
    EXPECT_EQ(keysOf(twice), std::vector<std::string>{"sensor.status_topic"});
    twice.sensor.orientationTopic = twice.sensor.calibrationTopic;
    EXPECT_EQ(keysOf(twice), (std::vector<std::string>{"sensor.orientation_topic", "sensor.status_topic"}));

    Profile nowhere;
    nowhere.sensor.declinationFile = "WMM.COF";
    EXPECT_TRUE(keysOf(nowhere).empty());
    nowhere.sensor.declinationBy = geomagnetism::DeclinationBy::Boresight;
    EXPECT_EQ(keysOf(nowhere), std::vector<std::string>{"sensor.declination_file"});
    nowhere.site.known = true;
    EXPECT_TRUE(keysOf(nowhere).empty());
}

TEST(SensorSettings, ATopicNamesOne)
{
    for (const char* const bad : {"", "antenna/#", "+/orientation", "a\nb"}) {
        Profile profile;
        profile.sensor.orientationTopic = bad;
        EXPECT_EQ(keysOf(profile), std::vector<std::string>{"sensor.orientation_topic"}) << bad;
    }
}

TEST(SensorSettings, UnreliableHeadingsAreArcs)
{
    for (const char* const bad : {"40", "40-", "-40-80", "40-80-90", "40-361", "40-80,", "forty-80", "nan-3"}) {
        EXPECT_FALSE(parseArcs(bad)) << bad;
    }
    EXPECT_EQ(*parseArcs(""), std::vector<UnreliableArc>{});
    EXPECT_EQ(*parseArcs(" 350 - 20.5,90-100 "), (std::vector<UnreliableArc>{{350_deg, 20.5_deg}, {90_deg, 100_deg}}));
    EXPECT_EQ(toText({{350_deg, 20.5_deg}, {90_deg, 100_deg}}), "350.0-20.5, 90.0-100.0");
}

TEST(SensorSettings, ApplyAtOnce)
{
    Profile wanted;
    wanted.sensor.source = SensorSource::Serial;
    wanted.sensor.port = "/dev/ttyUSB0";
    wanted.sensor.mounting.azimuthOffset = 37.4_deg;
    const Application application = applied(Profile(), wanted);
    EXPECT_EQ(application.inForce, wanted);
    EXPECT_TRUE(application.waitingKeys.empty());
}

}  // namespace
}  // namespace boresight::profile
