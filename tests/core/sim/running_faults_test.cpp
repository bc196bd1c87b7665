// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/sim_bus/running_faults.h"

#include "core/sim_bus/simulated_link.h"
#include "tests/fakes/manual_clock.h"
#include "tests/fakes/text_of.h"

#include <gmock/gmock.h>

namespace boresight {
namespace {

using testing::HasSubstr;

constexpr AxisSet kBoth = kAxes;

struct RunningFaults : testing::Test
{
    std::string show(std::string_view text, AxisSet axes = kBoth)
    {
        const Result<QString> shown = showFault(mount, clock, axes, text);
        return shown ? shown->toStdString() : "refused: " + textOf(shown.error());
    }
    [[nodiscard]] std::optional<double> wind(Axis axis)
    {
        return mount.pair.faults().active(sim::FaultKind::Wind, axis, clock.now() - mount.epoch);
    }

    fakes::ManualClock clock;
    SimulatedMount mount{clock, sim::commissionedPair()};
};

// REQ-SIM-951: A running simulated mount shows a fault on request. Its times count from the request. "end" ends all.
TEST_F(RunningFaults, BeginAndEndFromNow)
{
    clock.advance(Seconds(100.0));
    EXPECT_EQ(show("wind az:60Nm@5+3"),
              "Simulated fault: azimuth: wind of 60 Nm towards larger angles, begins in 5.0 s, lasts 3.0 s.");
    EXPECT_FALSE(wind(Axis::Azimuth));
    clock.advance(Seconds(5.5));
    EXPECT_EQ(wind(Axis::Azimuth), 60.0);
    EXPECT_FALSE(wind(Axis::Elevation));
    clock.advance(Seconds(3.0));
    EXPECT_FALSE(wind(Axis::Azimuth));
    EXPECT_EQ(show("jam el:30"), "Simulated fault: elevation: blocked at 30°.");
    EXPECT_EQ(show("end"), "No fault is simulated now.");
    EXPECT_TRUE(mount.pair.faults().isEmpty());
}

// REQ-SIM-951
TEST_F(RunningFaults, ARefusalHasItsReasonAndChangesNothing)
{
    EXPECT_THAT(show("wind az:much"), HasSubstr("\"much\" is not a number"));
    EXPECT_THAT(show("gremlins"), HasSubstr("no fault \"gremlins\""));
    EXPECT_THAT(show("wind el:30", axesIf(true, false)), HasSubstr("The elevation of this mount has no simulated"));
    EXPECT_THAT(show("wind 30", axesIf(false, false)), HasSubstr("has no moteus drive"));
    EXPECT_TRUE(mount.pair.faults().isEmpty());
}

}  // namespace
}  // namespace boresight
