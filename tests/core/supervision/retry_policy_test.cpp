// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/supervision/retry_policy.h"

#include <gtest/gtest.h>

namespace boresight::supervision {
namespace {

using profile::Retry;

SteadyTime at(double seconds)
{
    return SteadyTime(std::chrono::hours(1)) + std::chrono::duration_cast<SteadyTime::duration>(Seconds(seconds));
}

profile::RecoverySettings always(Retry retry)
{
    return {.overTemperature = retry, .supply = retry, .bus = retry, .interval = Seconds(60.0)};
}

struct KeptProfile
{
    explicit KeptProfile(const profile::RecoverySettings& settings) { put(settings); }

    void put(const profile::RecoverySettings& settings)
    {
        profile::Profile profile = *inForce;
        profile.recovery = settings;
        inForce.apply(profile);
    }

    profile::InForce inForce{profile::Profile()};
};

// A policy with these settings in effect.
struct PolicyBy : KeptProfile, RetryPolicy
{
    explicit PolicyBy(const profile::RecoverySettings& settings) : KeptProfile(settings), RetryPolicy(inForce) {}
};

// REQ-SUPERVISION-20: Nothing is re-armed without a person unless the profile says so. It is never re-armed
// automatically after encoder, configuration, driver or motion faults, after another program released the drive, or
// after a stop by Boresight itself.
TEST(RetryPolicy, NothingIsRetriedByDefault)
{
    for (int loss = 0; loss <= static_cast<int>(LossClass::Bus); ++loss) {
        PolicyBy policy({});
        policy.lost(static_cast<LossClass>(loss), at(0));
        EXPECT_FALSE(policy.nextTry()) << loss;
    }
}

// REQ-SUPERVISION-20
TEST(RetryPolicy, OnlyHeatSupplyAndBusMayEverBeRetried)
{
    for (const LossClass loss :
         {LossClass::Encoder, LossClass::Configuration, LossClass::Driver, LossClass::Motion, LossClass::Released}) {
        PolicyBy policy(always(Retry::Interval));
        policy.lost(loss, at(0));
        EXPECT_FALSE(policy.nextTry());
    }
    for (const LossClass loss : {LossClass::OverTemperature, LossClass::Supply, LossClass::Bus}) {
        PolicyBy policy(always(Retry::Interval));
        policy.lost(loss, at(0));
        EXPECT_EQ(policy.nextTry(), at(60));
    }
}

// REQ-SUPERVISION-20
TEST(RetryPolicy, AnotherRuleCountsFromTheNextLossOn)
{
    PolicyBy policy({});
    policy.lost(LossClass::Bus, at(0));
    EXPECT_FALSE(policy.nextTry());
    policy.rearmed();
    policy.put(always(Retry::Once));
    policy.lost(LossClass::Bus, at(100));
    EXPECT_EQ(policy.nextTry(), at(160));
}

// REQ-SUPERVISION-20
TEST(RetryPolicy, EachClassHasItsOwnSetting)
{
    const profile::RecoverySettings onlyBus{.bus = Retry::Once, .interval = Seconds(5.0)};
    PolicyBy bus(onlyBus);
    bus.lost(LossClass::Bus, at(0));
    EXPECT_EQ(bus.nextTry(), at(5));
    PolicyBy supply(onlyBus);
    supply.lost(LossClass::Supply, at(0));
    EXPECT_FALSE(supply.nextTry());
}

// REQ-SUPERVISION-23: "interval" tries again, each time this long after the loss or the last attempt.
TEST(RetryPolicy, IntervalGoesOnForEver)
{
    PolicyBy policy(always(Retry::Interval));
    policy.lost(LossClass::Bus, at(0));
    for (int i = 1; i < 100; ++i) {
        ASSERT_EQ(policy.nextTry(), at(60.0 * i));
        policy.tried(at(60.0 * i));
        policy.lost(LossClass::Bus, at(60.0 * i));
    }
    policy.tried(at(6000));
    EXPECT_EQ(policy.nextTry(), at(6060)) << "also when the attempt came to nothing";
    policy.healthy(at(6001));
    EXPECT_FALSE(policy.nextTry()) << "nothing is lost";
}

// REQ-SUPERVISION-22: "once" means once in an episode. A re-arm by a person or an hour without a loss starts a new
// episode.
TEST(RetryPolicy, OnceIsOncePerEpisode)
{
    PolicyBy policy(always(Retry::Once));
    policy.lost(LossClass::OverTemperature, at(0));
    ASSERT_EQ(policy.nextTry(), at(60));
    policy.tried(at(60));
    EXPECT_FALSE(policy.nextTry());
    for (int i = 0; i < 1000; ++i) {
        policy.healthy(at(61 + i));
    }
    policy.lost(LossClass::OverTemperature, at(1100));
    EXPECT_FALSE(policy.nextTry()) << "the same episode";

    policy.rearmed();
    EXPECT_FALSE(policy.nextTry()) << "nothing is lost";
    policy.lost(LossClass::OverTemperature, at(1200));
    EXPECT_EQ(policy.nextTry(), at(1260)) << "a person has re-armed";
}

// REQ-SUPERVISION-22
TEST(RetryPolicy, AnHourOfHealthRenewsOnce)
{
    PolicyBy policy(always(Retry::Once));
    policy.lost(LossClass::Supply, at(0));
    policy.tried(at(60));
    policy.healthy(at(60));
    policy.healthy(at(60 + 3599));
    policy.lost(LossClass::Supply, at(3660));
    EXPECT_FALSE(policy.nextTry()) << "a second less than an hour";

    policy.tried(at(3700));
    policy.healthy(at(3700));
    policy.healthy(at(3700 + 3600));
    policy.lost(LossClass::Supply, at(8000));
    EXPECT_EQ(policy.nextTry(), at(8060));
}

// REQ-SUPERVISION-22
TEST(RetryPolicy, TwoTimesHalfAnHourIsNoHourOfHealth)
{
    PolicyBy policy(always(Retry::Once));
    policy.lost(LossClass::Bus, at(0));
    policy.tried(at(60));
    policy.healthy(at(60));
    policy.healthy(at(2400));
    policy.lost(LossClass::Bus, at(2400));
    policy.healthy(at(2500));
    policy.healthy(at(4800));
    policy.lost(LossClass::Bus, at(4800));
    EXPECT_FALSE(policy.nextTry());
}

// REQ-SUPERVISION-24: Of several losses the strictest rule decides.
TEST(RetryPolicy, TheStrictestLossDecides)
{
    PolicyBy policy(always(Retry::Interval));
    policy.lost(LossClass::Bus, at(0));
    policy.lost(LossClass::Encoder, at(1));
    policy.lost(LossClass::Bus, at(2));
    EXPECT_FALSE(policy.nextTry());
    policy.rearmed();
    policy.lost(LossClass::Bus, at(10));
    EXPECT_EQ(policy.nextTry(), at(70));
}

class ClearRefusal : public ::testing::Test
{
protected:
    [[nodiscard]] std::string refusal(LossClass loss, const DriveConditions& atLoss, const DriveConditions& now) const
    {
        return clearRefusal(settings, loss, atLoss, now).toStdString();
    }
    profile::SupervisionSettings settings;
};

// REQ-SUPERVISION-25 (ClearRefusal.*): A re-arm is refused with value and limit while the heat or the supply voltage
// that caused the stop is still there, whatever class the loss has. The heat is gone 5 °C below the fault temperature
// and the limit of the part that was hot. The motor must be below `motor_hot_c` in any case.
TEST_F(ClearRefusal, ABoardMustCoolDownByFiveDegrees)
{
    const DriveConditions hot{.voltage = 24.0, .boardTemperature = 76.0};
    EXPECT_EQ(refusal(LossClass::OverTemperature, hot, {.voltage = 24.0, .boardTemperature = 70.6}),
              "The drive board is still at 71 °C. It must cool down to 70 °C.");
    EXPECT_EQ(refusal(LossClass::OverTemperature, hot, {.voltage = 24.0, .boardTemperature = 70.0}), "");
    // A drive with a lower limit of its own, and a motor without a sensor.
    const DriveConditions strict{.voltage = 24.0, .boardTemperature = 60.0};
    EXPECT_NE(refusal(LossClass::OverTemperature, strict, {.voltage = 24.0, .boardTemperature = 56.0}), "");
    EXPECT_EQ(refusal(LossClass::OverTemperature, strict, {.voltage = 24.0, .boardTemperature = 55.0}), "");
}

// Story: a board at 32 °C never cools down by five degrees on a warm day. The motor was the hot part.
TEST_F(ClearRefusal, AMotorMustCoolDownIfItWasTheMotor)
{
    const DriveConditions hot{.voltage = 24.0, .boardTemperature = 32.0, .motorTemperature = 90.0};
    EXPECT_EQ(
        refusal(LossClass::OverTemperature, hot, {.voltage = 24.0, .boardTemperature = 32.0, .motorTemperature = 86.0}),
        "The motor is still at 86 °C. It must cool down to 80 °C.");
    EXPECT_EQ(
        refusal(LossClass::OverTemperature, hot, {.voltage = 24.0, .boardTemperature = 33.0, .motorTemperature = 79.9}),
        "");
    // A motor with a limit below the hot temperature of the profile.
    const DriveConditions small{.voltage = 24.0, .boardTemperature = 32.0, .motorTemperature = 70.0};
    EXPECT_EQ(refusal(LossClass::OverTemperature, small,
                      {.voltage = 24.0, .boardTemperature = 32.0, .motorTemperature = 66.0}),
              "The motor is still at 66 °C. It must cool down to 65 °C.");
}

// Story: a motor at 95 °C became hotter after its drive had switched off. The re-arm was accepted all the same.
TEST_F(ClearRefusal, AMotorThatIsHotNowIsNotReArmed)
{
    const DriveConditions both{.voltage = 24.0, .boardTemperature = 76.0, .motorTemperature = 78.0};
    EXPECT_EQ(refusal(LossClass::OverTemperature, both,
                      {.voltage = 24.0, .boardTemperature = 60.0, .motorTemperature = 95.0}),
              "The motor is still at 95 °C. It must cool down to 80 °C.");
    EXPECT_EQ(refusal(LossClass::OverTemperature, both,
                      {.voltage = 24.0, .boardTemperature = 60.0, .motorTemperature = 79.0}),
              "");
}

// Story: Boresight had stopped a mount at 11 V, and at 11 V it was re-armed.
TEST_F(ClearRefusal, ASupplyThatStoppedTheMountMustBeBackWhateverTheLossWasCalled)
{
    const DriveConditions low{.voltage = 11.8, .boardTemperature = 30.0};
    EXPECT_EQ(refusal(LossClass::Motion, low, {.voltage = 14.0}),
              "The supply is still at 14.0 V. It must reach 20.0 V.");
    EXPECT_EQ(refusal(LossClass::Motion, low, {.voltage = 20.5}), "");
    EXPECT_EQ(refusal(LossClass::Motion, {.voltage = 15.0}, {.voltage = 14.0}), "") << "that did not stop it";
}

TEST_F(ClearRefusal, ABoardThatReportsToBeCoolNeedNotCoolDown)
{
    const DriveConditions cool{.voltage = 24.0, .boardTemperature = 32.0};
    EXPECT_EQ(refusal(LossClass::OverTemperature, cool, cool), "");
}

TEST_F(ClearRefusal, TheSupplyMustBeBack)
{
    const DriveConditions cut{.voltage = 3.0, .boardTemperature = 30.0};
    EXPECT_EQ(refusal(LossClass::Supply, cut, {.voltage = 11.0}),
              "The supply is still at 11.0 V. It must reach 20.0 V.");
    EXPECT_EQ(refusal(LossClass::Supply, cut, {.voltage = 46.0}),
              "The supply is still at 46.0 V. It must fall to 42.0 V.");
    EXPECT_EQ(refusal(LossClass::Supply, cut, {.voltage = 24.0}), "");
}

// Story: a temperature that was not a number counted as 0 °C, and the hot motor was re-armed.
TEST_F(ClearRefusal, WhatIsNotToldIsNotCool)
{
    const DriveConditions hot{.voltage = 24.0, .boardTemperature = 76.0, .motorTemperature = 90.0};
    const std::string untold = "The drive does not report its temperature.";
    EXPECT_EQ(refusal(LossClass::OverTemperature, hot, {.voltage = 24.0}), untold);
    const DriveConditions motor{.voltage = 24.0, .boardTemperature = 40.0, .motorTemperature = 90.0};
    EXPECT_EQ(refusal(LossClass::OverTemperature, motor, {.voltage = 24.0, .boardTemperature = 40.0}),
              "The motor was at 90 °C and no longer reports its temperature. Repair its sensor, or let the motor cool "
              "down and restart Boresight.");
    const DriveConditions cool{.voltage = 24.0, .boardTemperature = 40.0, .motorTemperature = 40.0};
    EXPECT_EQ(refusal(LossClass::OverTemperature, hot, cool), "");
    EXPECT_NE(refusal(LossClass::OverTemperature, {}, {.boardTemperature = 74.0}), "") << "nor was it told at the loss";
    EXPECT_EQ(refusal(LossClass::Supply, {.voltage = 3.0}, {}), "The drive does not report its supply voltage.");
}

TEST_F(ClearRefusal, OtherLossesHaveNothingToWaitFor)
{
    const DriveConditions odd{.voltage = 13.0, .boardTemperature = 90.0};
    for (const LossClass loss : {LossClass::Bus, LossClass::Encoder, LossClass::Released}) {
        EXPECT_EQ(refusal(loss, odd, odd), "");
    }
}

// REQ-SUPERVISION-26 (StandingRefusal.*): A re-arm is refused while either drive measures a value that would stop the
// mount again at once: board temperature or supply beyond their limits.
TEST(StandingRefusal, WhatWouldStopTheMountAgainAtOnce)
{
    const profile::SupervisionSettings settings;
    const auto refusal = [&](const DriveConditions& now) { return standingRefusal(settings, now).toStdString(); };
    EXPECT_EQ(refusal({.voltage = 24.0, .boardTemperature = 74.0}), "");
    EXPECT_EQ(refusal({.voltage = 24.0, .boardTemperature = 77.0}),
              "The drive board is still at 77 °C. It must cool down to 70 °C.");
    EXPECT_EQ(refusal({.voltage = 11.9, .boardTemperature = 30.0}),
              "The supply is still at 11.9 V. It must reach 12.0 V.");
    EXPECT_EQ(refusal({.voltage = 13.0, .boardTemperature = 30.0}), "");
    EXPECT_EQ(refusal({}), "") << "a drive that does not tell them";
}

}  // namespace
}  // namespace boresight::supervision
