// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/ephemeris/almanac.h"
#include "core/ephemeris/refraction.h"
#include "core/pointing/pointing_model.h"
#include "core/units/angle_between.h"
#include "tests/system/simulated_station.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

// The Sun has a place in the sky, but the drives count from an arbitrary angle. On a mount whose azimuth zero is 37.4°
// from north and whose mast leans, a client moves the beam across the Sun. The true direction of the beam decides.
namespace boresight::system_test {
namespace {

constexpr Site kLisbon{.latitude = 38.757_deg, .longitude = -9.117_deg, .heightMetres = 80.0};
constexpr Angle kRadius = 10_deg;
constexpr pointing::PointingTerms kTerms{
    .azimuthOffset = 37.4_deg, .elevationOffset = -1.0_deg, .tiltNorth = 0.6_deg, .collimation = 0.3_deg};

profile::Profile sunny()
{
    profile::Profile profile = anyPort();
    profile.site = {.known = true,
                    .latitude = kLisbon.latitude,
                    .longitude = kLisbon.longitude,
                    .heightMetres = kLisbon.heightMetres};
    profile.sun = {.keepAway = profile::KeepAway::On, .radius = kRadius};
    profile.pointing = kTerms;
    return profile;
}

// At noon: the Sun stands in the south, at 31° elevation.
class SunKeepAway : public testing::Test
{
protected:
    SunKeepAway()
    {
        rig.clock.stepUtc(std::chrono::hours(12));
        rig.run(Seconds(0.1));
        rig.onTick = [this] { nearest = std::min(nearest, angleBetween(sun, beam())); };
    }

    [[nodiscard]] SkyPointing sunNow() const
    {
        ephemeris::Almanac almanac(kLisbon);
        return ephemeris::apparent(almanac.place(ephemeris::Body::Sun, rig.clock.utc()).direction,
                                   ephemeris::Refraction::Light);
    }
    [[nodiscard]] SkyPointing beam() const { return model.toSky(rig.truth()); }
    [[nodiscard]] static std::string pointAt(Angle azimuth, Angle elevation)
    {
        return "P " + std::to_string(azimuth.wrapped360().degrees()) + ' ' + std::to_string(elevation.degrees()) + '\n';
    }

    SimulatedStation rig{sunny()};
    pointing::PointingModel model{kTerms};
    SkyPointing sun = sunNow();
    Angle nearest = 180_deg;
};

// REQ-CONTROL-44 (SunKeepAway.*): The keep-out of the Sun applies to the true direction of the beam, whatever the axis
// angles are.
TEST_F(SunKeepAway, HoldsForTheTrueDirectionOfTheBeam)
{
    sun = sunNow();
    const auto client = rig.connect();
    client->ask(pointAt(sun.azimuth - 50_deg, sun.elevation));
    rig.run(Seconds(60.0));
    for (double across = -50.0; across <= 50.0; across += 1.0) {
        client->ask(pointAt(sun.azimuth + Angle::fromDegrees(across), sun.elevation + 1_deg));
        rig.run(Seconds(1.0));
        sun = sunNow();
    }
    rig.run(Seconds(60.0));
    EXPECT_GT(nearest, kRadius - 0.05_deg);
    EXPECT_LT(nearest, kRadius + 1.0_deg) << "it is led along the edge";
    EXPECT_LT(angleBetween(beam(), {.azimuth = sunNow().azimuth + 50_deg, .elevation = sun.elevation + 1_deg}), 1_deg);
}

// Story: with the clock at 1 January 2000 the beam went into the Sun without an alarm. A client must be refused every
// place where the Sun may be, and must not be led to one of them.
// REQ-CONTROL-39a
TEST_F(SunKeepAway, WithoutASynchronisedClockTheBeamStaysAwayFromItToo)
{
    rig.clock.setSynchronised(false);
    rig.clock.stepUtc(-std::chrono::hours(24 * 9456));
    sun = {.azimuth = 180_deg, .elevation = 31_deg};  // the true direction of the Sun
    const auto client = rig.connect();
    for (double azimuth = 60.0; azimuth <= 300.0; azimuth += 5.0) {
        client->ask(pointAt(Angle::fromDegrees(azimuth), 31_deg));
        rig.run(Seconds(2.0));
    }
    rig.run(Seconds(60.0));
    EXPECT_GT(nearest, kRadius);
    EXPECT_NE(rig.ask(request::PointSky{sun}).find("the clock is not synchronised"), std::string::npos);
}

// At this place the axis angle of the azimuth equals the true azimuth of the Sun.
TEST_F(SunKeepAway, LeavesFreeWhereOnlyTheAxisCountsLikeTheSun)
{
    sun = sunNow();
    EXPECT_EQ(rig.ask(request::PointAxes{{.azimuth = sun.azimuth, .elevation = sun.elevation}}), "");
    EXPECT_TRUE(rig.settle());
    EXPECT_LT(rig.farthestFrom({.azimuth = sun.azimuth, .elevation = sun.elevation}), 0.1_deg);
    const AxisPosition onTheSun = model.toAxes(sun).axes;
    EXPECT_NE(rig.ask(request::PointAxes{onTheSun}).find("keep-out \"Sun\""), std::string::npos);
}

}  // namespace
}  // namespace boresight::system_test
