// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/recording/column.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <limits>
#include <random>

namespace boresight::recording {
namespace {

constexpr std::int64_t kLeast = std::numeric_limits<std::int64_t>::min();
constexpr std::int64_t kMost = std::numeric_limits<std::int64_t>::max();

QByteArray columnBytes(const Column& column)
{
    QByteArray bytes;
    appendColumn(bytes, column);
    return bytes;
}

void expectSame(const Column& column)
{
    const QByteArray bytes = columnBytes(column);
    ByteSource source(bytes);
    EXPECT_EQ(takeColumn(source, column.size()), column);
    EXPECT_TRUE(source.atEnd());
}

TEST(RecordedColumn, EveryColumnReadsAsItWasWritten)
{
    expectSame({});
    expectSame({std::nullopt});
    expectSame({7});
    expectSame({std::nullopt, 7, std::nullopt});
    expectSame({kLeast, kMost, 0, kMost, kLeast, std::nullopt, -1});
    expectSame({5, 5, 5, 5});
    std::mt19937_64 random(17);
    for (int round = 0; round < 300; ++round) {
        Column column(random() % 200);
        const auto shift = random() % 64;
        std::int64_t sum = 0;
        for (auto& value : column) {
            sum = static_cast<std::int64_t>(static_cast<std::uint64_t>(sum) + (random() >> shift));
            value = random() % 16 == 0 ? std::nullopt : std::optional(sum);
        }
        expectSame(column);
    }
}

TEST(RecordedColumn, HasTheBytesOfThePage)
{
    EXPECT_EQ(columnBytes({std::nullopt, std::nullopt}).toHex(), "00");
    // The constant 300 is 600 as zigzag: 0xd8 0x04.
    EXPECT_EQ(columnBytes({300, 300, 300}).toHex(), "01d804");
    // First differences: 10 (zigzag 20), then 1, 3, 0: least 0, 2 bits each: 01 11 00 from the lowest bit = 0x0d.
    EXPECT_EQ(columnBytes({10, 11, 14, 14}).toHex(), "021400020d");
    // Rows 0 and 2 of 3 are known: bits 101.
    EXPECT_EQ(columnBytes({4, std::nullopt, 4}).toHex(), "810508");
}

TEST(RecordedColumn, ASteadyMotionTakesAFewBytes)
{
    Column column;
    for (int i = 0; i < 500; ++i) {
        column.emplace_back(1'000'000 + 731 * i);
    }
    EXPECT_LT(columnBytes(column).size(), 45);
}

}  // namespace
}  // namespace boresight::recording
