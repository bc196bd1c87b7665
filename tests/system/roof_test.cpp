// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/fakes/random_region.h"
#include "tests/system/gpredict_client.h"
#include "tests/system/satellite_pass.h"
#include "tests/system/simulated_station.h"

#include <gtest/gtest.h>

// A roof, a valley between hills and a mast. Whatever is requested, the true position of the antenna is never more than
// 0.2° inside a forbidden area.
namespace boresight::system_test {
namespace {

// Hills of 25° all round, with the horizon at 0° between azimuth 214° and 262°. The mast stands in the north-west.
profile::Profile roof()
{
    profile::Profile profile = anyPort();
    profile.limits.horizon = {{210_deg, 25_deg}, {214_deg, 0_deg}, {262_deg, 0_deg}, {266_deg, 25_deg}};
    profile.limits.keepOuts = {{"mast", 300_deg, 330_deg, 0_deg, 40_deg}};
    profile.park = {.azimuth = 315_deg, .elevation = 10_deg};
    return profile;
}

class RoofTest : public testing::Test
{
protected:
    RoofTest()
    {
        m_rig.onTick = [this] {
            m_deepest = std::max(m_deepest, fakes::depthInside(m_profile.limits, m_rig.truth()));
            m_tookRoute = m_tookRoute || !m_rig.status().route.empty();
            m_limited = m_limited || m_rig.status().limited;
        };
    }
    ~RoofTest() override
    {
        EXPECT_LT(m_deepest, 0.2);
        RecordProperty("deepest_millidegrees", static_cast<int>(1000.0 * m_deepest));
    }

    void jog(double azimuth, double elevation, int tenths)
    {
        for (int i = 0; i < tenths; ++i) {
            EXPECT_EQ(m_rig.ask(request::Jog{{AngularRate::fromDegrees(azimuth), AngularRate::fromDegrees(elevation)}}),
                      "");
            m_rig.run(Seconds(0.1));
        }
    }

    profile::Profile m_profile = roof();
    SimulatedStation m_rig{m_profile, sim::commissionedPair({.azimuth = 240_deg, .elevation = 30_deg})};
    double m_deepest = -90.0;
    bool m_tookRoute = false;
    bool m_limited = false;
};

// REQ-AXES-26 (RoofTest.*)
TEST_F(RoofTest, SlewsGoAround)
{
    for (const AxisPosition& place : {AxisPosition{299_deg, 26_deg}, AxisPosition{335_deg, 26_deg},
                                      AxisPosition{230_deg, 2_deg}, AxisPosition{400_deg, 25_deg}}) {
        EXPECT_EQ(m_rig.ask(request::PointAxes{place}), "");
        EXPECT_TRUE(m_rig.settle());
        EXPECT_LT(m_rig.farthestFrom(place), 0.1_deg);
    }
    EXPECT_TRUE(m_tookRoute);
}

TEST_F(RoofTest, APassBehindTheMastIsFollowedAlongItsEdges)
{
    const SatellitePass pass({.maxElevation = 34_deg, .culmination = 315_deg});
    GpredictClient gpredict(m_rig.connect(), pass);
    Seconds time = -pass.halfDuration() - Seconds(10.0);
    for (; time < pass.halfDuration() + Seconds(10.0); time += SimulatedStation::kTick) {
        m_rig.tick();
        gpredict.tick(time);
    }
    EXPECT_TRUE(m_limited);
    EXPECT_TRUE(m_tookRoute);
}

TEST_F(RoofTest, ParkingInTheMastIsRefusedWithTheNearestPlace)
{
    const std::string why = m_rig.ask(request::Park{});
    EXPECT_NE(why.find("lies in keep-out \"mast\". Nearest allowed: 300.0° / 25.0°"), std::string::npos) << why;
}

TEST_F(RoofTest, JogsIntoItAreHeldAtFullSpeed)
{
    EXPECT_EQ(m_rig.ask(request::PointAxes{{.azimuth = 285_deg, .elevation = 30_deg}}), "");
    EXPECT_TRUE(m_rig.settle());
    jog(6.0, 0.0, 50);
    EXPECT_EQ(m_rig.status().azimuth.state, AxisState::Limit);
    EXPECT_NEAR(m_rig.truth(Axis::Azimuth), 300.0, 0.1);
    jog(6.0, 4.0, 60);  // up along the side of the mast and over it
    EXPECT_GT(m_rig.truth(Axis::Azimuth), 301.0);
    jog(0.0, -6.0, 80);
    EXPECT_NEAR(m_rig.truth(Axis::Elevation), 40.0, 0.1);
    EXPECT_TRUE(m_rig.logSays(QStringLiteral("held at the keep-out \"mast\"")));
}

TEST_F(RoofTest, StopInMidRouteStaysOutside)
{
    EXPECT_EQ(m_rig.ask(request::PointAxes{{.azimuth = 345_deg, .elevation = 26_deg}}), "");
    for (int i = 0; i < 12; ++i) {
        m_rig.run(Seconds(0.9));
        EXPECT_EQ(m_rig.ask(request::Stop{}), "");
        m_rig.run(Seconds(2.5));
        EXPECT_EQ(m_rig.ask(request::ResetStop{}), "");
        EXPECT_EQ(m_rig.ask(request::PointAxes{{.azimuth = 345_deg, .elevation = 26_deg}}), "");
    }
    EXPECT_TRUE(m_rig.settle());
    EXPECT_NEAR(m_rig.truth(Axis::Azimuth), 345.0, 0.1);
}

}  // namespace
}  // namespace boresight::system_test
