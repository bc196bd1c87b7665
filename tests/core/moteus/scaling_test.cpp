// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/moteus/scaling.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <limits>
#include <random>
#include <set>

namespace boresight::moteus {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

std::int8_t asInt8(double value, Kind kind, Side side = Side::Client)
{
    return static_cast<std::int8_t>(toWire(value, kind, Resolution::Int8, side));
}

std::int32_t asInt32(double value, Kind kind, Side side = Side::Client)
{
    return static_cast<std::int32_t>(toWire(value, kind, Resolution::Int32, side));
}

// REQ-MOTEUS-04 (MoteusScaling.*): Both sides truncate towards zero. Finite values saturate. Other values become the
// most negative integer, except in whole-number registers.
TEST(MoteusScaling, TruncatesTowardsZeroOnBothSides)
{
    EXPECT_EQ(asInt8(0.29, Kind::Position), 28);  // 0.29 / 0.01 is just under 29 in double
    EXPECT_EQ(asInt8(0.019, Kind::Position), 1);
    EXPECT_EQ(asInt8(-0.019, Kind::Position), -1);
    EXPECT_EQ(asInt8(0.29, Kind::Position, Side::Device), 29);  // in single precision it is exactly 29
    EXPECT_EQ(asInt8(-0.299, Kind::Position, Side::Device), -29);
}

TEST(MoteusScaling, FiniteValuesSaturateAndOthersBecomeTheSentinel)
{
    for (const Side side : {Side::Client, Side::Device}) {
        EXPECT_EQ(asInt8(1e9, Kind::Position, side), 127);
        EXPECT_EQ(asInt8(-1e9, Kind::Position, side), -127);
        EXPECT_EQ(asInt32(1e30, Kind::Torque, side), 2147483647);
        EXPECT_EQ(asInt32(-1e30, Kind::Torque, side), -2147483647);
        for (const double value : {kNan, kInfinity, -kInfinity}) {
            EXPECT_EQ(asInt8(value, Kind::Voltage, side), -128);
            EXPECT_EQ(asInt32(value, Kind::Voltage, side), std::numeric_limits<std::int32_t>::min());
        }
    }
}

TEST(MoteusScaling, FloatKeepsWhatIntegersCannot)
{
    EXPECT_EQ(fromWire(toWire(kInfinity, Kind::Current, Resolution::Float), Kind::Current, Resolution::Float),
              kInfinity);
    EXPECT_TRUE(std::isnan(fromWire(toWire(kNan, Kind::Time, Resolution::Float), Kind::Time, Resolution::Float)));
    EXPECT_EQ(toWire(0.25, Kind::Position, Resolution::Float), std::bit_cast<std::uint32_t>(0.25F));
}

TEST(MoteusScaling, IntegersHaveNoSentinelAndWrapInTheDrive)
{
    EXPECT_EQ(fromWire(0x80, Kind::Integer, Resolution::Int8), -128);
    EXPECT_EQ(asInt8(2044, Kind::Integer, Side::Device), static_cast<std::int8_t>(2044));
    EXPECT_EQ(asInt8(2044, Kind::Integer), 127);
    EXPECT_EQ(asInt32(2147483649.0, Kind::Counter), -2147483647);  // the counter overflows by design
    EXPECT_EQ(asInt32(-12345, Kind::Identity), -12345);
}

TEST(MoteusScaling, EveryValueComesBackWithinOneStep)
{
    std::mt19937 random(1);
    for (int i = 0; i < 20'000; ++i) {
        const auto kind = static_cast<Kind>(random() % 10);
        const auto resolution = static_cast<Resolution>(random() % 3);
        const auto side = static_cast<Side>(random() % 2);
        const double step = stepSize(kind, resolution);
        const double value = std::uniform_real_distribution(-126.0, 126.0)(random) * step;
        const double back = fromWire(toWire(value, kind, resolution, side), kind, resolution, side);
        EXPECT_LE(std::abs(back - value), step * 1.001) << static_cast<int>(kind);
        const double again = fromWire(toWire(back, kind, resolution, side), kind, resolution, side);
        EXPECT_LE(std::abs(again - back), step * 1.001);
    }
}

// REQ-MOTEUS-05 (MoteusRegisters.*): The register map is complete. Faults, limits and modes have words. Limits are no
// faults.
TEST(MoteusRegisters, EveryRegisterHasItsOwnNameAndTheMapsAccess)
{
    std::set<std::string> names;
    int readable = 0;
    int writable = 0;
    for (std::uint32_t number = 0; number < 0x200; ++number) {
        const auto reg = static_cast<Register>(number);
        if (const auto info = registerInfo(reg)) {
            EXPECT_TRUE(names.insert(info->name).second) << info->name;
            EXPECT_EQ(info->name, registerName(reg));
            EXPECT_EQ(info->kind, registerKind(reg));
        } else {
            EXPECT_FALSE(registerKind(reg));
            EXPECT_FALSE(isReadable(reg) || isWritable(reg));
        }
        readable += isReadable(reg) ? 1 : 0;
        writable += isWritable(reg) ? 1 : 0;
    }
    // Counted by hand in the register map: all can be read except the id (0), four triggers and four mask words.
    EXPECT_EQ(names.size(), 120U);
    EXPECT_EQ(readable, 111);
    EXPECT_EQ(writable, 58);
}

TEST(MoteusRegisters, FamiliesCountTheirMembers)
{
    EXPECT_EQ(registerName(Register::Uuid + 1), "UUID 2");
    EXPECT_EQ(registerName(Register::Aux2AnalogIn + 4), "aux 2 analog input 5");
    EXPECT_EQ(registerName(Register::Aux2AnalogIn + 5), "unknown register 0x6d");
    EXPECT_FALSE(isReadable(Register::UuidMask));
    EXPECT_TRUE(isWritable(Register::UuidMask + 3));
    EXPECT_FALSE(isReadable(Register::MultiplexId) || isWritable(Register::MultiplexId));
}

}  // namespace
}  // namespace boresight::moteus
