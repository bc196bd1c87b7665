// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/sim/power_supply.h"

#include <gtest/gtest.h>

namespace boresight::sim {
namespace {

constexpr double kPowerSupplyStep = 1e-3;

double settled(PowerSupply& supply, double power, double seconds)
{
    for (int i = 0; i < static_cast<int>(seconds / kPowerSupplyStep); ++i) {
        supply.step(kPowerSupplyStep, power);
    }
    return supply.voltage();
}

TEST(PowerSupply, SagsByItsSourceResistance)
{
    PowerSupply supply({.voltage = 24.0, .sourceResistance = 0.1});
    // V = 24 - 0.1·P/V
    EXPECT_NEAR(settled(supply, 240.0, 1.0), 22.95, 0.01);
    EXPECT_NEAR(settled(supply, 0.0, 1.0), 24.0, 1e-6);
}

TEST(PowerSupply, BrakingChargesTheCapacitors)
{
    PowerSupply supply({.voltage = 24.0, .sourceResistance = 0.1, .capacitance = 2.0e-3});
    // ½·C·(V² - 24²) = 1 J
    EXPECT_NEAR(settled(supply, -10.0, 0.1), 39.7, 0.3);
    EXPECT_LT(settled(supply, 10.0, 1.0), 24.0) << "drawn down again by the load";
}

TEST(PowerSupply, BatteryAbsorbs)
{
    PowerSupply supply({.voltage = 24.0, .sourceResistance = 0.1, .absorbs = true});
    EXPECT_NEAR(settled(supply, -10.0, 1.0), 24.04, 0.01);
}

TEST(PowerSupply, OffIsOff)
{
    PowerSupply supply({});
    supply.setOn(false);
    EXPECT_EQ(settled(supply, 0.0, 0.1), 0.0);
    supply.setOn(true);
    EXPECT_EQ(supply.voltage(), 24.0);
}

TEST(BoardTemperature, RisesWithLossTowardsAFirstOrderEnd)
{
    BoardTemperature board;
    for (int i = 0; i < 2000; ++i) {
        board.step(1.0, 1.5);
    }
    EXPECT_NEAR(board.celsius(), 29.0, 0.1) << "idle, 20 °C ambient";
    board.step(180.0, 7.5);  // one long step is still on the first-order line
    EXPECT_GT(board.celsius(), 50.0);
}

}  // namespace
}  // namespace boresight::sim
