// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/north/live_sensor.h"

#include "tests/fakes/manual_clock.h"
#include "tests/fakes/text_of.h"

#include <gtest/gtest.h>

namespace boresight {
namespace {

struct LiveSensorRig
{
    LiveSensorRig() { choose(profile::SensorSource::Simulated); }

    void choose(profile::SensorSource source)
    {
        profile::Profile wanted = *profile;
        wanted.sensor.source = source;
        profile.apply(wanted);
    }

    // Sets the present report of the sensor. Returns whether it counts as a new value.
    bool report(std::optional<int> magnetometer = 3, int system = 3)
    {
        status.last = orientation::Orientation{};
        status.last->arrival = clock.now();
        if (magnetometer) {
            status.last->calibration = orientation::Calibration{.system = system, .magnetometer = *magnetometer};
        }
        return sensor.take(status) != nullptr;
    }

    profile::InForce profile{profile::Profile()};
    fakes::ManualClock clock;
    SensorStatus status;
    LiveSensor sensor{profile, clock};
};

std::string refusalOf(const Result<>& result)
{
    return result ? std::string() : textOf(result.error());
}

TEST(LiveSensor, ASensorCountsOnceItWasHeard)
{
    LiveSensorRig rig;
    EXPECT_EQ("The orientation sensor has sent nothing yet.", refusalOf(rig.sensor.isHeard()));
    rig.status.problem = QStringLiteral("no port");
    EXPECT_EQ(nullptr, rig.sensor.take(rig.status));
    EXPECT_EQ("The orientation sensor has sent nothing yet. (no port)", refusalOf(rig.sensor.isHeard()));
    rig.status.problem.clear();
    EXPECT_TRUE(rig.report());
    EXPECT_TRUE(rig.sensor.isHeard());
    EXPECT_TRUE(rig.sensor.isUsable());
}

TEST(LiveSensor, TheSameValueIsNewOnlyOnce)
{
    LiveSensorRig rig;
    EXPECT_TRUE(rig.report());
    EXPECT_EQ(nullptr, rig.sensor.take(rig.status));
    rig.clock.advance(Seconds(1.0));
    EXPECT_TRUE(rig.report());
}

TEST(LiveSensor, ASilentSensorIsNoEvidence)
{
    LiveSensorRig rig;
    EXPECT_TRUE(rig.report());
    rig.clock.advance(rig.profile->sensor.lost);
    EXPECT_TRUE(rig.sensor.isHeard());
    rig.clock.advance(Seconds(0.1));
    EXPECT_FALSE(rig.sensor.isHeard());
    EXPECT_FALSE(rig.sensor.isUsable());
}

// Story: an average of 20 s was refused at its end, because of a level that was reported before it began.
// REQ-NORTH-960: An average does not start if its readings would be refused at the end. The system level of the sensor
// is checked first, too. A sensor that reports no level is averaged.
TEST(LiveSensor, AHeadingThatIsNotTiedToNorthIsNotAveraged)
{
    LiveSensorRig rig;
    EXPECT_TRUE(rig.report(3, 1));
    EXPECT_TRUE(rig.sensor.isUsable());
    EXPECT_EQ(
        "System calibration of the sensor is 1 of 3, but 2 is needed. Its heading is not referred to magnetic north "
        "yet.",
        refusalOf(rig.sensor.isTiedToNorth()));
    rig.clock.advance(Seconds(0.1));
    EXPECT_TRUE(rig.report(3, 2));
    EXPECT_TRUE(rig.sensor.isTiedToNorth());
    rig.clock.advance(Seconds(0.1));
    EXPECT_TRUE(rig.report(std::nullopt));
    EXPECT_TRUE(rig.sensor.isTiedToNorth());
}

TEST(LiveSensor, ACompassThatIsNotCalibratedIsHeardButNotUsable)
{
    LiveSensorRig rig;
    EXPECT_TRUE(rig.report(1));
    EXPECT_TRUE(rig.sensor.isHeard());
    EXPECT_FALSE(rig.sensor.isUsable());
    rig.clock.advance(Seconds(1.0));
    EXPECT_TRUE(rig.report(2));
    EXPECT_TRUE(rig.sensor.isUsable());
    rig.clock.advance(Seconds(1.0));
    EXPECT_TRUE(rig.report(std::nullopt));
    EXPECT_TRUE(rig.sensor.isUsable()) << "by MQTT it does not report that";
}

TEST(LiveSensor, AProfileWithoutASensorHasNoEvidence)
{
    LiveSensorRig rig;
    EXPECT_TRUE(rig.report());
    rig.choose(profile::SensorSource::None);
    EXPECT_EQ("The profile has no orientation sensor.", refusalOf(rig.sensor.isUsable()));
}

}  // namespace
}  // namespace boresight
