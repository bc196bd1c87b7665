// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tracking/axis_setpoints.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

using namespace boresight;
using namespace boresight::tracking;

namespace {

constexpr Seconds kTick{0.02};
const TravelRange kTravel{-90_deg, 450_deg};

MotionLimits limits(double speed, double acceleration, double jerk)
{
    return {AngularRate::fromDegrees(speed), AngularAcceleration::fromDegrees(acceleration),
            AngularJerk::fromDegrees(jerk)};
}

const MotionLimits kLimits = limits(10, 10, 100);

// Watches the set-points that are sent. Divided differences of the position are averages of rate, acceleration and jerk
// over the ticks they span, whatever the length of the ticks. So they must keep to the limits without a tolerance.
class Watch
{
public:
    explicit Watch(const AxisSetpoints& axis) { m_points.push_back({0.0, axis.setpoint().position.degrees()}); }

    void add(Seconds dt, const Setpoint& setpoint)
    {
        m_points.push_back({m_points.back().time + dt.count(), setpoint.position.degrees()});
        lowest = std::min(lowest, m_points.back().value);
        highest = std::max(highest, m_points.back().value);
        const auto rates = differences(last(4), 1.0);
        if (m_points.size() >= 4) {
            const auto accelerations = differences(rates, 2.0);
            const auto jerks = differences(accelerations, 3.0);
            speed = std::max(speed, std::abs(rates.back().value));
            acceleration = std::max(acceleration, std::abs(accelerations.back().value));
            jerk = std::max(jerk, std::abs(jerks.back().value));
        }
    }

    double lowest = 1e9;
    double highest = -1e9;
    double speed = 0.0;
    double acceleration = 0.0;
    double jerk = 0.0;

private:
    struct Point
    {
        double time;  // the first of the times it spans
        double value;
        double until = time;
    };

    [[nodiscard]] std::vector<Point> last(std::size_t count) const
    {
        return {m_points.end() - static_cast<std::ptrdiff_t>(std::min(count, m_points.size())), m_points.end()};
    }
    // `factor` turns divided differences of order n into derivatives, step by step: 1·2·3 = 3!.
    static std::vector<Point> differences(const std::vector<Point>& points, double factor)
    {
        std::vector<Point> result;
        for (std::size_t i = 1; i < points.size(); ++i) {
            const double span = points[i].until - points[i - 1].time;
            result.push_back(
                {points[i - 1].time, factor * (points[i].value - points[i - 1].value) / span, points[i].until});
        }
        return result;
    }

    std::vector<Point> m_points;
};

void expectWithin(const Watch& watch, const MotionLimits& bound)
{
    EXPECT_LE(watch.speed, bound.speed.degrees() * (1 + 1e-6));
    EXPECT_LE(watch.acceleration, bound.acceleration.degrees() * (1 + 1e-5));
    EXPECT_LE(watch.jerk, bound.jerk.degrees() * (1 + 1e-3));
}

}  // namespace

// REQ-TRACKING-03: A constant target is reached exactly, from standstill without overshoot. Then nothing moves.
TEST(AxisSetpoints, GoesThereInTheExpectedTimeAndRests)
{
    AxisSetpoints axis(kLimits, kTravel, 0_deg);
    EXPECT_TRUE(axis.atRest());
    EXPECT_NEAR(axis.filterLength().count(), 0.2, 1e-12);
    Watch watch(axis);
    double time = 0.0;
    do {
        watch.add(kTick, axis.follow(kTick, 50_deg));
        time += kTick.count();
        ASSERT_LT(time, 10.0);
    } while (!axis.atRest());
    EXPECT_EQ(axis.setpoint(), (Setpoint{50_deg, {}, {}}));
    // Distance / speed + speed / acceleration + filter: 5 + 1 + 0.2 s.
    EXPECT_NEAR(time, 6.2, 2.1 * kTick.count());
    EXPECT_LE(watch.highest, 50.0 + 1e-9);
    EXPECT_GE(watch.lowest, 0.0);
    expectWithin(watch, kLimits);
    for (int i = 0; i < 100; ++i) {
        EXPECT_EQ(axis.follow(kTick, 50_deg), (Setpoint{50_deg, {}, {}}));
    }
}

TEST(AxisSetpoints, UsesWhatTheLimitsAllow)
{
    AxisSetpoints axis(kLimits, kTravel, 0_deg);
    Watch watch(axis);
    for (int i = 0; i < 400; ++i) {
        watch.add(kTick, axis.follow(kTick, 50_deg));
    }
    EXPECT_GT(watch.speed, 9.99);
    EXPECT_GT(watch.acceleration, 9.5);
    EXPECT_GT(watch.jerk, 45.0);  // a ramp from rest takes the filter length: half the limit
}

// REQ-TRACKING-05a: Braking harder than the limits is possible on request, and the averaging still bounds the jerk. It
// takes speed / deceleration + 2 × acceleration / jerk.
TEST(AxisSetpoints, BrakesHarderWhereItIsAskedTo)
{
    AxisSetpoints axis(kLimits, kTravel, 0_deg);
    for (int i = 0; i < 100; ++i) {
        axis.run(kTick, 10_deg_s);
    }
    const Angle from = axis.setpoint().position;
    Watch watch(axis);
    int ticks = 0;
    for (; !axis.atRest(); ++ticks) {
        watch.add(kTick, axis.brake(kTick, AngularAcceleration::fromDegrees(125.0)));
        ASSERT_LT(ticks, 100);
    }
    // Speed / deceleration + filter: 0.08 + 0.2 s, at half of full speed on average.
    EXPECT_NEAR(ticks * kTick.count(), 0.28, 1.1 * kTick.count());
    EXPECT_NEAR((axis.setpoint().position - from).degrees(), 1.4, 0.01);
    EXPECT_LE(watch.acceleration, 50.0 + 1e-6) << "the averaging spreads it over 0.2 s";
    EXPECT_LE(watch.highest, from.degrees() + 1.41);
}

TEST(AxisSetpoints, AWeakerBrakeThanTheLimitsIsTheirs)
{
    AxisSetpoints asked(kLimits, kTravel, 0_deg);
    AxisSetpoints own(kLimits, kTravel, 0_deg);
    for (int i = 0; i < 50; ++i) {
        asked.run(kTick, 5_deg_s);
        own.run(kTick, 5_deg_s);
    }
    for (int i = 0; i < 100; ++i) {
        EXPECT_EQ(asked.brake(kTick, AngularAcceleration::fromDegrees(1.0)), own.brake(kTick));
    }
}

// REQ-TRACKING-06: The rate of a set-point is the rate of its positions.
TEST(AxisSetpoints, TheRateSentIsThatOfTheSetpoints)
{
    AxisSetpoints axis(kLimits, kTravel, 0_deg);
    double before = 0.0;
    double rateBefore = 0.0;
    for (int i = 0; i < 400; ++i) {
        const Setpoint setpoint = axis.follow(kTick, 30_deg);
        const double moved = (setpoint.position.degrees() - before) / kTick.count();
        EXPECT_NEAR(moved, 0.5 * (rateBefore + setpoint.rate.degrees()), 0.01);  // jerk × tick² / 12 is 0.003
        before = setpoint.position.degrees();
        rateBefore = setpoint.rate.degrees();
    }
}

// REQ-TRACKING-04: A steadily moving target is tracked without lag, an 80° LEO pass within 0.01° in azimuth.
TEST(AxisSetpoints, FollowsASteadyTargetWithoutLag)
{
    AxisSetpoints axis(kLimits, kTravel, 0_deg);
    double target = 20.0;
    for (int i = 0; i < 400; ++i) {
        target += 1.3 * kTick.count();
        axis.follow(kTick, Angle::fromDegrees(target), 1.3_deg_s);
    }
    for (int i = 0; i < 100; ++i) {
        target += 1.3 * kTick.count();
        const Setpoint setpoint = axis.follow(kTick, Angle::fromDegrees(target), 1.3_deg_s);
        EXPECT_NEAR(setpoint.position.degrees(), target, 1e-9);
        EXPECT_NEAR(setpoint.rate.degrees(), 1.3, 1e-9);
    }
}

// The azimuth of a straight pass at 7.4 km/s: 80° maximum elevation, 420 km high. Its peak rate is 5.8°/s.
// REQ-TRACKING-04
TEST(AxisSetpoints, FollowsALeoPassWithinAHundredthOfADegree)
{
    const double perSecond = 7.4 / (420.0 * std::tan(10.0 * std::numbers::pi / 180.0));
    AxisSetpoints axis(kLimits, kTravel, 90_deg);
    for (double time = -300.0; time < 300.0; time += kTick.count()) {
        const Angle target = 180_deg + Angle::fromRadians(std::atan(perSecond * time));
        const AngularRate rate = AngularRate::fromRadians(perSecond / (1.0 + std::pow(perSecond * time, 2)));
        const Setpoint setpoint = axis.follow(kTick, target, rate);
        if (time > -290.0) {
            ASSERT_NEAR(setpoint.position.degrees(), target.degrees(), 0.01) << time;
            ASSERT_NEAR(setpoint.rate.degrees(), rate.degrees(), 0.05) << time;
        }
    }
}

// REQ-TRACKING-05: A stop takes speed / acceleration + 2 × acceleration / jerk.
TEST(AxisSetpoints, BrakesToRestAsFastAsTheLimitsAllow)
{
    AxisSetpoints axis(kLimits, kTravel, 0_deg);
    Watch watch(axis);
    for (int i = 0; i < 100; ++i) {
        watch.add(kTick, axis.run(kTick, 1_deg_s));
    }
    EXPECT_NEAR(axis.setpoint().rate.degrees(), 1.0, 1e-9);
    double time = 0.0;
    while (!axis.atRest()) {
        watch.add(kTick, axis.brake(kTick));
        time += kTick.count();
        ASSERT_LT(time, 1.0);
    }
    EXPECT_LE(time, 0.3 + kTick.count());  // 1 °/s / 10 °/s² + 0.2 s
    expectWithin(watch, kLimits);
    const Angle rest = axis.setpoint().position;
    axis.brake(kTick);
    EXPECT_EQ(axis.setpoint().position, rest);
}

// REQ-TRACKING-02: A set-point never leaves the travel. It brakes before the end, also when jogging, when following a
// moving target, or after limits or travel were narrowed during a motion.
TEST(AxisSetpoints, RunsIntoTheEndOfTheTravelAndRestsExactlyThere)
{
    for (const double rate : {-25.0, -10.0, -0.3, 0.3, 10.0, 25.0}) {
        AxisSetpoints axis(kLimits, {-20_deg, 20_deg}, 0_deg);
        Watch watch(axis);
        for (int i = 0; i < 5000; ++i) {
            watch.add(kTick, axis.run(kTick, AngularRate::fromDegrees(rate)));
        }
        EXPECT_TRUE(axis.atRest());
        EXPECT_NEAR(axis.setpoint().position.degrees(), rate > 0 ? 20 : -20, 1e-9);
        EXPECT_LE(watch.highest, 20 + 1e-9);
        EXPECT_GE(watch.lowest, -20 - 1e-9);
        EXPECT_LE(watch.speed, std::min(10.0, std::abs(rate)) + 1e-6);
        expectWithin(watch, kLimits);
    }
}

// REQ-TRACKING-02
TEST(AxisSetpoints, AMovingTargetDoesNotPullItBeyondTheTravel)
{
    AxisSetpoints axis(kLimits, {-20_deg, 20_deg}, 0_deg);
    Watch watch(axis);
    for (int i = 0; i < 1000; ++i) {
        const double target = -30.0 + 9.0 * i * kTick.count();
        watch.add(kTick, axis.follow(kTick, Angle::fromDegrees(target), 9_deg_s));
    }
    EXPECT_LE(watch.highest, 20 + 1e-9);
    EXPECT_NEAR(axis.setpoint().position.degrees(), 20, 1e-9);
    expectWithin(watch, kLimits);
}

// REQ-TRACKING-08: An axis outside its travel is held there. Only inward motion is possible.
TEST(AxisSetpoints, OutsideTheTravelItIsHeldAndComesBackOnlyWhenTold)
{
    AxisSetpoints axis(kLimits, {-20_deg, 20_deg}, 25_deg);
    for (int i = 0; i < 100; ++i) {
        EXPECT_EQ(axis.brake(kTick).position, 25_deg);
        EXPECT_EQ(axis.run(kTick, 5_deg_s).position, 25_deg);
    }
    Watch watch(axis);
    for (int i = 0; i < 100; ++i) {
        watch.add(kTick, axis.run(kTick, -1_deg_s));
    }
    EXPECT_NEAR(axis.setpoint().position.degrees(), 25 - 1.0 * (2.0 - 0.05 - 0.1), 1e-6);
    for (int i = 0; i < 500; ++i) {
        watch.add(kTick, axis.follow(kTick, 30_deg));
    }
    EXPECT_NEAR(axis.setpoint().position.degrees(), 20, 1e-9);
    expectWithin(watch, kLimits);
}

// All at random moments: targets, moving targets, jogs and stops, with ticks of 10…100 ms.
// REQ-TRACKING-01: No set-point ever exceeds speed, acceleration or jerk, whatever is requested at any time, with ticks
// of 10…100 ms.
TEST(AxisSetpoints, KeepsEveryLimitWhateverIsAsked)
{
    for (unsigned seed = 0; seed < 40; ++seed) {
        std::mt19937 random(seed);
        std::uniform_real_distribution<double> unit(0.0, 1.0);
        const MotionLimits bound = limits(1 + 20 * unit(random), 2 + 30 * unit(random), 20 + 600 * unit(random));
        AxisSetpoints axis(bound, {-20_deg, 60_deg}, 10_deg);
        Watch watch(axis);
        double target = 0.0;
        double rate = 0.0;
        int kind = 0;
        for (int i = 0; i < 5000; ++i) {
            const Seconds dt(seed % 2 == 0 ? 0.02 : 0.01 + 0.09 * unit(random));
            if (unit(random) < 0.03) {
                kind = static_cast<int>(3 * unit(random));
                target = -60 + 160 * unit(random);
                rate = -15 + 30 * unit(random);
            }
            target += kind == 1 ? rate * dt.count() : 0.0;
            const AngularRate wanted = AngularRate::fromDegrees(kind == 0 ? 0.0 : rate);
            watch.add(dt, kind < 2 ? axis.follow(dt, Angle::fromDegrees(target), wanted) : axis.run(dt, wanted));
        }
        EXPECT_LE(watch.highest, 60 + 1e-9) << seed;
        EXPECT_GE(watch.lowest, -20 - 1e-9) << seed;
        expectWithin(watch, bound);
    }
}

// REQ-TRACKING-400: At any moment the time to reach a position is known. If the axis is to arrive later than that, it
// moves more slowly, within every limit, and arrives at the wanted time.
TEST(AxisSetpoints, ArrivesWhenItIsTold)
{
    std::mt19937 random(17);
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    for (int k = 0; k < 200; ++k) {
        const MotionLimits bound = limits(1 + 15 * unit(random), 2 + 20 * unit(random), 40 + 300 * unit(random));
        AxisSetpoints axis(bound, kTravel, Angle::fromDegrees(200 * unit(random)));
        Watch watch(axis);
        const Angle before = Angle::fromDegrees(200 * unit(random));
        for (int i = 0; i < 500 * unit(random); ++i) {
            watch.add(kTick, axis.follow(kTick, before));
        }
        const Angle target = Angle::fromDegrees(200 * unit(random));
        const Seconds wanted = axis.restTime(target) * (k % 4 == 0 ? 1.0 : 1.0 + 3.0 * unit(random));
        Seconds time{0.0};
        for (; time == Seconds(0.0) || !axis.atRest(); time += kTick) {
            ASSERT_LT(time, wanted + Seconds(1.0)) << k;
            watch.add(kTick, axis.arrive(kTick, target, wanted - time));
        }
        EXPECT_EQ(axis.setpoint().position, target);
        EXPECT_NEAR(time.count(), wanted.count(), 2.5 * kTick.count()) << k;
        expectWithin(watch, bound);
    }
}

// REQ-TRACKING-03
TEST(AxisSetpoints, NeverOvershootsAConstantTarget)
{
    std::mt19937 random(7);
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    for (int k = 0; k < 300; ++k) {
        AxisSetpoints axis(limits(0.5 + 15 * unit(random), 1 + 20 * unit(random), 30 + 300 * unit(random)), kTravel,
                           100_deg);
        const double target = 100 + 20 * (unit(random) - 0.5) * unit(random);
        Watch watch(axis);
        for (int i = 0; i < 100000 && (i == 0 || !axis.atRest()); ++i) {
            const Seconds dt(0.01 + 0.09 * unit(random));
            watch.add(dt, axis.follow(dt, Angle::fromDegrees(target)));
        }
        ASSERT_EQ(axis.setpoint().position, Angle::fromDegrees(target));
        ASSERT_LE(watch.highest, std::max(100.0, target) + 1e-9);
        ASSERT_GE(watch.lowest, std::min(100.0, target) - 1e-9);
    }
}

// The length of the ticks only decides when the motion is sampled, not where it goes.
TEST(AxisSetpoints, DoesNotDependOnTheTicks)
{
    AxisSetpoints even(kLimits, kTravel, 0_deg);
    AxisSetpoints uneven(kLimits, kTravel, 0_deg);
    std::mt19937 random(8);
    std::uniform_int_distribution<int> ticks(1, 9);
    for (int done = 0; done < 400;) {
        const int count = ticks(random);
        for (int i = 0; i < count; ++i) {
            even.follow(kTick, 37_deg);
        }
        uneven.follow(count * kTick, 37_deg);
        done += count;
        ASSERT_NEAR(even.setpoint().position.degrees(), uneven.setpoint().position.degrees(), 1e-9);
    }
    const Setpoint before = even.setpoint();
    EXPECT_EQ(even.follow(Seconds(0.0), 10_deg), before);
    EXPECT_EQ(even.run(Seconds(-0.1), 10_deg_s), before);
}

// REQ-TRACKING-07: New limits apply from the next tick on. A longer or shorter filter waits until the axis stands
// still.
TEST(AxisSetpoints, NewLimitsInFlight)
{
    AxisSetpoints axis(limits(10, 10, 100), kTravel, 0_deg);
    Watch before(axis);
    for (int i = 0; i < 150; ++i) {
        before.add(kTick, axis.follow(kTick, 400_deg));
    }
    // a filter of 0.4 s is wanted, 0.2 s is in use: acceleration 2.5 until standstill
    axis.setLimits(limits(4, 5, 25));
    EXPECT_NEAR(axis.filterLength().count(), 0.2, 1e-12);
    for (int i = 0; i < 200; ++i) {
        before.add(kTick, axis.follow(kTick, 400_deg));
    }
    expectWithin(before, limits(10, 10, 100));
    Watch after(axis);
    for (int i = 0; i < 200; ++i) {
        after.add(kTick, axis.follow(kTick, i < 50 ? 400_deg : 0_deg));
    }
    expectWithin(after, limits(4, 2.5, 25));
    while (!axis.atRest()) {
        axis.brake(kTick);
    }
    axis.setLimits(limits(4, 5, 25));
    EXPECT_NEAR(axis.filterLength().count(), 0.4, 1e-12);
}

// Story: with half the acceleration the stopping distance doubles, but the end of the travel stays where it is.
// REQ-TRACKING-02
TEST(AxisSetpoints, TheTravelHoldsWhenLimitsOrTravelAreNarrowedInFlight)
{
    AxisSetpoints axis(kLimits, {-20_deg, 20_deg}, -20_deg);
    Watch watch(axis);
    while (axis.setpoint().position < 13_deg) {
        watch.add(kTick, axis.run(kTick, 10_deg_s));
    }
    axis.setLimits(limits(10, 2, 100));
    for (int i = 0; i < 1000; ++i) {
        watch.add(kTick, axis.run(kTick, 10_deg_s));
    }
    EXPECT_LE(watch.highest, 20 + 1e-9);
    EXPECT_NEAR(axis.setpoint().position.degrees(), 20, 1e-6);

    while (axis.setpoint().position > 0_deg) {
        axis.run(kTick, -10_deg_s);
    }
    axis.setTravel({-3_deg, 20_deg});
    for (int i = 0; i < 1000; ++i) {
        ASSERT_GE(axis.brake(kTick).position, -3_deg - 1e-9_deg);
    }
    EXPECT_TRUE(axis.atRest());
}

TEST(AxisSetpoints, ResetForgetsTheMotion)
{
    AxisSetpoints axis(kLimits, kTravel, 0_deg);
    for (int i = 0; i < 100; ++i) {
        axis.run(kTick, 10_deg_s);
    }
    axis.reset(33_deg);
    EXPECT_TRUE(axis.atRest());
    EXPECT_EQ(axis.setpoint(), (Setpoint{33_deg, {}, {}}));
    EXPECT_EQ(axis.brake(kTick), (Setpoint{33_deg, {}, {}}));
}

// The protection of a motion relies on this: every position that a braking axis still passes is known in advance.
// REQ-TRACKING-07a: The positions that a braking axis still passes are known in advance.
TEST(AxisSetpoints, TellsAllThatItStillPassesUntilRest)
{
    std::mt19937 random(42);
    const auto uniform = [&random](double from, double to) {
        return std::uniform_real_distribution<double>(from, to)(random);
    };
    for (int round = 0; round < 300; ++round) {
        AxisSetpoints axis(limits(uniform(1, 20), uniform(2, 30), uniform(10, 300)), kTravel, 100_deg);
        for (int change = 0; change < 5; ++change) {
            const AngularRate rate = AngularRate::fromDegrees(uniform(-20, 20));
            for (int i = 0, count = static_cast<int>(uniform(1, 60)); i < count; ++i) {
                axis.run(kTick, rate);
            }
        }
        const TravelRange rest = axis.untilRest();
        while (!axis.atRest()) {
            const Angle place = axis.brake(kTick).position;
            EXPECT_GE(place.degrees(), rest.min.degrees() - 1e-9);
            EXPECT_LE(place.degrees(), rest.max.degrees() + 1e-9);
        }
    }
}
