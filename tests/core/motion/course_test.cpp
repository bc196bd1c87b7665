// SPDX-License-Identifier: GPL-3.0-or-later
// The predicted course of a motion compared with the motion itself.
#include "core/motion/course.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace boresight {
namespace {

constexpr std::chrono::milliseconds kCourseTick{20};

AxisPosition courseAt(double azimuth, double elevation)
{
    return {.azimuth = Angle::fromDegrees(azimuth), .elevation = Angle::fromDegrees(elevation)};
}

profile::Profile courseMount(const pointing::Region& limits = {})
{
    profile::Profile profile;
    profile.limits = limits;
    return profile;
}

pointing::Region behindAMast(Angle top = 40_deg)
{
    return {.keepOuts = {{.name = "mast",
                          .azimuthFrom = 300_deg,
                          .azimuthTo = 330_deg,
                          .elevationMin = 0_deg,
                          .elevationMax = top}}};
}

class CourseRide
{
public:
    CourseRide(const profile::Profile& profile, const AxisPosition& start) : motion(profile)
    {
        motion.start(Axis::Azimuth, start.azimuth);
        motion.start(Axis::Elevation, start.elevation);
    }

    void tick()
    {
        now += kCourseTick;
        motion.advance(now, kCourseTick);
    }

    void run(Seconds time)
    {
        for (const SteadyTime end = now + std::chrono::round<SteadyTime::duration>(time); now < end;) {
            tick();
        }
    }

    // Runs until both axes stand still at the place. Returns when each of them stopped for good.
    std::array<Seconds, 2> arrive(const AxisPosition& place)
    {
        const SteadyTime began = now;
        std::array<Seconds, 2> rested{};
        std::array<Angle, 2> last{motion.place().azimuth, motion.place().elevation};
        for (int left = 50000; left > 0 && !(motion.atRest() && motion.place() == place); --left) {
            tick();
            const std::array<Angle, 2> here{motion.place().azimuth, motion.place().elevation};
            for (const Axis axis : kAxes) {
                if (abs(here[index(axis)] - last[index(axis)]) > Angle::fromDegrees(1e-7)) {
                    rested[index(axis)] = now - began;
                }
            }
            last = here;
        }
        EXPECT_EQ(motion.place(), place);
        return rested;
    }

    Motion motion;
    SteadyTime now{};
};

// From here on the predicted time and positions must come true.
void expectForetold(CourseRide& drive, const AxisPosition& place)
{
    const auto course = Course::of(drive.motion, drive.now);
    ASSERT_TRUE(course);
    EXPECT_EQ(course->end(), place);
    CourseRide copy = drive;
    const SteadyTime began = copy.now;
    Angle off;
    while (copy.now - began < course->duration()) {
        copy.tick();
        const AxisPosition then = course->at(copy.now - began);
        off = std::max({off, abs(then.azimuth - copy.motion.place().azimuth),
                        abs(then.elevation - copy.motion.place().elevation)});
    }
    EXPECT_LT(off.degrees(), 0.6);
    const auto rested = drive.arrive(place);
    const Seconds time = std::max(rested[0], rested[1]);
    EXPECT_NEAR(course->duration().count(), time.count(), std::max(0.1, 0.02 * time.count()));
}

// REQ-AXES-400 (CourseTest.*): The duration of a slew and the positions of the axes during it are computed from the
// plan itself: route, speed, acceleration, jerk and limits. They are right within 2 % or 0.1 s, and within 0.6°.
TEST(CourseTest, ADirectWay)
{
    for (const AxisPosition& place : {courseAt(113, 10), courseAt(0.5, 80), courseAt(-90, 0), courseAt(450, 90)}) {
        CourseRide drive(courseMount(), courseAt(0, 0));
        drive.motion.goTo(place);
        expectForetold(drive, place);
    }
}

TEST(CourseTest, AWayAroundAKeepOut)
{
    CourseRide drive(courseMount(behindAMast()), courseAt(290, 10));
    drive.motion.goTo(courseAt(340, 5));
    const auto course = Course::of(drive.motion, drive.now);
    ASSERT_TRUE(course);
    const auto way = course->rest(Seconds(0.0), 1_deg);
    const auto highest = std::ranges::max(way, {}, &AxisPosition::elevation);
    EXPECT_NEAR(highest.elevation.degrees(), 40.0, 0.1) << "over the mast";
    EXPECT_GT(way.size(), 50U) << "fine enough to be drawn";
    expectForetold(drive, courseAt(340, 5));
}

// Story: the direct distance is 4°, and the route is 170°.
TEST(CourseTest, AWayThatIsMuchLongerThanItsEndIsFar)
{
    CourseRide drive(courseMount(behindAMast(85_deg)), courseAt(299, 2));
    drive.motion.goTo(courseAt(331, 1));
    expectForetold(drive, courseAt(331, 1));
}

TEST(CourseTest, FromTheMiddleOfAnotherMotion)
{
    std::mt19937 random(11);
    std::uniform_real_distribution<double> azimuth(-90.0, 450.0);
    std::uniform_real_distribution<double> elevation(0.0, 90.0);
    std::uniform_real_distribution<double> time(0.0, 20.0);
    for (int i = 0; i < 10; ++i) {
        CourseRide drive(courseMount(), courseAt(azimuth(random), elevation(random)));
        drive.motion.goTo(courseAt(azimuth(random), elevation(random)));
        drive.run(Seconds(time(random)));
        const AxisPosition place = courseAt(azimuth(random), elevation(random));
        drive.motion.goTo(place);
        expectForetold(drive, place);
    }
}

TEST(CourseTest, ARotatorThatRunsByItselfGoesAlong)
{
    Capabilities can;
    can.axes.fill(AxisCapabilities{.step = 1_deg, .miss = 2_deg});
    Motion motion(courseMount(behindAMast()), can);
    motion.start(Axis::Azimuth, 290_deg);
    motion.start(Axis::Elevation, 20_deg);
    motion.goTo(courseAt(340, 20));
    motion.setSeen(courseAt(290, 20));
    EXPECT_TRUE(Course::of(motion, SteadyTime{}));
}

TEST(CourseTest, NobodyKnowsWhenAMotionEndsThatGoesNowhere)
{
    CourseRide drive(courseMount(), courseAt(0, 0));
    EXPECT_FALSE(Course::of(drive.motion, drive.now));
    drive.motion.run({.azimuth = 5_deg_s});
    EXPECT_FALSE(Course::of(drive.motion, drive.now));
    CourseRide walled(courseMount(behindAMast(90_deg)), courseAt(290, 10));
    walled.motion.goTo(courseAt(340, 10));
    EXPECT_FALSE(Course::of(walled.motion, walled.now)) << "There is no way";
}

// A moving target is reached, if it continues straight.
TEST(CourseTest, AStreamIsMet)
{
    CourseRide drive(courseMount(), courseAt(300, 30));
    double azimuth = 60.0;
    for (int second = 0; second < 8; ++second) {
        drive.motion.follow(courseAt(azimuth += 0.5, 30), drive.now);
        drive.run(Seconds(1.0));
    }
    ASSERT_TRUE(drive.motion.streaming(drive.now));
    const auto course = Course::of(drive.motion, drive.now);
    ASSERT_TRUE(course);
    const SteadyTime began = drive.now;
    const auto met = [&] {
        const auto target = drive.motion.target(drive.now);
        return abs(target->azimuth - drive.motion.place().azimuth) < Course::kMet;
    };
    while (!met()) {
        drive.motion.follow(courseAt(azimuth += 0.5, 30), drive.now);
        for (int i = 0; i < 50 && !met(); ++i) {
            drive.tick();
        }
    }
    EXPECT_NEAR(course->duration().count(), Seconds(drive.now - began).count(), 0.5);
}

// REQ-AXES-401 (ArrivalTest.*): If chosen, the faster axis is slowed in a slew so that both axes arrive at the same
// time. The slew does not take longer. Around a keep-out this applies to the last leg.
profile::Profile together(const pointing::Region& limits = {})
{
    profile::Profile profile = courseMount(limits);
    profile.control.arrival = profile::Arrival::Together;
    return profile;
}

TEST(ArrivalTest, EachAxisArrivesAsSoonAsItCanUnlessItIsChosen)
{
    CourseRide drive(courseMount(), courseAt(0, 0));
    drive.motion.goTo(courseAt(170, 20));
    const auto rested = drive.arrive(courseAt(170, 20));
    EXPECT_GT(rested[0] - rested[1], Seconds(10.0));
}

TEST(ArrivalTest, BothAxesRestAtTheSameTime)
{
    for (const AxisPosition& place :
         {courseAt(170, 20), courseAt(3, 80), courseAt(-90, 90), courseAt(1, 0.2), courseAt(400, 0.1)}) {
        CourseRide apart(courseMount(), courseAt(0, 0));
        apart.motion.goTo(place);
        const auto alone = apart.arrive(place);
        CourseRide drive(together(), courseAt(0, 0));
        drive.motion.goTo(place);
        const auto rested = drive.arrive(place);
        EXPECT_NEAR(rested[0].count(), rested[1].count(), 0.25) << place.azimuth.degrees();
        EXPECT_NEAR(std::max(rested[0], rested[1]).count(), std::max(alone[0], alone[1]).count(), 0.05);
    }
}

TEST(ArrivalTest, FromTheMiddleOfAnotherMotion)
{
    std::mt19937 random(5);
    std::uniform_real_distribution<double> azimuth(-90.0, 450.0);
    std::uniform_real_distribution<double> elevation(0.0, 90.0);
    std::uniform_real_distribution<double> time(0.0, 12.0);
    for (int i = 0; i < 50; ++i) {
        const std::array places{courseAt(azimuth(random), elevation(random)),
                                courseAt(azimuth(random), elevation(random)),
                                courseAt(azimuth(random), elevation(random))};
        const Seconds before(time(random));
        std::array<Seconds, 2> longest{};
        for (const bool slowed : {false, true}) {
            CourseRide drive(courseMount(), places[0]);
            drive.motion.goTo(places[1]);
            drive.run(before);
            drive.motion.setArrival(slowed ? profile::Arrival::Together : profile::Arrival::Separate);
            drive.motion.goTo(places[2]);
            const auto rested = drive.arrive(places[2]);
            longest[slowed ? 1 : 0] = std::max(rested[0], rested[1]);
            EXPECT_TRUE(!slowed || abs(rested[0] - rested[1]) < Seconds(0.25)) << i;
        }
        EXPECT_NEAR(longest[1].count(), longest[0].count(), 0.05) << i;
    }
}

TEST(ArrivalTest, AroundAKeepOutInTheLastLeg)
{
    CourseRide apart(courseMount(behindAMast()), courseAt(290, 10));
    apart.motion.goTo(courseAt(400, 5));
    const auto alone = apart.arrive(courseAt(400, 5));
    CourseRide drive(together(behindAMast()), courseAt(290, 10));
    drive.motion.goTo(courseAt(400, 5));
    const auto rested = drive.arrive(courseAt(400, 5));
    EXPECT_NEAR(rested[0].count(), rested[1].count(), 0.25);
    EXPECT_NEAR(std::max(rested[0], rested[1]).count(), std::max(alone[0], alone[1]).count(), 0.1);
}

TEST(ArrivalTest, ItAppliesAtOnceAndAStreamIsFollowedAsEver)
{
    CourseRide drive(courseMount(), courseAt(0, 0));
    drive.motion.goTo(courseAt(170, 20));
    drive.run(Seconds(1.0));
    drive.motion.setArrival(profile::Arrival::Together);
    const auto rested = drive.arrive(courseAt(170, 20));
    EXPECT_NEAR(rested[0].count(), rested[1].count(), 0.25);
    CourseRide one(courseMount(), courseAt(10, 30));
    CourseRide other(together(), courseAt(10, 30));
    for (int second = 0; second < 20; ++second) {
        for (CourseRide* const each : {&one, &other}) {
            each->motion.follow(courseAt(10.0 + 0.5 * second, 30.0 + 0.2 * second), each->now);
            each->run(Seconds(1.0));
        }
        if (one.motion.streaming(one.now)) {
            EXPECT_LT(abs(one.motion.place().azimuth - other.motion.place().azimuth), 0.3_deg);
        }
    }
    EXPECT_LT(abs(one.motion.place().azimuth - other.motion.place().azimuth), 0.001_deg);
}

}  // namespace
}  // namespace boresight
