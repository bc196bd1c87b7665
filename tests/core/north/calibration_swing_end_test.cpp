// SPDX-License-Identifier: GPL-3.0-or-later
// Tests the events that end a swing, that make it wait, and that do not end it.
#include "tests/core/north/calibration_swing.h"

#include <algorithm>

namespace boresight {
namespace {

// REQ-NORTH-35 (CalibrationSwing.*): A calibration moves the mount by the same rules as every motion: within the
// limits, below STOP and faults, with the operator's authority. STOP, Hold, a jog, any other motion or a fault ends it
// at once, with the reason. Before it starts it shows where it will turn and how long it will take.
TEST(CalibrationSwing, StopEndsItAtOnceAndLatches)
{
    CalibrationRig rig;
    swingHalfWay(rig);
    ASSERT_TRUE(rig.ask(request::Stop{}));
    const AxisPosition at = rig.axes();
    rig.run(Seconds(3.0));
    EXPECT_EQ(CalibrationRun::None, rig.status().progress.run);
    EXPECT_TRUE(rig.status().progress.failed);
    EXPECT_FALSE(rig.status().proposal);
    EXPECT_EQ(StationState::Stopped, rig.state());
    EXPECT_TRUE(rig.status().progress.outcome.startsWith(QStringLiteral("STOP ended the run")))
        << rig.status().progress.outcome.toStdString();
    EXPECT_LT(abs(rig.axes().azimuth - at.azimuth), 3_deg);
    ASSERT_TRUE(rig.ask(request::ResetStop{}));
    const AxisPosition rest = rig.axes();
    rig.run(Seconds(5.0));
    EXPECT_EQ(rest, rig.axes());
}

TEST(CalibrationSwing, EndsWithAnyOtherMotion)
{
    for (const Request& other :
         {Request(request::Hold{}), Request(request::Jog{{.azimuth = 1_deg_s, .elevation = {}}}),
          Request(request::Step{.azimuth = 1_deg, .elevation = {}}), Request(request::EndCalibration{})}) {
        CalibrationRig rig;
        swingHalfWay(rig);
        ASSERT_TRUE(rig.ask(other));
        rig.run(Seconds(0.1));
        EXPECT_EQ(CalibrationRun::None, rig.status().progress.run);
        EXPECT_FALSE(rig.status().progress.outcome.isEmpty());
        EXPECT_FALSE(rig.desk.moves());
    }
}

TEST(CalibrationSwing, ADriveInFaultEndsIt)
{
    CalibrationRig rig;
    swingHalfWay(rig);
    rig.azimuth.mode = moteus::Mode::Fault;
    rig.azimuth.fault = 38;
    rig.run(Seconds(1.0));
    EXPECT_EQ(StationState::Fault, rig.state());
    EXPECT_EQ(CalibrationRun::None, rig.status().progress.run);
    EXPECT_TRUE(rig.status().progress.failed);
}

// Story: the screen advised to raise that limit. An operator who did so while the mount turned had to start again.
TEST(CalibrationSwing, GoesOnWhereOnlyALimitIsSet)
{
    CalibrationRig rig;
    swingHalfWay(rig);
    profile::Profile other = rig.profile;
    other.sensor.swingCurrent = 7.0;
    other.sensor.disagreement = 20_deg;
    rig.setProfile(other);
    rig.run(Seconds(1.0));
    EXPECT_EQ(CalibrationRun::Swing, rig.status().progress.run);
    other.sensor.latency = Seconds(0.2);  // the same readings would mean something else
    rig.setProfile(other);
    rig.run(Seconds(0.1));
    EXPECT_EQ(CalibrationRun::None, rig.status().progress.run);
}

// A few lost replies do not cost minutes of turning.
TEST(CalibrationSwing, OutlastsAStallOfThisComputer)
{
    CalibrationRig rig({}, calibratedAtFullRate());
    swingHalfWay(rig);
    rig.azimuth.mute = rig.elevation.mute = true;
    rig.run(Seconds(0.16));
    EXPECT_FALSE(rig.mount.seen());
    rig.azimuth.mute = rig.elevation.mute = false;
    rig.runOut();
    EXPECT_FALSE(rig.status().progress.failed) << rig.status().progress.outcome.toStdString();
    ASSERT_TRUE(rig.apply());
    EXPECT_LT(std::abs(northError(rig)), 2.0);
}

// REQ-NORTH-42
TEST(CalibrationSwing, ASensorThatIsLostEndsItAndHolds)
{
    CalibrationRig rig;
    swingHalfWay(rig);
    rig.speaks = false;
    rig.run(Seconds(34.0));
    EXPECT_EQ(CalibrationRun::Swing, rig.status().progress.run);
    const AxisPosition rest = rig.axes();
    rig.run(Seconds(4.0));
    EXPECT_EQ(CalibrationRun::None, rig.status().progress.run);
    EXPECT_TRUE(rig.status().progress.failed);
    EXPECT_TRUE(rig.status().progress.outcome.contains(QStringLiteral("sensor has sent nothing for 3")))
        << rig.status().progress.outcome.toStdString();
    EXPECT_EQ(StationState::Hold, rig.state());
    rig.speaks = true;
    rig.run(Seconds(5.0));
    EXPECT_EQ(rest, rig.axes()) << "what has ended does not begin by itself";
}

// The compass may have another calibration after its restart: readings before and after it would be of two sensors.
// REQ-NORTH-42
TEST(CalibrationSwing, ASensorThatWasRestartedEndsIt)
{
    CalibrationRig rig;
    swingHalfWay(rig);
    rig.restarts = 1;
    rig.run(Seconds(3.0));
    EXPECT_EQ(CalibrationRun::None, rig.status().progress.run);
    EXPECT_TRUE(rig.status().progress.outcome.contains(QStringLiteral("The sensor restarted")));
    EXPECT_EQ(StationState::Hold, rig.state());
    EXPECT_TRUE(rig.ask(kSweep));
}

// A sensor that does not report its calibration can restart unseen. Its readings before and after a silence may be of
// two compasses.
// REQ-NORTH-42
TEST(CalibrationSwing, ASilenceOfASensorThatTellsNoCalibrationIsADoubt)
{
    for (const bool tells : {true, false}) {
        CalibrationRig rig;
        if (!tells) {
            rig.calibration.reset();
        }
        swingHalfWay(rig);
        rig.speaks = false;
        rig.run(Seconds(15.0));
        rig.speaks = true;
        rig.runOut();
        ASSERT_TRUE(rig.status().proposal) << rig.status().progress.outcome.toStdString();
        const auto doubts = rig.status().proposal->doubts;
        EXPECT_EQ(!tells, std::ranges::any_of(
                              doubts, [](const QString& doubt) { return doubt.contains(QStringLiteral("silent")); }));
    }
}

// Story: a WiFi that was away for ten seconds cost a swing of four minutes.
// REQ-NORTH-42
TEST(CalibrationSwing, WaitsAtRestForASensorThatFallsSilent)
{
    for (const int headings : {0, 16}) {
        CalibrationRig rig;
        rig.goTo(200.0, 30.0);
        ASSERT_TRUE(rig.ask(request::StartSwing{.rate = 3_deg_s, .headings = headings}));
        rig.run(Seconds(90.0));
        rig.speaks = false;
        rig.run(Seconds(15.0));
        const AxisPosition rest = rig.axes();
        const Seconds left = rig.status().progress.left;
        EXPECT_TRUE(rig.status().progress.text.startsWith(QStringLiteral("waiting for sensor data")));
        rig.run(Seconds(10.0));
        EXPECT_EQ(rest, rig.axes());
        EXPECT_EQ(left, rig.status().progress.left) << "waiting is no progress";
        rig.speaks = true;
        rig.runOut();
        ASSERT_TRUE(rig.status().proposal) << rig.status().progress.outcome.toStdString();
        ASSERT_TRUE(rig.apply());
        EXPECT_LT(std::abs(northError(rig)), 2.0);
    }
}

// The WiFi of the broker comes and goes. The swing waits only as long as a person at the mast would.
// REQ-NORTH-42: A sensor may fall silent during a swing (a broker that is restarted, WiFi). The mount turns on until
// the sensor counts as lost, then stands still and waits. It counts down 30 s in all, and an alarm says that it will
// continue by itself. When readings arrive again it continues from there. Otherwise it ends, holds and gives the
// reason, including the trouble of the broker. STOP, every other end, and a sensor that was restarted end the waiting
// too. A swing that has ended does not start again by itself.
TEST(CalibrationSwing, WaitsNoLongerInAllThanOnce)
{
    CalibrationRig rig;
    swingHalfWay(rig);
    int waits = 0;
    for (; waits < 10 && rig.status().progress.run == CalibrationRun::Swing; ++waits) {
        rig.speaks = false;
        rig.run(Seconds(17.0));
        rig.speaks = true;
        rig.run(Seconds(3.0));
    }
    EXPECT_TRUE(rig.status().progress.failed);
    EXPECT_GT(waits, 1);
    EXPECT_LT(waits, 5);
}

// REQ-NORTH-42
TEST(CalibrationSwing, StopEndsTheWaitingToo)
{
    CalibrationRig rig;
    swingHalfWay(rig);
    rig.speaks = false;
    rig.run(Seconds(12.0));
    ASSERT_TRUE(rig.ask(request::Stop{}));
    rig.run(Seconds(1.0));
    EXPECT_EQ(CalibrationRun::None, rig.status().progress.run);
    ASSERT_TRUE(rig.ask(request::ResetStop{}));
    const AxisPosition rest = rig.axes();
    rig.speaks = true;
    rig.run(Seconds(5.0));
    EXPECT_EQ(rest, rig.axes());
}

bool warnsOfTheWait(const CalibrationRig& rig)
{
    const auto alarms = rig.control.status().alarms;
    return std::ranges::any_of(
        alarms, [](const Alarm& alarm) { return alarm.active && alarm.action.contains(QStringLiteral("BY ITSELF")); });
}

// REQ-NORTH-42
TEST(CalibrationSwing, WhoStandsAtTheMastIsToldThatItWillGoOn)
{
    CalibrationRig rig;
    swingHalfWay(rig);
    EXPECT_FALSE(warnsOfTheWait(rig));
    rig.speaks = false;
    rig.run(Seconds(12.0));
    EXPECT_TRUE(warnsOfTheWait(rig));
    rig.speaks = true;
    rig.run(Seconds(3.0));
    EXPECT_FALSE(warnsOfTheWait(rig));
    rig.speaks = false;
    rig.run(Seconds(12.0));
    EXPECT_TRUE(warnsOfTheWait(rig));
    ASSERT_TRUE(rig.ask(request::Hold{}));
    rig.run(Seconds(0.1));
    EXPECT_FALSE(warnsOfTheWait(rig));
}

}  // namespace
}  // namespace boresight
