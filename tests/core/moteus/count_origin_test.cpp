// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/moteus/count_origin.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

namespace boresight::moteus {
namespace {

// The end of the record "motor_position" as serialised by fw/motor_position.h of April 2026: 0.625 turns reported,
// -0.25 turns counted since power-up.
const std::vector<std::uint8_t> kRecord{3, 1, 1,                                // epoch, valid, ever valid
                                        0, 0, 0,    0,    0, 0xc0, 0xff, 0xff,  // -0.25 * 2^48
                                        0, 0, 0x80, 0xbe,                       // -0.25f
                                        0, 0, 0,    0,    0, 0,    0,    0,     // modulo
                                        0, 0, 0,    0,    0, 0xa0, 0,    0,     // 0.625 * 2^48
                                        0, 0, 0x20, 0x3f,                       // 0.625f
                                        2,                                      // output
                                        0, 0, 0,    0,                          // velocity
                                        1, 0, 0,    0,    0};                   // electrical angle

std::string telemetry(const std::vector<std::uint8_t>& end, std::size_t before = 178)
{
    return '\0' + std::string(before, '\x5a') + std::string(end.begin(), end.end());
}

// REQ-MOTEUS-11 (CountOrigin.*): The origin of a drive's position is read from the end of its telemetry record,
// whatever comes before. Other records are refused. Telemetry arrives as lines or as a block of bytes.
TEST(CountOrigin, IsReadFromTheEndWhateverTheEncodersTake)
{
    for (const std::size_t before : {std::size_t{0}, std::size_t{1}, std::size_t{178}, std::size_t{500}}) {
        const auto origin = countOrigin(telemetry(kRecord, before));
        ASSERT_TRUE(origin) << before;
        EXPECT_EQ(origin->offset.turns(), 0.875);
        EXPECT_EQ(origin->beginning, 0x010103U);
    }
}

TEST(CountOrigin, DoesNotChangeWhenTheCountersRunOver)
{
    auto record = kRecord;
    // +32767.75, and after 0.875 turns more -32767.375: the count wraps by 65536 turns.
    const std::vector<std::uint8_t> relative{0, 0, 0, 0, 0, 0xc0, 0xff, 0x7f, 0x80, 0xff, 0xff, 0x46};
    const std::vector<std::uint8_t> position{0, 0, 0, 0, 0, 0xa0, 0x00, 0x80, 0xc0, 0xfe, 0xff, 0xc6};
    std::ranges::copy(relative, record.begin() + 3);
    std::ranges::copy(position, record.begin() + 23);
    const auto origin = countOrigin(telemetry(record));
    ASSERT_TRUE(origin);
    EXPECT_EQ(origin->offset.turns(), 0.875);
}

// A record with another layout would give an arbitrary number.
TEST(CountOrigin, IsNotReadFromWhatIsNoSuchRecord)
{
    EXPECT_FALSE(countOrigin(""));
    EXPECT_FALSE(countOrigin(telemetry(kRecord, 0).substr(1)));
    EXPECT_FALSE(countOrigin(std::string(223, '\0')));
    EXPECT_FALSE(countOrigin("motor_position.error 0 and more than forty-five characters of text"));
    for (std::size_t shift = 1; shift < 12; ++shift) {
        EXPECT_FALSE(countOrigin(telemetry(kRecord) + std::string(shift, '\0'))) << shift;
        EXPECT_FALSE(countOrigin(telemetry(kRecord).substr(0, 224 - shift))) << shift;
    }
    std::string failed = telemetry(kRecord);
    failed.front() = 3;
    EXPECT_FALSE(countOrigin(failed)) << "its encoder does not answer: it counts nothing";
    auto invalid = kRecord;
    invalid[2] = 0;
    EXPECT_FALSE(countOrigin(telemetry(invalid))) << "no encoder yet";
    auto homeless = kRecord;
    homeless[35] = 3;
    EXPECT_FALSE(countOrigin(telemetry(homeless)));
    auto torn = kRecord;
    torn[14] = 0x40;
    EXPECT_FALSE(countOrigin(telemetry(torn))) << "count and number disagree";
}

}  // namespace
}  // namespace boresight::moteus
