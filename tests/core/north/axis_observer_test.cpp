// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/north/axis_observer.h"

#include "tests/core/control/station_rig.h"
#include "tests/fakes/text_of.h"

#include <gtest/gtest.h>

namespace boresight {
namespace {

using namespace boresight::literals;

struct ObserverRig : public StationRig
{
    void watch(Seconds time)
    {
        for (int i = 0; i < static_cast<int>(time / kTick); ++i) {
            axes.tick();
            tick();
        }
    }

    AxisObserver axes{control, clock};
};

TEST(AxisObserver, AMountThatMovesDoesNotStandStill)
{
    ObserverRig rig;
    EXPECT_FALSE(rig.axes.standStill()) << "nothing was measured yet";
    rig.watch(Seconds(2.0));
    EXPECT_TRUE(rig.axes.standStill());
    ASSERT_TRUE(rig.ask(request::TakeAuthority{}));
    ASSERT_TRUE(rig.ask(request::PointAxes{{.azimuth = 60_deg, .elevation = 30_deg}}));
    rig.watch(Seconds(2.0));
    const Result<> moves = rig.axes.standStill();
    ASSERT_FALSE(moves);
    EXPECT_EQ("Wait until the mount stands still.", textOf(moves.error()));
    rig.watch(Seconds(60.0));
    EXPECT_TRUE(rig.axes.standStill());
}

TEST(AxisObserver, ItCountsForHowLongThePlaceIsUnknown)
{
    ObserverRig rig;
    rig.watch(Seconds(2.0));
    EXPECT_EQ(Seconds(0.0), rig.axes.unseenFor());
    EXPECT_TRUE(rig.axes.now());
    rig.azimuth.silent = true;
    rig.elevation.silent = true;
    rig.watch(Seconds(5.0));
    EXPECT_GT(rig.axes.unseenFor(), Seconds(3.0));
    EXPECT_LT(rig.axes.unseenFor(), Seconds(5.0)) << "what was measured holds for a while";
    EXPECT_FALSE(rig.axes.now());
    EXPECT_FALSE(rig.axes.standStill());
}

}  // namespace
}  // namespace boresight
