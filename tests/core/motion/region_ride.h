// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/motion/motion.h"
#include "tests/fakes/random_region.h"

#include <gtest/gtest.h>

#include <array>

// A motion within a region, with the checks that hold in every tick.
namespace boresight::region_ride {

constexpr std::chrono::milliseconds kMotionRegionTick{20};

inline AxisPosition at(double azimuth, double elevation)
{
    return {.azimuth = Angle::fromDegrees(azimuth), .elevation = Angle::fromDegrees(elevation)};
}

inline AxisRates rates(double azimuth, double elevation)
{
    return {.azimuth = AngularRate::fromDegrees(azimuth), .elevation = AngularRate::fromDegrees(elevation)};
}

inline pointing::KeepOut mast(Angle top = 40_deg)
{
    return {.name = "mast", .azimuthFrom = 300_deg, .azimuthTo = 330_deg, .elevationMin = 0_deg, .elevationMax = top};
}

inline profile::Profile mount(const pointing::Region& limits, TravelRange azimuth = {-200_deg, 460_deg},
                              TravelRange elevation = {0_deg, 90_deg})
{
    profile::Profile profile;
    profile.azimuth.geometry.travel = azimuth;
    profile.elevation.geometry.travel = elevation;
    profile.limits = limits;
    return profile;
}

// Turns the clock, and checks the set-points after every tick.
class Ride
{
public:
    Ride(const profile::Profile& profile, const AxisPosition& start) : motion(profile), region(profile.limits)
    {
        motion.start(Axis::Azimuth, start.azimuth);
        motion.start(Axis::Elevation, start.elevation);
        m_limits = {profile.azimuth.limits, profile.elevation.limits};
    }

    void tick()
    {
        now += kMotionRegionTick;
        motion.advance(now, kMotionRegionTick);
        const AxisPosition place = motion.place();
        const bool permitted = motion.region().permits(place);
        if (!permitted && m_wasPermitted && !m_edited) {
            ADD_FAILURE() << "entered " << motion.region().reason(place).toStdString();
        }
        if (permitted) {
            EXPECT_LE(fakes::depthInside(region, place), 1e-6);
        }
        m_edited = m_edited && !motion.atRest();
        m_wasPermitted = permitted;
        for (const Axis axis : kAxes) {
            const tracking::Setpoint& setpoint = motion.setpoint(axis);
            EXPECT_LE(abs(setpoint.rate), m_limits[index(axis)].speed * 1.000001);
            EXPECT_LE(abs(setpoint.acceleration), m_limits[index(axis)].acceleration * 1.000001);
        }
    }

    void ticks(int count)
    {
        for (int i = 0; i < count; ++i) {
            tick();
        }
    }

    // True when the motion has ended, and not only paused at a corner of its route.
    bool untilRest(int most = 20000)
    {
        const auto rests = [this] { return motion.atRest() && motion.route().empty(); };
        tick();
        for (; most > 0 && !rests(); --most) {
            tick();
        }
        return rests();
    }

    void draw(const pointing::Region& drawn)
    {
        region = drawn;
        motion.setRegion(drawn, {});
        m_edited = true;
    }

    Motion motion;
    pointing::Region region;
    SteadyTime now{};

private:
    std::array<tracking::MotionLimits, 2> m_limits;
    bool m_wasPermitted = true;
    bool m_edited = false;  // after an edit and before standstill: the axis may slide into the region drawn before it
};

inline void expectAt(const Motion& motion, double azimuth, double elevation, double tolerance = 1e-6)
{
    EXPECT_NEAR(motion.place().azimuth.degrees(), azimuth, tolerance);
    EXPECT_NEAR(motion.place().elevation.degrees(), elevation, tolerance);
}

}  // namespace boresight::region_ride
