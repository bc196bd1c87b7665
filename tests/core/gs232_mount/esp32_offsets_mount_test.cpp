// SPDX-License-Identifier: GPL-3.0-or-later
// The offsets of the sensor of the ESP32 relay controller: shown, saved with the profile, compared.
#include "tests/core/gs232_mount/esp32_bench.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace boresight::gs232 {
namespace {

constexpr const char* kReported = "accelerometer 1 2 3, magnetometer 4 5 6, gyroscope 7 8 9, radii 1000 700";

long asked(Esp32Bench& bench)
{
    return std::ranges::count(bench.box().heard(), "CALSTATS");
}

void save(Esp32Bench& bench, const std::string& offsets)
{
    profile::Profile profile = *bench.inForce();
    profile.rotator.sensorOffsets = offsets;
    bench.edit(profile);
}

// REQ-GS232-102: The offsets of the sensor of an ESP32 relay controller are asked for once after each connection and
// each start of the box, while all of its digits are 3. The box sends random numbers otherwise, so an answer counts
// only if the digits are 3 after it, too. Nothing is sent that moves the box or changes it.
TEST(Esp32OffsetsOfTheMount, AreReadOncePerConnection)
{
    Esp32Bench bench;
    bench.box().faults().digits = {3, 3, 3, 2};
    bench.run(Seconds(10.0));
    EXPECT_EQ(asked(bench), 0);
    EXPECT_EQ(bench.mount().sensorOffsets(), "");
    bench.box().faults().digits = {3, 3, 3, 3};
    bench.run(Seconds(10.0));
    EXPECT_EQ(asked(bench), 1);
    EXPECT_EQ(bench.mount().sensorOffsets(), kReported);
    EXPECT_FALSE(bench.ordered());
    bench.box().restart(bench.clock().now());
    bench.run(Seconds(10.0));
    EXPECT_EQ(asked(bench), 2);
}

TEST(Esp32OffsetsOfTheMount, RandomNumbersAreNotBelieved)
{
    Esp32Bench bench;
    while (asked(bench) == 0) {
        bench.run(kOneTick);
        if (asked(bench) == 1) {
            bench.box().faults().digits = {3, 3, 3, 0};  // between the report and the question
        }
    }
    bench.run(Seconds(5.0));
    EXPECT_EQ(bench.mount().sensorOffsets(), "");
    bench.box().faults().digits = {3, 3, 3, 3};
    bench.run(Seconds(5.0));
    EXPECT_EQ(bench.mount().sensorOffsets(), kReported);
}

// REQ-GS232-103: If the box came back with other offsets than those saved in the profile, an alarm says so, with
// the remedy. It ends when the offsets agree again, or when the present ones are saved. Without saved offsets nothing
// is compared.
TEST(Esp32OffsetsOfTheMount, OtherOffsetsThanTheSavedRaiseAnAlarm)
{
    Esp32Bench bench;
    bench.run(Seconds(10.0));
    EXPECT_FALSE(bench.isActive("rotator.offsets")) << "none are saved";
    save(bench, bench.mount().sensorOffsets());
    bench.run(Seconds(1.0));
    EXPECT_FALSE(bench.isActive("rotator.offsets"));

    bench.box().faults().offsets.magnetometer = {40, 5, 6};
    bench.box().restart(bench.clock().now());
    bench.run(Seconds(10.0));
    ASSERT_TRUE(bench.isActive("rotator.offsets"));
    EXPECT_NE(bench.mount().sensorOffsets().find("magnetometer 40 5 6"), std::string::npos) << "for the page Console";
    save(bench, bench.mount().sensorOffsets());
    bench.run(Seconds(1.0));
    EXPECT_FALSE(bench.isActive("rotator.offsets"));
}

}  // namespace
}  // namespace boresight::gs232
