// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/gs232/esp32_offsets.h"

#include <gtest/gtest.h>

namespace boresight::gs232::esp32 {
namespace {

constexpr Offsets kOffsets{.accelerometer = {-1, 2, 3},
                           .magnetometer = {-400, 5, 6},
                           .gyroscope = {7, 8, -9},
                           .accelerometerRadius = 1000,
                           .magnetometerRadius = 700};

TEST(Esp32Offsets, AreReadAsTheyAreWritten)
{
    const std::string text = offsetsText(kOffsets);
    EXPECT_EQ(text, "accelerometer -1 2 3, magnetometer -400 5 6, gyroscope 7 8 -9, radii 1000 700");
    EXPECT_EQ(parseOffsets(text), kOffsets);
    for (const char* const wrong :
         {"", "accelerometer 1 2 3", "accelerometer 1 2, magnetometer 4 5 6, gyroscope 7 8 9, radii 1 2",
          "accelerometer 1 2 3, magnetometer 4 5 6, gyroscope 7 8 9, radii 1 2 3",
          "accelerometer 1 2 3, magnetometer 4 5 6, gyroscope 7 8 9, radii 1 2, x",
          "accelerometer 1 2 x, magnetometer 4 5 6, gyroscope 7 8 9, radii 1 2",
          "accelerometer 1 2 40000, magnetometer 4 5 6, gyroscope 7 8 9, radii 1 2",
          "magnetometer 4 5 6, accelerometer 1 2 3, gyroscope 7 8 9, radii 1 2"}) {
        EXPECT_FALSE(parseOffsets(wrong)) << wrong;
    }
}

TEST(Esp32Offsets, TheLinesOfAnAnswerAreCollected)
{
    OffsetLines lines;
    for (const char* const line :
         {"Accel Off: -1,2,3", "Mag   Off: -400, 5, 6", "Gyro  Off: 7,8,-9", "Accel Rad: 1000"}) {
        EXPECT_TRUE(lines.take(line)) << line;
        EXPECT_FALSE(lines.offsets()) << line;
    }
    for (const char* const wrong : {"", "RPRT 0", "Mag   Rad: ", "Mag   Rad: 7x", "Mag Off: 4,5,6", "Mag   Off: 4,5",
                                    "Mag   Off: 4,5,6,7", "Mag   Off: 4 5 6"}) {
        EXPECT_FALSE(lines.take(wrong)) << wrong;
    }
    EXPECT_FALSE(lines.offsets());
    EXPECT_TRUE(lines.take("Mag   Rad: 700"));
    EXPECT_EQ(lines.offsets(), kOffsets);
}

// REQ-GS232-101: Offsets are alike if they give the same angles within 2°: 35 mg of the accelerometer, 11/16 µT of the
// magnetometer, 1 °/s of the gyroscope. The radii shift no angle.
TEST(Esp32Offsets, AreComparedByTheAnglesThatTheyGive)
{
    const auto alike = [](const auto& change) {
        Offsets other = kOffsets;
        change(other);
        return areAlike(kOffsets, other);
    };
    EXPECT_TRUE(alike([](Offsets& o) { o.accelerometer[1] += 35; }));
    EXPECT_FALSE(alike([](Offsets& o) { o.accelerometer[1] -= 36; }));
    EXPECT_TRUE(alike([](Offsets& o) { o.magnetometer[2] -= 11; }));
    EXPECT_FALSE(alike([](Offsets& o) { o.magnetometer[2] += 12; }));
    EXPECT_TRUE(alike([](Offsets& o) { o.gyroscope[0] += 16; }));
    EXPECT_FALSE(alike([](Offsets& o) { o.gyroscope[0] += 17; }));
    EXPECT_TRUE(alike([](Offsets& o) { o.accelerometerRadius = o.magnetometerRadius = 480; }));
}

}  // namespace
}  // namespace boresight::gs232::esp32
