// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/system/simulated_station.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

// Scenario 12: the cable is about to end while a client's target is tracked.
namespace boresight::system_test {
namespace {

class CableEndTest : public ::testing::Test
{
protected:
    // The mount stands on the last wrap of the cable, and a client streams clockwise from there.
    void prepare(SimulatedStation& rig, Angle azimuth)
    {
        ASSERT_EQ(rig.ask(request::PointAxes{{azimuth, 30_deg}}), "");
        ASSERT_TRUE(rig.settle());
        ASSERT_EQ(rig.ask(request::GiveAuthority{}), "");
        rig.onTick = [this, &rig] { look(rig); };
        m_client = rig.connect();
    }

    // One target per second along 30° of elevation, at 1°/s.
    void stream(SimulatedStation& rig, double fromDegrees, int seconds)
    {
        for (int second = 0; second < seconds; ++second) {
            const double azimuth = std::fmod(fromDegrees + second, 360.0);
            m_now = fromDegrees + second;
            EXPECT_EQ(m_client->ask("P " + std::to_string(azimuth) + " 30.0\n"), "RPRT 0\n");
            rig.run(Seconds(1.0));
        }
    }

    void look(SimulatedStation& rig)
    {
        farthest = std::max(farthest, rig.truth(Axis::Azimuth));
        if (!toldAt && rig.alarmSays(QStringLiteral("azimuth reaches its cable end"))) {
            toldAt = m_now;
        }
    }

    double farthest = -1e9;
    std::optional<double> toldAt;  // azimuth of the target when the warning appeared

private:
    std::unique_ptr<fakes::TcpPeer> m_client;
    double m_now = 0.0;
};

// REQ-CONTROL-31 (CableEndTest.*)
TEST_F(CableEndTest, IsToldAheadThenTheMountTurnsBackAndFollowsOn)
{
    SimulatedStation rig;  // -90…450°
    prepare(rig, 385_deg);
    stream(rig, 385.0, 50);
    ASSERT_TRUE(toldAt.has_value());
    EXPECT_LE(*toldAt, 420.0) << "30 s and 30° before the end";
    const auto end = rig.status().cableEnd;
    ASSERT_TRUE(end.has_value());
    EXPECT_EQ(end->end, 450_deg);
    EXPECT_NEAR(end->in.count(), 450.0 - 435.0, 5.0);
    ASSERT_TRUE(end->turningBack.has_value());
    EXPECT_TRUE(rig.logSays(QStringLiteral("unwrap the cable by 360°")));

    stream(rig, 435.0, 90);
    EXPECT_LE(farthest, 450.2) << "the mechanical end is never reached";
    EXPECT_NEAR(rig.truth(Axis::Azimuth), 524.0 - 360.0, 2.0);
    EXPECT_TRUE(rig.logSays(
        QStringLiteral("unwraps the cable by 360° because the cable ends at axis 450.0°. The target is lost")));
    EXPECT_FALSE(rig.status().cableEnd.has_value());
}

TEST_F(CableEndTest, WithoutAnotherTurnItSaysThatItHoldsAndStopsAtTheEnd)
{
    profile::Profile profile = anyPort();
    profile.limits.azimuth = {200_deg, 450_deg};
    SimulatedStation rig(profile);
    prepare(rig, 400_deg);
    stream(rig, 400.0, 40);
    ASSERT_TRUE(rig.status().cableEnd.has_value());
    EXPECT_FALSE(rig.status().cableEnd->turningBack.has_value());
    EXPECT_TRUE(rig.logSays(QStringLiteral("hold there until the mount can reach the target again")));
    stream(rig, 440.0, 30);
    EXPECT_LE(farthest, 450.2);
    EXPECT_NEAR(rig.truth(Axis::Azimuth), 450.0, 0.2);
}

TEST_F(CableEndTest, APassThatEndsBeforeItIsNotTold)
{
    SimulatedStation rig;
    prepare(rig, 200_deg);
    stream(rig, 200.0, 60);
    EXPECT_FALSE(toldAt.has_value());
}

}  // namespace
}  // namespace boresight::system_test
