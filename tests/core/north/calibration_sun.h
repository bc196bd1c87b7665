// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/core/north/calibration_rig.h"
#include "tests/fakes/text_of.h"

// Actions of an operator with the Sun on a summer's day, on the mast of calibration_rig.h.
namespace boresight {

// Sets the clock to this hour of UTC on a summer's day.
inline void setHour(CalibrationRig& rig, double hour)
{
    const UtcTime midnight = std::chrono::sys_days{std::chrono::year{2026} / 6 / 21};
    rig.clock.stepUtc(Seconds(midnight - rig.clock.utc()) + Seconds(hour * 3600.0));
}

// A rig after a swing that has found north to a degree or two.
struct SwungRig : CalibrationRig
{
    explicit SwungRig(const profile::Profile& settings = calibratedProfile()) : CalibrationRig({}, settings)
    {
        profile::Profile swung = profile;
        swung.pointing.azimuthOffset = Angle::fromDegrees(36.0);
        setProfile(swung);
    }
};

// The boom can go past the zenith.
inline profile::Profile profileOverTheTop()
{
    profile::Profile profile = calibratedProfile();
    profile.elevation.geometry.travel.max = 180_deg;
    return profile;
}

inline void follow(CalibrationRig& rig, ephemeris::Body body = ephemeris::Body::Sun, bool overTheTop = false)
{
    const auto followed = rig.ask(request::FollowBody{.body = body, .overTheTop = overTheTop});
    ASSERT_TRUE(followed) << textOf(followed.error());
    rig.run(Seconds(70.0));
    ASSERT_EQ(StationState::Track, rig.state());
}

inline double apart(const SkyPointing& a, const SkyPointing& b)
{
    const double across = (a.azimuth - b.azimuth).wrapped180().degrees() * std::cos(a.elevation.radians());
    return std::hypot(across, (a.elevation - b.elevation).degrees());
}

// Centres the Sun by the arrow keys, as accurately as an eye does.
inline void centre(CalibrationRig& rig, double noise = 0.01)
{
    std::normal_distribution<double> eye(0.0, noise);
    const SkyPointing sun = rig.status().bodies.at(0).direction;
    const SkyPointing behind{.azimuth = sun.azimuth + 180_deg, .elevation = 180_deg - sun.elevation};
    for (int i = 0; i < 3; ++i) {
        const AxisPosition wanted = rig.model.toAxes(rig.status().overTheTop ? behind : sun).axes;
        const AxisPosition here = rig.axes();
        ASSERT_TRUE(rig.ask(request::Nudge{.azimuth = (wanted.azimuth - here.azimuth).wrapped180(),
                                           .elevation = wanted.elevation - here.elevation}));
        rig.run(Seconds(3.0));
    }
    ASSERT_TRUE(rig.ask(request::Nudge{.azimuth = Angle::fromDegrees(eye(rig.random)),
                                       .elevation = Angle::fromDegrees(eye(rig.random))}));
    rig.run(Seconds(3.0));
    EXPECT_LT(apart(rig.beam(), rig.status().bodies.at(0).direction), 0.1);
}

inline void takeSun(CalibrationRig& rig, double hour, bool overTheTop = false)
{
    setHour(rig, hour);
    follow(rig, ephemeris::Body::Sun, overTheTop);
    centre(rig);
    const auto taken = rig.ask(request::TakePoint{});
    ASSERT_TRUE(taken) << textOf(taken.error());
}

}  // namespace boresight
