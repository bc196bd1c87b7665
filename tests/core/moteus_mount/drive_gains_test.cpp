// SPDX-License-Identifier: GPL-3.0-or-later
// The gains of a drive are read and changed independently of its motion control.
#include "tests/core/moteus_mount/care_rig.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace boresight {
namespace {

using ::testing::HasSubstr;

// A mount that holds at the end of kGo, with the azimuth gains read.
struct GainsAtRest : CareRig
{
    explicit GainsAtRest(const sim::PairSettings& settings = sim::commissionedPair()) : CareRig(settings)
    {
        EXPECT_TRUE(endsItsDriveCheck());
    }

    bool read() { return ask(request::ReadGains{}) == "" && settles() && drives().azimuth.gains.read; }

    bool settles()
    {
        run(Seconds(1.0));
        for (int i = 0; i < 200 && drives().azimuth.gains.busy; ++i) {
            tick();
        }
        return !drives().azimuth.gains.busy;
    }

    std::string set(Gain gain, double factor)
    {
        const request::SetGain wanted{
            .gain = gain, .value = factor * *drives().azimuth.gains.lines[static_cast<std::size_t>(gain)].value};
        const std::string refused = refusal(wanted);
        return refused.empty() ? ask(wanted) : refused;
    }
};

// REQ-AXES-960 (DriveCare.Gains*): Gains are changed while the axis stands still, also while its drive holds it. The
// drives must be off for storing, and for a setting that restarts the count of the encoder.
TEST(DriveCare, GainsAreChangedUnderADriveThatHolds)
{
    GainsAtRest rig;
    EXPECT_THAT(rig.obstacle(Action::SetAzimuthGains), HasSubstr("Read the gains first"));
    ASSERT_TRUE(rig.read());
    ASSERT_EQ(rig.ask(kGo), "");
    rig.run(Seconds(1.0));
    EXPECT_THAT(rig.ask(request::SetGain{.gain = Gain::Damping, .value = 9000.0}), HasSubstr("The mount moves"));
    EXPECT_THAT(rig.obstacle(Action::SetAzimuthGains), HasSubstr("The mount moves"));
    rig.run(Seconds(20.0));
    ASSERT_EQ(rig.set(Gain::Stiffness, 0.8), "");
    EXPECT_THAT(rig.obstacle(Action::ReadDrives), HasSubstr("is reading or writing the gains"));
    ASSERT_TRUE(rig.settles());
    rig.run(Seconds(1.0));
    EXPECT_EQ(rig.control.status().state, StationState::Hold);
    EXPECT_TRUE(rig.drives().azimuth.gains.onTrial);
    EXPECT_TRUE(rig.logSays("in force until a power cycle: servo.pid_position.kp"));
    EXPECT_NEAR(rig.pair.truth(Axis::Azimuth).angle.degrees(), 30.0, 0.2);

    EXPECT_THAT(rig.set(Gain::EncoderFilter, 0.5), HasSubstr("switched on"));
    EXPECT_THAT(rig.ask(request::StoreGains{}), HasSubstr("switched on"));
    EXPECT_THAT(rig.obstacle(Action::SetAzimuthFilter), HasSubstr("switched on"));
}

TEST(DriveCare, GainsAreStoredWhileTheDrivesAreOff)
{
    GainsAtRest rig;
    ASSERT_TRUE(rig.read());
    EXPECT_THAT(rig.refusal(request::StoreGains{}), HasSubstr("No gains are on trial"));
    EXPECT_THAT(rig.refusal(request::PutGainsBack{}), HasSubstr("No gain differs from its first value"));
    ASSERT_EQ(rig.set(Gain::InertiaFeedforward, 1.1), "");
    ASSERT_TRUE(rig.settles());
    ASSERT_EQ(rig.refusal(request::StoreGains{}), "");
    ASSERT_EQ(rig.ask(request::StoreGains{}), "");
    ASSERT_TRUE(rig.settles());
    EXPECT_FALSE(rig.drives().azimuth.gains.onTrial);
    EXPECT_TRUE(rig.logSays("are stored in its drive"));
}

// The encoder count restarts, so the wrap of the axis is unknown until it is determined again.
TEST(DriveCare, GainsOfTheFilterMakeTheWrapUnknown)
{
    GainsAtRest rig;
    ASSERT_TRUE(rig.read());
    ASSERT_TRUE(rig.control.status().azimuth.turnKnown);
    ASSERT_EQ(rig.set(Gain::EncoderFilter, 0.5), "");
    bool unknown = false;
    for (int i = 0; i < 200; ++i) {
        rig.tick();
        unknown = unknown || !rig.control.status().azimuth.turnKnown;
    }
    EXPECT_TRUE(unknown);
    EXPECT_DOUBLE_EQ(rig.pair.drive(Axis::Azimuth).driveConfig().motorPosition.pllFilter, 200.0);
    EXPECT_TRUE(rig.logSays("counts from a new zero"));
}

// Story: the drives were off when the encoder filter was sent. A go-to in the next tick switched them on during the
// write: fault 41. A drive that is writing its flash follows no commands either.
// REQ-AXES-962: No motion begins while settings of a drive are written or stored.
TEST(DriveCare, GainsThatAreWrittenKeepTheMountWhereItStands)
{
    GainsAtRest rig;
    ASSERT_TRUE(rig.read());
    ASSERT_EQ(rig.set(Gain::EncoderFilter, 0.5), "");
    EXPECT_THAT(rig.ask(kGo), HasSubstr("is reading or writing the gains"));
    ASSERT_TRUE(rig.settles());
    ASSERT_TRUE(rig.endsItsDriveCheck());
    ASSERT_TRUE(rig.read());
    ASSERT_EQ(rig.ask(request::StoreGains{}), "");
    EXPECT_THAT(rig.ask(kGo), HasSubstr("is reading or writing the gains"));
    ASSERT_TRUE(rig.settles());
    rig.run(Seconds(0.1));
    EXPECT_EQ(rig.obstacle(Action::StoreAzimuthGains), "No gains are on trial. The drive has stored what it uses.");
}

// Story: Fix stores all settings in effect, so gains that were only tried out became permanent.
// REQ-AXES-961: Fix, a new id and a new gear ratio are refused while gains are on trial.
TEST(DriveCare, GainsOnTrialAreNotStoredByFix)
{
    GainsAtRest rig(dampingElevation());
    ASSERT_TRUE(rig.read());
    ASSERT_EQ(rig.refusal(request::FixDrives{}), "");
    ASSERT_EQ(rig.set(Gain::Damping, 1.2), "");
    ASSERT_TRUE(rig.settles());
    EXPECT_THAT(rig.refusal(request::FixDrives{}), HasSubstr("New gains are on trial"));
    EXPECT_THAT(rig.refusal(request::SetGear{}), HasSubstr("New gains are on trial"));
    EXPECT_THAT(rig.obstacle(Action::AssignElevationBoard), HasSubstr("New gains are on trial"));
    ASSERT_EQ(rig.ask(request::PutGainsBack{}), "");
    ASSERT_TRUE(rig.settles());
    EXPECT_EQ(rig.refusal(request::FixDrives{}), "");
}

}  // namespace
}  // namespace boresight
