// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/control/arming.h"

#include "tests/core/control/station_rig.h"
#include "tests/fakes/ideal_drive.h"
#include "tests/fakes/manual_clock.h"
#include "tests/fakes/text_of.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace boresight {
namespace {

using supervision::LossClass;

constexpr Seconds kTick{0.02};

profile::Profile retryingHeat()
{
    profile::Profile profile;
    profile.recovery.overTemperature = profile::Retry::Once;
    profile.recovery.interval = Seconds(5.0);
    return profile;
}

struct ArmingRig
{
    explicit ArmingRig(const profile::Profile& profile = {})
        : inForce(profile), mount(inForce, clock, log, alarms), arming(inForce, mount, log)
    {}

    void makeReady()
    {
        mount.setInterlock({});
        run(Seconds(0.2));
    }

    void run(Seconds time)
    {
        for (Seconds left = time; left > Seconds(0.0); left -= kTick) {
            tick();
        }
    }

    static void fail(fakes::IdealDrive& drive, int fault)
    {
        drive.mode = moteus::Mode::Fault;
        drive.fault = fault;
    }

    [[nodiscard]] std::string refusal(const Source& source = kOperator) const
    {
        const Result<> admitted = arming.admits(source);
        return admitted ? std::string() : textOf(admitted.error());
    }

    [[nodiscard]] bool logSays(const char* words) const
    {
        return std::ranges::any_of(log.since(0, EventLog::kCapacity), [&](const LogEntry& line) {
            return line.text.startsWith(QString::fromUtf8(words));
        });
    }

    profile::InForce inForce;
    fakes::ManualClock clock;
    EventLog log{clock};
    AlarmBoard alarms{log, clock};
    MoteusMount mount;
    Arming arming;
    fakes::IdealDrive azimuth{1, 0.0};
    fakes::IdealDrive elevation{2, -0.25};
    int connectionsLost = 0;
    int rearms = 0;

private:
    void tick()
    {
        clock.advance(kTick);
        const SteadyTime now = clock.now();
        mount.observe(now);
        connectionsLost += arming.losesConnection(now) ? 1 : 0;
        for (const AxisTrouble& trouble : mount.supervise({.faultLatched = arming.fault().has_value()}).troubles) {
            arming.lost(trouble.axis, trouble.loss, mount.name(trouble.axis) + QStringLiteral(" failed"));
        }
        rearms += arming.completesRearm() ? 1 : 0;
        for (const CanFrame& frame : mount.frames()) {
            for (fakes::IdealDrive* const drive : {&azimuth, &elevation}) {
                if (const auto reply = drive->answer(frame, now)) {
                    mount.take(*reply);
                }
            }
        }
    }
};

// REQ-CONTROL-23 (Arming.*): Boresight reports what prevents any motion, the first obstacle first. A lost drive waits
// for a re-arm. An overheated drive or a low supply voltage of either axis refuses the re-arm. The refusal names the
// value and the limit.
TEST(Arming, WaitsForBothDrivesAndTheirFitness)
{
    ArmingRig rig;
    EXPECT_EQ(rig.refusal(), "no reply from the azimuth drive");
    rig.elevation.silent = true;
    rig.run(Seconds(0.2));
    EXPECT_EQ(rig.refusal(), "no reply from the elevation drive");
    rig.elevation.silent = false;
    rig.run(Seconds(0.2));
    EXPECT_EQ(rig.refusal(), "the drives have not been checked yet");
    rig.mount.setInterlock(failure(ErrorCode::Refused, QStringLiteral("servo.timeout_mode is 12")));
    EXPECT_EQ(rig.refusal(), "servo.timeout_mode is 12");
    rig.mount.setInterlock({});
    EXPECT_TRUE(rig.arming.admits(kOperator));
    EXPECT_TRUE(rig.arming.admits(kClient));
}

TEST(Arming, StopShutsOutEverybodyUntilReset)
{
    ArmingRig rig;
    rig.makeReady();
    rig.arming.latchStop();
    EXPECT_EQ(rig.refusal(kOperator), "STOP is latched. Reset STOP first.");
    EXPECT_EQ(rig.refusal(kClient), "STOP is latched. Reset STOP first.");
    EXPECT_TRUE(rig.arming.resetStop());
    EXPECT_TRUE(rig.arming.admits(kOperator));
    EXPECT_FALSE(rig.arming.resetStop()) << "there is none any more";
}

TEST(Arming, AfterStopTheClientsWaitForTheOperator)
{
    ArmingRig rig;
    rig.makeReady();
    rig.arming.latchStop();
    ASSERT_TRUE(rig.arming.resetStop());
    EXPECT_FALSE(rig.arming.admits(kClient));
    rig.arming.giveAuthority();
    EXPECT_TRUE(rig.arming.admits(kClient));
}

TEST(Arming, IsQuietForASecondAfterALostConnectionCameBack)
{
    ArmingRig rig;
    rig.makeReady();
    EXPECT_EQ(rig.refusal(), "") << "the first contact is no return";
    rig.azimuth.silent = true;
    rig.run(Seconds(0.4));
    EXPECT_EQ(rig.connectionsLost, 1);
    EXPECT_EQ(rig.refusal(), "no reply from the azimuth drive");
    rig.azimuth.silent = false;
    rig.run(Seconds(0.9));
    EXPECT_EQ(rig.refusal(), "The drives have just come back. Wait a second.");
    rig.run(Seconds(0.2));
    EXPECT_TRUE(rig.arming.admits(kOperator));
}

TEST(Arming, ABusLeftToOthersAdmitsNobody)
{
    ArmingRig rig;
    rig.makeReady();
    EXPECT_FALSE(rig.mount.leaveBus().isEmpty());
    rig.run(kTick);
    EXPECT_EQ(rig.connectionsLost, 1);
    EXPECT_EQ(rig.refusal(), "The bus is released to other tools. Take the bus back first.");
}

TEST(Arming, TheFirstFaultOfASeriesIsTheReasonUntilARearmIsDone)
{
    ArmingRig rig;
    rig.makeReady();
    EXPECT_FALSE(rig.arming.rearm(kOperator)) << "there is no fault";
    rig.fail(rig.azimuth, 35);
    rig.run(Seconds(0.2));
    rig.fail(rig.elevation, 35);
    rig.run(Seconds(0.2));
    EXPECT_EQ(rig.arming.fault(), QStringLiteral("azimuth drive failed"));
    EXPECT_EQ(rig.refusal(), "azimuth drive failed. Re-arm first.");
    ASSERT_TRUE(rig.arming.rearm(kOperator));
    EXPECT_TRUE(rig.arming.fault()) << "the drives have not answered yet";
    rig.run(Seconds(0.2));
    EXPECT_EQ(rig.rearms, 1);
    EXPECT_FALSE(rig.arming.fault());
    EXPECT_EQ(rig.azimuth.mode, moteus::Mode::Stopped);
    EXPECT_EQ(rig.elevation.mode, moteus::Mode::Stopped);
    EXPECT_TRUE(rig.arming.admits(kOperator));
    EXPECT_FALSE(rig.arming.admits(kClient)) << "who went on sending must not move the mount at once";
}

TEST(Arming, ALossWhileRearmingEndsTheRearm)
{
    ArmingRig rig;
    rig.makeReady();
    rig.fail(rig.azimuth, 35);
    rig.run(Seconds(0.2));
    ASSERT_TRUE(rig.arming.rearm(kOperator));
    rig.fail(rig.elevation, 35);
    rig.run(Seconds(0.5));
    EXPECT_EQ(rig.rearms, 0);
    EXPECT_TRUE(rig.arming.fault());
}

TEST(Arming, RearmingIsTheOperatorsWhileTheOperatorHasTakenOver)
{
    ArmingRig rig;
    rig.makeReady();
    rig.fail(rig.azimuth, 35);
    rig.run(Seconds(0.2));
    rig.arming.takeAuthority(Taking::Explicitly);
    EXPECT_FALSE(rig.arming.rearm(kClient));
    rig.arming.giveAuthority();
    EXPECT_TRUE(rig.arming.rearm(kClient));
}

TEST(Arming, HeatMustPassBeforeARearm)
{
    ArmingRig rig;
    rig.makeReady();
    rig.azimuth.temperature = 76.0;
    rig.fail(rig.azimuth, 38);
    rig.run(Seconds(0.2));
    const Result<> hot = rig.arming.rearm(kOperator);
    ASSERT_FALSE(hot);
    EXPECT_NE(textOf(hot.error()).find("azimuth drive: The drive board is still at 76 °C"), std::string::npos)
        << textOf(hot.error());
    rig.azimuth.temperature = 60.0;
    rig.run(Seconds(0.2));
    EXPECT_TRUE(rig.arming.rearm(kOperator));
}

// Story: the board of the other drive was at 78 °C. The re-arm was accepted, and that axis lost its torque a second
// later.
TEST(Arming, WhatWouldStopTheMountAgainOnTheOtherAxisRefusesTheRearmToo)
{
    ArmingRig rig;
    rig.makeReady();
    rig.fail(rig.azimuth, 35);
    rig.elevation.temperature = 78.0;
    rig.run(Seconds(0.2));
    const Result<> hot = rig.arming.rearm(kOperator);
    ASSERT_FALSE(hot);
    EXPECT_EQ(textOf(hot.error()), "elevation drive: The drive board is still at 78 °C. It must cool down to 70 °C.");
    EXPECT_TRUE(rig.arming.fault());
    rig.elevation.temperature = 69.0;
    rig.run(Seconds(0.2));
    EXPECT_TRUE(rig.arming.rearm(kOperator));
}

TEST(Arming, ThePolicyRearmsWhenItsTimeHasComeButNeverBehindAStop)
{
    ArmingRig rig(retryingHeat());
    rig.makeReady();
    rig.fail(rig.azimuth, 38);
    rig.run(Seconds(4.5));
    EXPECT_EQ(rig.rearms, 0) << "the interval is 5 s";
    rig.arming.latchStop();
    rig.run(Seconds(3.0));
    EXPECT_EQ(rig.rearms, 0);
    ASSERT_TRUE(rig.arming.resetStop());
    rig.run(Seconds(0.3));
    EXPECT_EQ(rig.rearms, 1);
    EXPECT_TRUE(rig.logSays("re-arms by the recovery policy of the profile"));
    rig.fail(rig.azimuth, 38);
    rig.run(Seconds(20.0));
    EXPECT_EQ(rig.rearms, 1) << "once means once";
}

TEST(Arming, AProgramThatClosesStartsAndRearmsNothing)
{
    ArmingRig rig;
    rig.makeReady();
    rig.arming.close();
    EXPECT_EQ(rig.refusal(), "Boresight is closing");
    rig.fail(rig.azimuth, 35);
    rig.run(Seconds(0.2));
    EXPECT_EQ(textOf(rig.arming.rearm(kOperator).error()), "Boresight is closing");
}

}  // namespace
}  // namespace boresight
