// SPDX-License-Identifier: GPL-3.0-or-later
// Random regions, targets, streams, jogs and edits.
#include "core/pointing/nearest_permitted.h"
#include "tests/core/motion/region_ride.h"

#include <random>

using namespace boresight;
using namespace boresight::region_ride;

namespace {

class RegionWalk
{
public:
    explicit RegionWalk(unsigned seed)
        : m_random(seed),
          m_make(m_random),
          m_azimuth(m_make.azimuthTravel()),
          m_elevation(m_make.elevationTravel()),
          m_run(mount(m_make.region(), m_azimuth, m_elevation), {})
    {
        const auto start = pointing::nearestPermitted(m_run.motion.region(), m_make.place(m_azimuth, m_elevation));
        if (start) {
            m_run.motion.start(Axis::Azimuth, start->azimuth);
            m_run.motion.start(Axis::Elevation, start->elevation);
        }
        m_possible = start.has_value();
    }

    void go(int steps)
    {
        for (int i = 0; m_possible && i < steps; ++i) {
            ask();
            for (int tick = 0, count = 1 + m_make.dice(120); tick < count; ++tick) {
                stream();
                m_run.tick();
                m_moved += abs(m_run.motion.setpoint(Axis::Azimuth).rate).degrees() * 0.02;
                m_limited += m_run.motion.limited() ? 1 : 0;
                m_bent += m_run.motion.route().empty() ? 0 : 1;
            }
        }
    }

    double m_moved = 0.0;  // degrees
    int m_limited = 0;     // ticks
    int m_bent = 0;

private:
    void ask()
    {
        Motion& motion = m_run.motion;
        switch (m_make.dice(10)) {
            case 0:
            case 1:
            case 2:
                m_streaming = false;
                return motion.goTo(m_make.place(m_azimuth, m_elevation));
            case 3:
            case 4:
                m_streaming = false;
                return motion.run(rates(m_make.uniform(-12, 12), m_make.uniform(-9, 9)));
            case 5:
            case 6:
                motion.rest();
                m_streaming = true;
                m_point = m_make.place(m_azimuth, m_elevation);
                m_drift = rates(m_make.uniform(-4, 4), m_make.uniform(-2, 2));
                return;
            case 7:
                m_streaming = false;
                return motion.rest();
            case 8:
                if (m_make.dice(4) == 0) {
                    m_run.draw(m_make.region());
                }
                return;
            default:
                return m_run.ticks(100);
        }
    }

    void stream()
    {
        if (m_streaming && m_run.now >= m_nextPoint) {
            m_nextPoint = m_run.now + std::chrono::milliseconds(500 + m_make.dice(1000));
            m_point.azimuth = m_azimuth.clamped(m_point.azimuth + m_drift.azimuth * Seconds(1.0));
            m_point.elevation = m_elevation.clamped(m_point.elevation + m_drift.elevation * Seconds(1.0));
            m_run.motion.follow(m_point, m_run.now);
        }
    }

    std::mt19937 m_random;
    fakes::RandomRegion m_make;
    TravelRange m_azimuth;
    TravelRange m_elevation;
    Ride m_run;
    bool m_possible = false;
    bool m_streaming = false;
    AxisPosition m_point;
    AxisRates m_drift;
    SteadyTime m_nextPoint{};
};

}  // namespace

TEST(MotionRegion, HoldsWhateverIsAskedAndDrawn)
{
    double moved = 0.0;
    int limited = 0;
    int bent = 0;
    for (unsigned seed = 1; seed <= 150 && !HasFailure(); ++seed) {
        SCOPED_TRACE(seed);
        RegionWalk walk(seed);
        walk.go(60);
        moved += walk.m_moved;
        limited += walk.m_limited;
        bent += walk.m_bent;
    }
    EXPECT_GT(moved, 10000);
    EXPECT_GT(limited, 1000);
    EXPECT_GT(bent, 1000);
}

// A motion to a permitted place that has a route arrives there.
TEST(MotionRegion, ArrivesWhereThereIsAWay)
{
    std::mt19937 random(17);
    fakes::RandomRegion make(random);
    int arrived = 0;
    for (int round = 0; round < 150 && !HasFailure(); ++round) {
        SCOPED_TRACE(round);
        const profile::Profile profile = mount(make.region(), make.azimuthTravel(), make.elevationTravel());
        const pointing::PermittedRegion region(profile.limits, profile.azimuth.geometry.travel,
                                               profile.elevation.geometry.travel);
        const auto from =
            pointing::nearestPermitted(region, make.place(region.ranges().azimuth, region.ranges().elevation));
        const auto to =
            pointing::nearestPermitted(region, make.place(region.ranges().azimuth, region.ranges().elevation));
        if (!from || !to) {
            continue;
        }
        Ride run(profile, *from);
        if (!run.motion.route(*from, *to)) {
            continue;
        }
        run.motion.goTo(*to);
        EXPECT_TRUE(run.untilRest());
        expectAt(run.motion, to->azimuth.degrees(), to->elevation.degrees());
        ++arrived;
    }
    EXPECT_GT(arrived, 50);
}
