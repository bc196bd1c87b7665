// SPDX-License-Identifier: GPL-3.0-or-later
// Drives that report a wrong position, or none. The tests judge how far the set-points have moved the real axis.
#include "tests/core/control/station_rig.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

namespace boresight {
namespace {

using moteus::Register;
using ::testing::HasSubstr;

constexpr double kAllowed = 0.3;  // degrees that a false reply may move an axis

enum class Pattern
{
    One,
    Two,
    Alternating,
    TenPercent,
    TenPercentSame,
    Burst,        // five replies that agree
    LongerBurst,  // eight replies that agree
    Lasting       // replies that agree for 2 s
};

// Errors of the replies of 10 s, in degrees. The first reply is always false.
std::deque<double> errors(Pattern pattern, double by)
{
    std::minstd_rand random(5);
    std::uniform_real_distribution part(0.0, 1.0);
    const auto errorAt = [&](int i) {
        switch (pattern) {
            case Pattern::One:
                return i == 0 ? by : 0.0;
            case Pattern::Two:
                return i < 2 ? by : 0.0;
            case Pattern::Alternating:
                return i % 2 == 0 ? by : 0.0;
            case Pattern::TenPercent:
                return part(random) < 0.1 ? 2.0 * by * (part(random) - 0.5) : 0.0;
            case Pattern::TenPercentSame:
                return part(random) < 0.1 ? by : 0.0;
            case Pattern::Burst:
                return i < 5 ? by : 0.0;
            case Pattern::LongerBurst:
                return i < 8 ? by : 0.0;
            case Pattern::Lasting:
                return i < 100 ? by : 0.0;
        }
        return 0.0;
    };
    std::deque<double> all;
    for (int i = 0; i < 500; ++i) {
        all.push_back(errorAt(i));
    }
    return all;
}

struct FalsePlaceRig : StationRig
{
    FalsePlaceRig(double azimuthDegrees, double elevationDegrees)
    {
        EXPECT_TRUE(
            holdAt({.azimuth = Angle::fromDegrees(azimuthDegrees), .elevation = Angle::fromDegrees(elevationDegrees)}));
    }

    [[nodiscard]] double degrees(Axis axis) { return angle(axis, drive(axis).position).degrees(); }
    [[nodiscard]] Angle angle(Axis axis, double turns) const
    {
        return profile.axis(axis).geometry.toAxis(MotorTurns::fromTurns(turns));
    }
    [[nodiscard]] double turns(Axis axis, Angle angle) const
    {
        return profile.axis(axis).geometry.toMotor(angle).turns();
    }

    // One tick in which the drive of `axis` reports a position with this error, in degrees.
    void tickWithError(Axis axis, double error)
    {
        drive(axis).falsePlaces.clear();
        drive(axis).advanceTo(clock.now() + std::chrono::duration_cast<SteadyTime::duration>(step));
        if (error != 0.0) {
            const Angle place = angle(axis, drive(axis).position) + Angle::fromDegrees(error);
            drive(axis).falsePlaces.push_back(turns(axis, place));
        }
        tick();
    }
    [[nodiscard]] bool ignoresBounds(Axis axis)
    {
        const auto& fields = drive(axis).seen.back().fields;
        return fields.find(Register::CommandIgnorePositionBounds).value_or(0.0) != 0.0;
    }
    [[nodiscard]] std::string alarms() const
    {
        std::string all;
        for (const Alarm& one : control.status().alarms) {
            all += (one.what + QLatin1Char(' ') + one.action + QLatin1Char('\n')).toStdString();
        }
        return all;
    }
};

struct Case
{
    Pattern pattern;
    Axis axis;
    double by;
};

std::vector<Case> cases()
{
    std::vector<Case> all;
    for (const Pattern pattern : {Pattern::One, Pattern::Two, Pattern::Alternating, Pattern::TenPercent,
                                  Pattern::TenPercentSame, Pattern::Burst, Pattern::LongerBurst, Pattern::Lasting}) {
        for (const double by : {90.0, -60.0, 1.0, 2000.0}) {
            all.push_back({pattern, Axis::Azimuth, by});
            all.push_back({pattern, Axis::Elevation, by});
        }
    }
    return all;
}

class FalsePlaces : public ::testing::TestWithParam<Case>
{
protected:
    [[nodiscard]] static bool agree() { return GetParam().pattern >= Pattern::LongerBurst; }
};

// Story: one reply that was false by 90° moved a standing antenna by 2.8°. One that was false by -60° moved the
// elevation below its travel. The set-point had been put where the false reply said.
// REQ-AXES-19a (FalsePlaces.*): Motion uses the believed position (`PlaceBelief`), never a single reply. No false reply
// moves an axis by more than 0.3°, makes it leave its travel, makes its drive ignore its bounds, or is stored. One or
// two false replies in a row change no motion. After three the axis is braked (REQ-AXES-24). Six that agree with each
// other are a jump: the drive holds, its wrap is in doubt, and no set-point goes out before somebody acts.
TEST_P(FalsePlaces, NothingMovesThatStands)
{
    const auto& [pattern, axis, by] = GetParam();
    FalsePlaceRig rig(100.0, 1.0);
    const double azimuth = rig.degrees(Axis::Azimuth);
    const double elevation = rig.degrees(Axis::Elevation);
    const double before = rig.drive(axis).travelled;
    for (const double error : errors(pattern, by)) {
        rig.tickWithError(axis, error);
        ASSERT_LE(std::abs(rig.drive(axis).travelled - before) * 360.0, kAllowed);
        ASSERT_FALSE(rig.ignoresBounds(axis));
        ASSERT_TRUE(agree() || !rig.control.faultLatched()) << rig.control.status().stateReason.toStdString();
    }
    rig.run(Seconds(5.0));
    EXPECT_LE(std::abs(rig.drive(axis).travelled - before) * 360.0, kAllowed);
    EXPECT_EQ(rig.control.faultLatched(), agree());
    EXPECT_EQ(rig.control.status().azimuth.turnKnown && rig.control.status().elevation.turnKnown, !agree());
    if (!agree()) {
        EXPECT_NEAR(rig.degrees(Axis::Azimuth), azimuth, 1e-6);
        EXPECT_NEAR(rig.degrees(Axis::Elevation), elevation, 1e-6);
    }
}

// Story: false replies during a slew at 10°/s led to 15°/s.
TEST_P(FalsePlaces, ASlewGoesOnOrEnds)
{
    const auto& [pattern, axis, by] = GetParam();
    FalsePlaceRig rig(100.0, 20.0);
    FalsePlaceRig undisturbed(100.0, 20.0);
    for (FalsePlaceRig* const one : {&rig, &undisturbed}) {
        ASSERT_TRUE(one->ask(request::PointAxes{{.azimuth = 190_deg, .elevation = 80_deg}}));
        one->run(Seconds(2.0));
    }
    const double fastest = (axis == Axis::Azimuth ? 10.0 : 8.0) * StationRig::kTick.count() * 1.01;
    for (const double error : errors(pattern, by)) {
        const double before = rig.drive(axis).travelled;
        rig.tickWithError(axis, error);
        undisturbed.tick();
        ASSERT_LE(std::abs(rig.drive(axis).travelled - before) * 360.0, fastest);
        ASSERT_FALSE(rig.ignoresBounds(axis));
        if (pattern == Pattern::One || pattern == Pattern::Two || pattern == Pattern::Alternating) {
            ASSERT_NEAR(rig.degrees(axis), undisturbed.degrees(axis), 1e-6) << "it changes nothing";
        }
    }
    const double ended = rig.drive(axis).travelled;
    rig.run(Seconds(5.0));
    EXPECT_EQ(rig.control.faultLatched(), agree());
    if (agree()) {
        EXPECT_EQ(rig.drive(axis).travelled, ended);
        EXPECT_FALSE(rig.control.status().azimuth.rate && rig.moving());
    } else {
        EXPECT_NEAR(rig.degrees(Axis::Azimuth), 190.0, 0.01);
        EXPECT_NEAR(rig.degrees(Axis::Elevation), 80.0, 0.01);
        EXPECT_EQ(rig.state(), StationState::Hold);
    }
}

TEST_P(FalsePlaces, TheFirstMotionBeginsWhereTheAxisStands)
{
    const auto& [pattern, axis, by] = GetParam();
    StationRig rig;
    rig.run(Seconds(0.5));
    const double before = rig.drive(axis).travelled;
    ASSERT_TRUE(rig.ask(request::Jog{{.azimuth = 0.01_deg_s}}));
    for (int i = 0; i < 20; ++i) {
        const double error = errors(pattern, by).at(static_cast<std::size_t>(i));
        const auto& geometry = rig.profile.axis(axis).geometry;
        const Angle place =
            geometry.toAxis(MotorTurns::fromTurns(rig.drive(axis).position)) + Angle::fromDegrees(error);
        rig.drive(axis).falsePlaces = {geometry.toMotor(place).turns()};
        rig.tick();
        ASSERT_LE(std::abs(rig.drive(axis).travelled - before) * 360.0, kAllowed) << i;
    }
    rig.drive(axis).falsePlaces.clear();
    rig.run(Seconds(3.0));
    EXPECT_LE(std::abs(rig.drive(axis).travelled - before) * 360.0, kAllowed);
}

INSTANTIATE_TEST_SUITE_P(All, FalsePlaces, ::testing::ValuesIn(cases()));

// REQ-AXES-19a (FalsePlace.*)
// REQ-SUPERVISION-05
TEST(FalsePlace, OneIsToldAndTheMotionGoesOn)
{
    FalsePlaceRig rig(100.0, 45.0);
    rig.tickWithError(Axis::Azimuth, 90.0);
    rig.run(Seconds(0.2));
    EXPECT_THAT(rig.alarms(), HasSubstr("A false reply reports that the azimuth jumped by 90.0°"));
    EXPECT_THAT(rig.alarms(), HasSubstr("Boresight does not stop the mount."));
    EXPECT_NEAR(rig.control.status().azimuth.actual->degrees(), 100.0, 1e-3);
    rig.run(Seconds(5.0));
    EXPECT_EQ(rig.state(), StationState::Hold);
    EXPECT_TRUE(std::ranges::none_of(rig.control.status().alarms, &Alarm::active));
}

// The journal must not store a false position.
TEST(FalsePlace, IsNeverWrittenDown)
{
    FalsePlaceRig rig(100.0, 45.0);
    for (const double error : errors(Pattern::Lasting, 90.0)) {
        rig.tickWithError(Axis::Azimuth, error);
        const auto& record = rig.mount.journal().turns[index(Axis::Azimuth)];
        ASSERT_TRUE(record);
        ASSERT_NEAR(record->angle.degrees(), 100.0, 1e-3);
        if (rig.control.faultLatched()) {
            break;
        }
    }
    EXPECT_TRUE(rig.control.faultLatched());
}

// After a fault, too, no set-point goes out before somebody has asked for a motion.
TEST(FalsePlace, AnAxisWhoseAngleHasJumpedGetsNoSetPointBeforeAnAct)
{
    FalsePlaceRig rig(100.0, 45.0);
    const double before = rig.azimuth.travelled;
    for (int round = 0; round < 20; ++round) {
        for (int i = 0; i < 10 + round; ++i) {
            rig.tickWithError(Axis::Azimuth, 90.0);
        }
        rig.run(Seconds(0.1 + 0.02 * round));
        ASSERT_EQ(rig.azimuth.travelled, before) << round;
    }
    EXPECT_TRUE(std::isnan(rig.azimuth.seen.back().fields.at(Register::CommandPosition)));
    rig.run(Seconds(3.0));
    ASSERT_TRUE(rig.ask(request::Rearm{}));
    rig.run(Seconds(1.0));
    EXPECT_EQ(rig.azimuth.travelled, before) << "re-arming moves nothing";
    EXPECT_EQ(rig.control.status().azimuth.state, AxisState::Holding);
}

// Story: the axis moved by 39° in 4 s at full speed, without an alarm.
class BlindDrive : public ::testing::TestWithParam<int>
{
protected:
    static void spoil(fakes::IdealDrive& drive)
    {
        const double places[] = {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(),
                                 1e6};
        const auto kind = static_cast<std::size_t>(GetParam());
        drive.modeOnly = kind == std::size(places);
        drive.falsePlaces.assign(1, drive.modeOnly ? 0.0 : places[kind]);
    }
};

// REQ-AXES-19b (BlindDrive.*): A drive that replies without a believable position is braked after three such replies,
// like a silent drive. After 0.2 s it counts as lost, like a silent drive.
TEST_P(BlindDrive, IsBrakedAfterThreeRepliesAndLostLikeASilentOne)
{
    FalsePlaceRig rig(100.0, 20.0);
    ASSERT_TRUE(rig.ask(request::PointAxes{{.azimuth = 190_deg, .elevation = 80_deg}}));
    rig.run(Seconds(2.0));
    for (int tick = 0; tick < 3; ++tick) {
        spoil(rig.azimuth);
        rig.tick();
        EXPECT_NE(rig.azimuth.seen.back().fields.at(Register::CommandVelocity), 0.0) << "chance";
    }
    const double elevationRate = rig.control.status().elevation.commandedRate->degrees();
    for (int tick = 3; tick < 9; ++tick) {
        spoil(rig.azimuth);
        rig.tick();
        ASSERT_TRUE(std::isnan(rig.azimuth.seen.back().fields.at(Register::CommandPosition))) << "brake where you are";
        ASSERT_EQ(rig.azimuth.seen.back().fields.at(Register::CommandVelocity), 0.0);
        EXPECT_FALSE(rig.control.faultLatched()) << tick;
    }
    EXPECT_LT(rig.control.status().elevation.commandedRate->degrees(), elevationRate) << "one axis alone goes nowhere";
    for (int tick = 0; tick < 3; ++tick) {
        spoil(rig.azimuth);
        rig.tick();
    }
    EXPECT_EQ(rig.state(), StationState::Fault);
    EXPECT_THAT(rig.alarms(), HasSubstr("The azimuth drive reports no credible position."));
    rig.azimuth.modeOnly = false;
    rig.azimuth.falsePlaces.clear();
    rig.run(Seconds(2.0));
    EXPECT_EQ(rig.state(), StationState::Fault);
    EXPECT_FALSE(rig.point(100.0, 60.0));
    ASSERT_TRUE(rig.ask(request::Rearm{}));
    rig.run(Seconds(0.5));
    EXPECT_EQ(rig.state(), StationState::Standby);
    EXPECT_TRUE(rig.control.status().azimuth.turnKnown) << "it is where it was";
}

TEST_P(BlindDrive, TwoRepliesWithoutAPlaceAreChance)
{
    FalsePlaceRig rig(100.0, 20.0);
    ASSERT_TRUE(rig.ask(request::PointAxes{{.azimuth = 190_deg, .elevation = 80_deg}}));
    for (int tick = 0; tick < 500; ++tick) {
        rig.azimuth.modeOnly = false;
        rig.azimuth.falsePlaces.clear();
        if (tick % 4 < 2) {
            spoil(rig.azimuth);
        }
        rig.tick();
    }
    rig.run(Seconds(5.0));
    EXPECT_FALSE(rig.control.faultLatched());
    EXPECT_NEAR(rig.degrees(Axis::Azimuth), 190.0, 0.01);
}

INSTANTIATE_TEST_SUITE_P(Kinds, BlindDrive, ::testing::Range(0, 4));

// REQ-SUPERVISION-13a: Supply, temperatures and torque are checked even without a position. A value that is not a
// number is unknown: it changes no trend and no comparison.
TEST(BlindDrive, SupplyAndHeatAreJudgedWithoutAPlace)
{
    FalsePlaceRig rig(100.0, 20.0);
    rig.azimuth.falsePlaces.assign(100, std::nan(""));
    rig.azimuth.voltage = 19.0;
    rig.azimuth.temperature = 65.0;
    rig.run(Seconds(0.18));
    EXPECT_THAT(rig.alarms(), HasSubstr("The supply of the azimuth fell to 19.0 V"));
    EXPECT_THAT(rig.alarms(), HasSubstr("The drive board of the azimuth reached 65 °C"));
}

// REQ-SUPERVISION-13a
TEST(BlindDrive, ValuesThatAreNoNumbersAreUnknown)
{
    FalsePlaceRig rig(100.0, 20.0);
    for (int i = 0; i < 3000; ++i) {
        const bool spoilt = i % 10 == 0;
        rig.azimuth.voltage = spoilt ? std::nan("") : 24.0;
        rig.azimuth.temperature = spoilt ? std::nan("") : 31.0;
        rig.azimuth.torque = spoilt ? std::nan("") : 1.0;
        rig.tick();
    }
    EXPECT_EQ(rig.alarms(), "");
    EXPECT_NEAR(rig.control.status().azimuth.busVoltage.value_or(0.0), 24.0, 0.1);
    rig.azimuth.voltage = std::nan("");
    rig.tick();
    EXPECT_FALSE(rig.control.status().azimuth.busVoltage);
    rig.azimuth.voltage = 19.0;
    rig.azimuth.temperature = 65.0;
    rig.run(Seconds(0.5));
    EXPECT_THAT(rig.alarms(), HasSubstr("fell to 19.0 V"));
    EXPECT_THAT(rig.alarms(), HasSubstr("reached 65 °C"));
}

// Story: from 10°/s the mount overran by 3.5°, came back, and raised a false "following error". Its set-point had been
// put back to where it was when the supply failed.
// REQ-AXES-19c (StopInMidMotion.*): A stop brakes from the present set-point and never goes back. Only an axis that
// cannot follow its set-point is held where it stands: a blocked axis, a pushed axis, or an axis that moves the wrong
// way.
TEST(StopInMidMotion, BrakesFromTheSetPoint)
{
    FalsePlaceRig rig(100.0, 20.0);
    ASSERT_TRUE(rig.ask(request::PointAxes{{.azimuth = 300_deg, .elevation = 80_deg}}));
    rig.run(Seconds(3.0));
    rig.azimuth.voltage = 11.5;
    double rate = rig.control.status().azimuth.commandedRate->degrees();
    ASSERT_NEAR(rate, 10.0, 0.01);
    while (!rig.control.faultLatched()) {
        rig.tick();
    }
    for (int tick = 0; tick < 100; ++tick) {
        const AxisStatus axis = rig.control.status().azimuth;
        EXPECT_GE(axis.commandedRate->degrees(), -1e-9) << "it never comes back";
        EXPECT_LE(rate - axis.commandedRate->degrees(), 10.0 * StationRig::kTick.count() * 1.01) << "within its ramp";
        rate = axis.commandedRate->degrees();
        rig.tick();
    }
    EXPECT_EQ(rate, 0.0);
    EXPECT_THAT(rig.alarms(), HasSubstr("The supply of the azimuth fell to 11.5 V"));
    EXPECT_THAT(rig.alarms(), ::testing::Not(HasSubstr("away from its set-point")));
}

// Story: a slip of 2° during a slew was not noticed, because the tolerance was as wide as a late reply can explain.
class SlipInASlew : public ::testing::TestWithParam<double>
{};

// REQ-AXES-19a (SlipInASlew.*)
// REQ-SUPERVISION-16 (SlipInASlew.*)
TEST_P(SlipInASlew, StopsTheMountAndMakesTheTurnUnknown)
{
    FalsePlaceRig rig(100.0, 20.0);
    ASSERT_TRUE(rig.ask(request::PointAxes{{.azimuth = 300_deg, .elevation = 80_deg}}));
    rig.run(Seconds(3.0));
    int ticks = 0;
    while (!rig.control.faultLatched() && ticks < 100) {
        rig.tickWithError(Axis::Azimuth, GetParam());
        ++ticks;
    }
    EXPECT_LE(ticks, 7);
    EXPECT_THAT(rig.alarms(), HasSubstr("jumped by " + std::to_string(static_cast<int>(GetParam()))));
    EXPECT_FALSE(rig.control.status().azimuth.turnKnown);
}

INSTANTIATE_TEST_SUITE_P(Degrees, SlipInASlew, ::testing::Values(1.0, -1.0, 2.0, -2.0, 3.6));

}  // namespace
}  // namespace boresight
