// SPDX-License-Identifier: GPL-3.0-or-later
// Sensor and axes differ: when this is an alarm, what explains it, and how it is reported.
#include "tests/core/cross_check/sensor_watch_rig.h"

#include <utility>

namespace boresight {
namespace {

using testing::HasSubstr;

// REQ-WITNESS-40 (SensorWatch.*)
TEST(SensorWatch, APersistentDifferenceIsAmberWithItsLikelyCauses)
{
    SensorWatchRig rig;
    rig.run(5.0);
    rig.heading = 130_deg;
    rig.run(3.0);
    EXPECT_THAT(rig.alarmText(), HasSubstr("differ by 30.0° in azimuth"));
    EXPECT_THAT(rig.alarmText(), HasSubstr("Pointing is unchanged"));
    EXPECT_THAT(rig.alarmText(), HasSubstr("iron or a motor current near the compass"));
    EXPECT_TRUE(rig.watch.status().disagrees);
    rig.heading = 100_deg;
    rig.run(6.0);
    EXPECT_EQ(rig.alarmText(), "");
    rig.elevation = 45_deg;
    rig.run(3.0);
    EXPECT_THAT(rig.alarmText(), HasSubstr("differ by 25.0° in elevation"));
}

// Story: 3 s after a swing an amber alarm blamed a coupling, while the curve that explained the difference waited for
// Apply.
// REQ-WITNESS-40a: A result of a swing or an average that waits for Apply can explain a difference, too. The sensor is
// also compared with this result, and only a difference from both is amber. A new proposal is judged after some
// seconds, during which an alarm may disappear and come again. After that no difference above the threshold is hidden,
// however long the proposal waits.
TEST(SensorWatch, WhatAProposalExplainsIsNoAlarm)
{
    SensorWatchRig rig;
    rig.run(5.0);
    rig.heading = 130_deg;
    rig.watch.setProposed(calibration::SensorMounting{.azimuthOffset = -25_deg});
    rig.proposedAxes = SkyPointing{.azimuth = 105_deg, .elevation = 20_deg};  // north changes, too
    rig.run(10.0);
    EXPECT_EQ(rig.alarmText(), "");
    EXPECT_FALSE(rig.watch.status().disagrees);
    EXPECT_NEAR(rig.watch.status().azimuthDifference->degrees(), 30.0, 1e-9) << "of what is in force";
    rig.watch.setProposed(std::nullopt);
    rig.proposedAxes.reset();
    rig.run(0.1);
    EXPECT_THAT(rig.alarmText(), HasSubstr("differ by 30.0° in azimuth")) << "it was dropped";
}

// REQ-WITNESS-40a
TEST(SensorWatch, WhatAProposalDoesNotExplainIsAnAlarm)
{
    SensorWatchRig rig;
    rig.run(5.0);
    rig.heading = 130_deg;
    rig.watch.setProposed(calibration::SensorMounting{.azimuthOffset = -30_deg});
    rig.proposedAxes = kStandingAt;
    rig.run(5.0);
    ASSERT_EQ(rig.alarmText(), "");
    rig.heading = 145_deg;  // from here on a coupling slips
    rig.run(3.0);
    EXPECT_THAT(rig.alarmText(), HasSubstr("differ by 45.0° in azimuth"));
    rig.heading = 130_deg;
    rig.run(6.0);
    EXPECT_EQ(rig.alarmText(), "");
    rig.elevation = 45_deg;  // the proposal does not explain this
    rig.run(3.0);
    EXPECT_THAT(rig.alarmText(), HasSubstr("differ by 25.0° in elevation"));
}

// A newer proposal does not explain an older difference.
// REQ-WITNESS-40a
TEST(SensorWatch, AProposalTakesAnAlarmAwayOnlyIfItExplainsIt)
{
    SensorWatchRig rig;
    rig.run(5.0);
    rig.heading = 130_deg;
    rig.run(3.0);
    ASSERT_TRUE(rig.watch.status().disagrees);
    rig.proposedAxes = kStandingAt;
    rig.watch.setProposed(calibration::SensorMounting{.azimuthOffset = 5_deg});
    for (int i = 0; i < 60; ++i) {  // Story: the alarm disappeared, and came again some seconds later
        rig.run(0.1);
        EXPECT_TRUE(rig.watch.status().disagrees) << i;
    }
    EXPECT_EQ(rig.alarms.list().size(), 1U) << "one, told once";
    rig.watch.setProposed(calibration::SensorMounting{.azimuthOffset = -32_deg});
    rig.run(6.0);
    EXPECT_FALSE(rig.watch.status().disagrees);
}

// Story: a new user saw an amber "differ by 37°" at once, although nothing was wrong.
TEST(SensorWatch, BeforeNorthIsFoundADifferenceInAzimuthOnlyShowsTheWay)
{
    SensorWatchRig rig;
    rig.heading = 137.4_deg;
    rig.run(5.0);
    const std::vector<Alarm> shown = rig.alarms.list();
    ASSERT_EQ(shown.size(), 1U);
    EXPECT_EQ(shown[0].severity, Severity::Advisory);
    EXPECT_THAT(shown[0].what.toStdString(), HasSubstr("North is not set"));
    EXPECT_THAT(shown[0].what.toStdString(), HasSubstr("37.4° in azimuth"));
    EXPECT_THAT(shown[0].remedy.toStdString(), HasSubstr("page North"));
    EXPECT_THAT(shown[0].remedy.toStdString(), HasSubstr("check the mounting of the sensor and the coupling"))
        << "the axis' zero may be north";
    EXPECT_FALSE(rig.watch.status().disagrees);

    rig.elevation = 45_deg;  // the elevation does not depend on north
    rig.run(3.0);
    EXPECT_TRUE(rig.watch.status().disagrees);
    EXPECT_THAT(rig.logText(), HasSubstr("differ by 25.0° in elevation"));
    rig.elevation = 20_deg;
    rig.run(6.0);
    EXPECT_FALSE(rig.watch.status().disagrees);

    profile::Profile found = rig.profile;
    found.pointing.azimuthOffset = 30_deg;
    rig.setProfile(found);
    rig.run(3.0);
    EXPECT_TRUE(rig.watch.status().disagrees) << "whatever was found, the sensor says something else";
    EXPECT_THAT(rig.alarmText(), HasSubstr("differ by 37.4° in azimuth"));
}

// Story: an operator set sensor.elevation_offset_deg, as the elevation alarm advises, and then got an amber alarm about
// the azimuth.
TEST(SensorWatch, WhatTellsNothingOfNorthFindsNone)
{
    const auto disagreesWith = [](const auto& set) {
        SensorWatchRig rig;
        set(rig.profile);
        rig.setProfile(rig.profile);
        rig.heading = 137.4_deg;
        rig.run(5.0);
        return rig.watch.status().disagrees;
    };
    EXPECT_FALSE(disagreesWith([](auto& profile) { profile.sensor.mounting.elevationOffset = 0.5_deg; }));
    EXPECT_FALSE(
        disagreesWith([](auto& profile) { profile.sensor.mounting.sense = orientation::Sense::CounterClockwise; }));
    EXPECT_FALSE(disagreesWith([](auto& profile) { profile.pointing.elevationOffset = 0.5_deg; }));
    EXPECT_FALSE(disagreesWith([](auto& profile) { profile.pointing.tiltNorth = 0.5_deg; }));
    EXPECT_FALSE(disagreesWith([](auto& profile) { profile.pointing.elevationSag = 0.1_deg; }));
    EXPECT_TRUE(disagreesWith([](auto& profile) { profile.pointing.azimuthOffset = 5_deg; }));
    EXPECT_TRUE(disagreesWith([](auto& profile) { profile.sensor.mounting.azimuthOffset = 5_deg; }));
    EXPECT_TRUE(disagreesWith([](auto& profile) { profile.sensor.deviation.a1 = 1_deg; })) << "a swing";
}

TEST(SensorWatch, ASensorThatAgreedOnceIsBelievedWithoutANorthInTheProfile)
{
    SensorWatchRig rig;
    rig.run(3.0);
    rig.heading = 137.4_deg;
    rig.run(3.0);
    EXPECT_THAT(rig.alarmText(), HasSubstr("differ by 37.4° in azimuth"));
    rig.watch.begin(QStringLiteral("another"));
    rig.run(4.0);
    EXPECT_FALSE(rig.watch.status().disagrees) << "of this one nothing is known yet";
}

// Story: a change of any setting removed the alarm, and 1.5 s later it came again, unacknowledged.
TEST(SensorWatch, ASettingOfSomethingElseLeavesTheAlarm)
{
    SensorWatchRig rig;
    rig.run(5.0);
    rig.heading = 130_deg;
    rig.run(3.0);
    ASSERT_TRUE(rig.watch.status().disagrees);
    profile::Profile other = rig.profile;
    other.rotctld.maxClients = 3;
    rig.setProfile(other);
    rig.run(0.1);
    EXPECT_TRUE(rig.watch.status().disagrees);
    other.sensor.swingCurrent = 7.0;  // none of these changes the meaning of a reading
    other.sensor.stillCurrent = 2.0;
    other.sensor.lost = Seconds(8.0);
    other.sensor.disagreement = 12_deg;
    other.azimuth.limits.speed = 5_deg_s;
    rig.setProfile(other);
    rig.run(0.1);
    EXPECT_TRUE(rig.watch.status().disagrees);
    other.sensor.disagreement = 90_deg;  // these settings count from now on
    rig.setProfile(other);
    rig.run(6.0);
    EXPECT_FALSE(rig.watch.status().disagrees);
    other.sensor.disagreement = 12_deg;
    rig.setProfile(other);
    rig.run(3.0);
    EXPECT_TRUE(rig.watch.status().disagrees);
    other.pointing.azimuthOffset = 30_deg;  // from now on the axes mean another direction
    rig.setProfile(other);
    rig.run(0.1);
    EXPECT_FALSE(rig.watch.status().disagrees);
}

TEST(SensorWatch, ANewSettingTakesADifferenceAway)
{
    SensorWatchRig rig(withNorth());
    rig.heading = 62.6_deg;
    rig.run(5.0);
    EXPECT_NE(rig.alarmText(), "");
    rig.profile.sensor.mounting.azimuthOffset = 37.4_deg;
    rig.setProfile(rig.profile);
    rig.run(2.0);
    EXPECT_EQ(rig.alarmText(), "");
    EXPECT_NEAR(rig.watch.status().direction->azimuth.degrees(), 100.0, 1e-9);
}

}  // namespace
}  // namespace boresight
