// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/rotator_box/switched_axis.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace boresight::gs232 {
namespace {

using tracking::Leeway;

// An axis of whole degrees at 100°, as its box reports it four times a second.
class SwitchedAxisTest : public testing::Test
{
protected:
    SwitchedAxisTest()
    {
        axis.see(100_deg, now);
        axis.begin();
    }
    void see(Angle place)
    {
        now += std::chrono::milliseconds(250);
        axis.see(place, now);
    }
    // Until it is seen to stand.
    void rest(Angle place)
    {
        for (int i = 0; i < 6; ++i) {
            see(place);
        }
    }
    static Leeway exact(Angle rest) { return {.within = {.min = 0_deg, .max = 450_deg}, .rest = rest}; }
    // Of a target that moves clockwise, followed by a beam of 10°.
    static Leeway following(Angle rest)
    {
        return {.within = {.min = 0_deg, .max = 450_deg},
                .rest = rest,
                .band = 2_deg,
                .lead = 2_deg,
                .follows = true,
                .halfBeam = 5_deg};
    }
    std::optional<Angle> send(const Leeway& leeway)
    {
        const auto target = axis.next(leeway, now);
        if (target) {
            axis.sent(*target, now);
        }
        return target;
    }
    [[nodiscard]] std::uint64_t starts() const { return axis.starts(now).total; }

    SteadyTime now = SteadyTime{} + std::chrono::hours(1);
    SwitchedAxis::Habits habits{.step = 1_deg, .count = 1_deg};
    SwitchedAxis axis{habits};
};

// An axis whose motor goes on by its coast at its own speed. The box reports whole degrees, and switches the motor off
// at the degree of its target.
class CoastingAxis
{
public:
    CoastingAxis(double coast, double speed)
        : m_speed(speed), m_coast(coast), m_axis({.step = 1_deg, .count = 1_deg, .coast = Angle::fromDegrees(coast)})
    {
        m_axis.see(100_deg, m_now);
        m_axis.begin();
    }

    void run(Angle aim, Seconds time)
    {
        constexpr Seconds kPart{0.01};
        const Leeway exact{.within = {.min = 0_deg, .max = 450_deg}, .rest = aim};
        if (const auto target = m_axis.next(exact, m_now)) {
            m_axis.sent(*target, m_now);
            const double way = target->degrees() - shown();
            m_starts += way != 0.0 && (m_left == 0.0 || !m_target) ? 1 : 0;
            m_way = way < 0.0 ? -1.0 : 1.0;
            m_target = way != 0.0 ? std::optional(target->degrees()) : std::nullopt;
        }
        for (Seconds left = time; left > Seconds(0.0); left -= kPart) {
            move(m_speed * kPart.count());
        }
        m_now += std::chrono::duration_cast<SteadyTime::duration>(time);
        m_axis.see(Angle::fromDegrees(shown()), m_now);
    }
    [[nodiscard]] double truth() const { return m_place; }
    [[nodiscard]] int starts() const { return m_starts; }

private:
    [[nodiscard]] double shown() const { return std::round(m_place); }
    void move(double way)
    {
        if (m_target) {
            m_place += m_way * way;
            m_left = m_coast;
            if (m_way * (shown() - *m_target) >= 0.0) {
                m_target.reset();
            }
        } else if (m_left > 0.0) {
            m_place += m_way * std::min(way, m_left);
            m_left = std::max(m_left - way, 0.0);
        }
    }

    SteadyTime m_now = SteadyTime{} + std::chrono::hours(1);
    double m_speed;
    double m_coast;
    double m_place = 100.0;
    double m_way = 1.0;
    double m_left = 0.0;             // of its coast
    std::optional<double> m_target;  // while the motor runs
    int m_starts = 0;
    SwitchedAxis m_axis;
};

// REQ-GS232-32: While a target is followed, an axis stands until its set-point is farther away than the dead-band. Then
// it is sent as far beyond. Otherwise it is sent to each step.
TEST_F(SwitchedAxisTest, StandsWithinTheBandAndIsSentAhead)
{
    EXPECT_FALSE(send(following(Angle::fromDegrees(101.9))));
    EXPECT_EQ(send(following(102_deg)), 104_deg);
    rest(104_deg);
    EXPECT_FALSE(send(following(Angle::fromDegrees(105.9))));
    EXPECT_EQ(starts(), 1U);
    EXPECT_EQ(send(exact(Angle::fromDegrees(105.9))), 106_deg);
    EXPECT_EQ(starts(), 2U);
}

TEST_F(SwitchedAxisTest, AMotorThatRunsIsSentOnWithoutAStart)
{
    for (int degree = 105; degree < 140; ++degree) {
        EXPECT_EQ(send(exact(Angle::fromDegrees(degree))), Angle::fromDegrees(degree)) << degree;
        see(Angle::fromDegrees(degree - 4));
    }
    EXPECT_EQ(starts(), 1U);
}

// A command for the other axis would stop it.
TEST_F(SwitchedAxisTest, ASlowMotorIsNotTakenForOneThatStands)
{
    (void)send(exact(110_deg));
    for (int i = 0; i < 96; ++i) {
        see(Angle::fromDegrees(100 + i / 12));  // 0.33 °/s
        EXPECT_EQ(axis.unchanged(), 110_deg);
    }
    EXPECT_EQ(starts(), 1U);
}

TEST_F(SwitchedAxisTest, AReversalIsAStart)
{
    (void)send(exact(110_deg));
    see(103_deg);
    EXPECT_EQ(send(exact(101_deg)), 101_deg);
    EXPECT_EQ(starts(), 2U);
}

// REQ-GS232-33: What is sent is inside the leeway, also where the next step is beyond a fractional edge.
TEST_F(SwitchedAxisTest, IsNotRoundedBeyondItsLeeway)
{
    Leeway leeway = exact(Angle::fromDegrees(110.6));
    leeway.within = {.min = 100_deg, .max = Angle::fromDegrees(110.7)};
    EXPECT_EQ(send(leeway), 110_deg);
    leeway.rest = Angle::fromDegrees(100.4);
    leeway.within = {.min = Angle::fromDegrees(100.3), .max = 110_deg};
    EXPECT_EQ(send(leeway), 101_deg);
    leeway = following(109_deg);
    leeway.within.max = Angle::fromDegrees(109.5);
    rest(101_deg);
    EXPECT_EQ(send(leeway), 109_deg);
}

TEST_F(SwitchedAxisTest, IsNotSentFarFromWhereItIs)
{
    EXPECT_EQ(send(exact(200_deg)), 112_deg);
}

// REQ-GS232-34: A potentiometer that reports three neighbouring counts starts no motor, and moves no axis.
TEST_F(SwitchedAxisTest, NoiseStartsNothing)
{
    (void)send(exact(110_deg));
    rest(110_deg);
    for (const double noise : {1.0, -1.0, 0.0, -1.0, 1.0, 1.0, -1.0, 0.0}) {
        see(Angle::fromDegrees(110.0 + noise));
        EXPECT_FALSE(send(exact(110_deg)));
        EXPECT_FALSE(send(following(Angle::fromDegrees(111.9))));
        EXPECT_FALSE(axis.coasts());
        EXPECT_EQ(axis.unchanged(), 110_deg) << "a command for the other axis does not start this one";
    }
    EXPECT_EQ(starts(), 1U);
}

// REQ-GS232-35: The limit of starts makes tracking coarser. It delays no axis that has to be exact, as in a slew and
// beside a keep-out, and none that runs.
TEST_F(SwitchedAxisTest, TheLimitMakesTrackingCoarser)
{
    habits.mostStarts = 2;
    axis.setHabits(habits);
    EXPECT_EQ(send(following(103_deg)), 105_deg);
    rest(105_deg);
    EXPECT_FALSE(send(following(108_deg)));
    EXPECT_TRUE(axis.spared());
    EXPECT_EQ(send(exact(108_deg)), 108_deg) << "the end of a motion";
    EXPECT_FALSE(axis.spared());
    see(106_deg);
    EXPECT_EQ(send(following(101_deg)), 103_deg) << "it runs away from its target";
    rest(103_deg);
    EXPECT_EQ(axis.starts(now).lastMinute, 3);
    EXPECT_FALSE(send(following(110_deg)));
    now += std::chrono::minutes(1);
    EXPECT_EQ(axis.starts(now).lastMinute, 0);
    EXPECT_EQ(send(following(112_deg)), 114_deg);
}

// REQ-GS232-36: How far an axis coasts beyond its targets is measured, and its motor is switched off so much
// earlier.
TEST_F(SwitchedAxisTest, StopsEarlierByItsCoast)
{
    EXPECT_FALSE(axis.starts(now).coast);
    EXPECT_EQ(send(exact(110_deg)), 110_deg);
    see(108_deg);
    see(111_deg);
    rest(112_deg);
    ASSERT_TRUE(axis.starts(now).coast);
    EXPECT_NEAR(axis.starts(now).coast->degrees(), 2.0, 1e-9);
    EXPECT_EQ(send(exact(120_deg)), 118_deg);
    see(118_deg);
    EXPECT_TRUE(axis.coasts());
    rest(120_deg);
    EXPECT_EQ(axis.unchanged(), 120_deg);
    EXPECT_FALSE(send(exact(120_deg)));
    EXPECT_EQ(starts(), 2U);
    habits.coast = 1_deg;
    axis.setHabits(habits);
    EXPECT_EQ(send(exact(110_deg)), 111_deg) << "as the profile says";
}

// Story: within a step of the earlier stop, the full target was sent after all. It started the motor again, and the
// axis ended beyond it by its coast.
TEST(SwitchedAxisCoast, EndsEachWayAtItsAimWithOneStart)
{
    constexpr Seconds kReading{0.25};
    for (const double coast : {1.0, 2.0}) {
        for (const int degrees : {5, 6, 7, 8, 9, 10, 11, 12, -5, -8, -12}) {
            for (const double speed : {1.0, 2.0, 3.0, 4.0, 5.0, 6.0}) {
                CoastingAxis axis(coast, speed);
                const Angle aim = Angle::fromDegrees(100 + degrees);
                for (Seconds time{}; time < Seconds(25.0); time += kReading) {
                    axis.run(aim, kReading);
                }
                EXPECT_NEAR(axis.truth(), aim.degrees(), 1.0) << coast << " " << degrees << " " << speed;
                EXPECT_EQ(axis.starts(), 1) << coast << " " << degrees << " " << speed;
            }
        }
    }
}

// REQ-GS232-68: A limit that is tightened calls back an axis whose lead is beyond it, whether it runs or stands.
TEST_F(SwitchedAxisTest, ATightenedLimitCallsItBack)
{
    ASSERT_EQ(send(following(102_deg)), 104_deg);
    see(101_deg);
    Leeway tightened = following(102_deg);
    tightened.within.max = 103_deg;
    EXPECT_EQ(send(tightened), 103_deg);
    rest(103_deg);
    EXPECT_FALSE(send(tightened));
    tightened.within.max = 102_deg;
    EXPECT_EQ(send(tightened), 102_deg);
    EXPECT_EQ(starts(), 2U);
    rest(102_deg);
    EXPECT_FALSE(send(tightened));
}

TEST_F(SwitchedAxisTest, AfterAStopNothingIsLeft)
{
    (void)send(exact(110_deg));
    see(104_deg);
    axis.stopped(now);
    rest(106_deg);
    EXPECT_FALSE(axis.target());
    EXPECT_EQ(axis.unchanged(), 106_deg);
    axis.begin();
    EXPECT_FALSE(send(exact(106_deg)));
    EXPECT_FALSE(axis.starts(now).coast) << "nobody knows when its relay opened";
}

}  // namespace
}  // namespace boresight::gs232
