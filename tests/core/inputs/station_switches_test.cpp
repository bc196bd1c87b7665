// SPDX-License-Identifier: GPL-3.0-or-later
// End switches of a whole station, at pins of its simulated boards.
#include "core/inputs/station_switches.h"

#include "core/sim/reference_mount.h"
#include "tests/core/station/moving_station.h"

#include <QTemporaryDir>

#include <gtest/gtest.h>

namespace boresight {
namespace {

using end_switches::SwitchState;

class StationSwitchesTest : public ::testing::Test
{
protected:
    void name(const std::array<std::string, 4>& inputs)
    {
        profile::Profile profile = anyPort();
        profile.endSwitches.inputs = inputs;
        moving.station->reload(profile);
        moving.run(Seconds(1.0));
    }
    [[nodiscard]] SwitchState state(std::size_t number) const
    {
        return moving.station->status().endSwitches.at(number).state;
    }
    [[nodiscard]] Angle truth() { return moving.link->truth(Axis::Azimuth).angle; }
    // Wires a switch to pin 0 of aux port 1 of the azimuth board. The azimuth presses it above this angle.
    void wire(Angle at)
    {
        const double turns = sim::referenceAxis(Axis::Azimuth).toTurns(at);
        moving.link->pair().wire({.port = 1, .pin = 0, .axis = Axis::Azimuth, .at = turns});
    }

    QTemporaryDir folder;
    MovingStation moving{folder.path()};
};

// REQ-ENDSWITCH-62: The whole way from a pin of a board to the set-points: an axis that presses its switch stops, and
// moves only the other way after the re-arm.
TEST_F(StationSwitchesTest, APinOfABoardStopsTheMount)
{
    name({"", "moteus:1:aux1.0", "", ""});
    wire(30_deg);
    moving.run(Seconds(0.5));
    EXPECT_EQ(state(0), SwitchState::Free);
    moving.station->request({.id = 1, .request = request::PointSky{{.azimuth = 90_deg, .elevation = 30_deg}}});
    moving.run(Seconds(20.0));
    EXPECT_EQ(moving.station->status().state, StationState::Fault);
    EXPECT_EQ(state(0), SwitchState::Pressed);
    EXPECT_GE(truth(), 30_deg);
    EXPECT_LT(truth(), 34_deg);
    moving.station->request({.id = 2, .request = request::Rearm{}});
    moving.run(Seconds(2.0));
    moving.station->request({.id = 3, .request = request::PointSky{{.azimuth = 60_deg, .elevation = 30_deg}}});
    moving.run(Seconds(3.0));
    EXPECT_LT(truth(), 34_deg);
    moving.station->request({.id = 4, .request = request::PointSky{{.azimuth = 10_deg, .elevation = 30_deg}}});
    moving.run(Seconds(10.0));
    EXPECT_NEAR(truth().degrees(), 10.0, 0.3);
    EXPECT_EQ(state(0), SwitchState::Free);
}

// REQ-ENDSWITCH-63: A board that does not reply cannot be read. With a simulated mount the switches of the real mount
// count as free.
TEST_F(StationSwitchesTest, OnlyPinsOfItsOwnBoardsAreReadInASimulation)
{
    name({"mqtt:roof/end", "moteus:1:aux1.0", "cts:/dev/ttyUSB0", "moteus:9:aux1.0"});
    for (std::size_t number = 0; number < 4; ++number) {
        EXPECT_EQ(state(number), SwitchState::Free) << number;
    }
    moving.link->inject({.kind = sim::FaultKind::Silence, .axis = Axis::Azimuth});
    moving.run(Seconds(1.0));
    EXPECT_EQ(state(1), SwitchState::Unread);
    EXPECT_EQ(moving.station->status().endSwitches.at(1).problem, QStringLiteral("board 1 does not reply"));
    EXPECT_EQ(state(3), SwitchState::Free);
}

}  // namespace
}  // namespace boresight
