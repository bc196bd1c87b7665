// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/system/simulated_station.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

// The crash-stop test on drives with all their physics: its report agrees with the motion of the real antenna.
namespace boresight::system_test {
namespace {

using ::testing::HasSubstr;

class CrashStop : public ::testing::Test
{
protected:
    // The real run-out of each axis: from the last moment at speed until it stands still.
    struct Truth
    {
        double fastest = 0.0;   // °/s
        double farthest = 0.0;  // degrees from where the test began
    };

    void place(double azimuth, double elevation)
    {
        ASSERT_EQ(rig.ask(request::PointAxes{{Angle::fromDegrees(azimuth), Angle::fromDegrees(elevation)}}), "");
        ASSERT_TRUE(rig.settle());
        start = {rig.truth(Axis::Azimuth), rig.truth(Axis::Elevation)};
        rig.onTick = [this] {
            for (const Axis axis : {Axis::Azimuth, Axis::Elevation}) {
                Truth& mine = truth[axis == Axis::Azimuth ? 0 : 1];
                mine.fastest = std::max(mine.fastest, std::abs(rig.link->truth(axis).rate.degrees()));
                const double moved = rig.truth(axis) - start[axis == Axis::Azimuth ? 0 : 1];
                mine.farthest = std::max(mine.farthest, std::abs(moved));
            }
        };
    }

    bool finishes()
    {
        return rig.runUntil([this] { return !rig.status().drives->proofRunning; }, Seconds(20.0));
    }

    // Changes a setting unseen by Boresight. A drive check would refuse it.
    void setQuietly(Axis axis, const std::string& command)
    {
        const std::string text = command + '\n';
        rig.link->pair().drive(axis).receiveText(1, {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
    }

    // An azimuth axis with little friction: without torque it runs on.
    static sim::PairSettings easyAzimuth()
    {
        sim::PairSettings pair = sim::commissionedPair();
        pair.azimuth.plant.coulombFriction = 0.2;
        pair.azimuth.plant.staticFriction = 0.3;
        pair.azimuth.plant.viscousFriction = 0.2;
        return pair;
    }

    SimulatedStation rig{anyPort(), easyAzimuth()};
    std::array<double, 2> start{};
    std::array<Truth, 2> truth;
};

// REQ-AXES-20 (CrashStop.*)
TEST_F(CrashStop, ReportsWhatTheAntennaDid)
{
    place(100.0, 45.0);
    ASSERT_EQ(rig.ask(request::ProveCrashStop{3_deg_s}), "");
    EXPECT_EQ(rig.status().state, StationState::Calibrate);
    ASSERT_TRUE(finishes());
    EXPECT_EQ(rig.status().drives->proofText, QStringLiteral("done"));
    const DrivesStatus drives = *rig.status().drives;
    for (const DriveStatus* const drive : {&drives.azimuth, &drives.elevation}) {
        ASSERT_TRUE(drive->crashStop);
        EXPECT_EQ(drive->crashStop->rate, 3_deg_s);
        EXPECT_EQ(drive->crashStop->drive, drive->identity.uuid);
        // At least the watchdog time of 0.1 s at 3°/s, followed by the ramp of the drive's own limit.
        EXPECT_GT(drive->crashStop->angle, 0.3_deg);
        EXPECT_LT(drive->crashStop->angle, 1_deg);
        EXPECT_GT(drive->crashStop->time, std::chrono::milliseconds(100));
        EXPECT_LT(drive->crashStop->time, std::chrono::milliseconds(400));
    }
    for (const Truth& axis : truth) {
        EXPECT_NEAR(axis.fastest, 3.0, 0.4);
    }
    // A run-up of 1.5 s with its ramp, then the reported stop.
    EXPECT_LT(truth[0].farthest, 3.0 * 1.5 + drives.azimuth.crashStop->angle.degrees() + 0.3);
    EXPECT_EQ(rig.status().state, StationState::Hold);
    const AxisPosition rest = rig.truth();
    rig.run(Seconds(5.0));
    EXPECT_LT(rig.farthestFrom(rest), 0.05_deg) << "held again";
}

TEST_F(CrashStop, StopEndsItAndTheDriveIsTakenBack)
{
    place(100.0, 45.0);
    ASSERT_EQ(rig.ask(request::ProveCrashStop{3_deg_s}), "");
    rig.run(Seconds(1.0));
    ASSERT_TRUE(rig.status().drives->proofRunning);
    ASSERT_EQ(rig.ask(request::Stop{}), "");
    rig.run(Seconds(2.0));
    EXPECT_FALSE(rig.status().drives->proofRunning);
    EXPECT_EQ(rig.status().state, StationState::Stopped);
    EXPECT_FALSE(rig.status().drives->azimuth.crashStop) << "nothing was measured";
    const AxisPosition rest = rig.truth();
    rig.run(Seconds(3.0));
    EXPECT_LT(rig.farthestFrom(rest), 0.05_deg);
    EXPECT_EQ(rig.link->truth(Axis::Azimuth).mode, moteus::Mode::Position);
}

TEST_F(CrashStop, ADriveThatLetsGoIsReportedAsFailed)
{
    place(100.0, 45.0);
    ASSERT_EQ(rig.ask(request::ProveCrashStop{5_deg_s}), "");
    setQuietly(Axis::Azimuth, "conf set servo.timeout_mode 0");  // off
    ASSERT_TRUE(finishes());
    EXPECT_THAT(rig.status().drives->proofText.toStdString(), HasSubstr("azimuth did not stop"));
    EXPECT_NE(rig.status().drives->proofText, QStringLiteral("done"));
    EXPECT_FALSE(rig.status().drives->azimuth.crashStop);
}

TEST_F(CrashStop, TheOperatorIsTheOnlyOneWhoStartsIt)
{
    place(100.0, 45.0);
    EXPECT_NE(rig.ask(request::ProveCrashStop{6_deg_s}), "") << "too fast";
    EXPECT_NE(rig.ask(request::ProveCrashStop{0.1_deg_s}), "") << "too slow to tell";
    ASSERT_EQ(rig.ask(request::ProveCrashStop{2_deg_s}), "");
    rig.run(Seconds(0.5));
    EXPECT_THAT(rig.ask(request::PointAxes{{.azimuth = 0_deg, .elevation = 20_deg}}), HasSubstr("crash-stop test"));
    EXPECT_EQ(rig.ask(request::EndProof{}), "");
    ASSERT_TRUE(rig.settle());
    EXPECT_EQ(rig.status().state, StationState::Hold);
}

}  // namespace
}  // namespace boresight::system_test
