// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/can/line_checksum.h"

#include <gtest/gtest.h>

namespace boresight::fdcanusb {
namespace {

TEST(LineChecksum, MatchesTheMakersExamples)
{
    EXPECT_EQ(crc8(""), 0);
    EXPECT_EQ(withChecksum("OK"), "OK *BD");
    EXPECT_EQ(withChecksum("can send 8001 720c64cfd792"), "can send 8001 720c64cfd792 *25");
}

TEST(LineChecksum, IsTakenOffAndJudged)
{
    EXPECT_EQ(splitChecksum("OK *BD").text, "OK");
    EXPECT_EQ(splitChecksum("OK *BD").checksum, Checksum::Right);
    EXPECT_EQ(splitChecksum("OK *bd").checksum, Checksum::Right);
    EXPECT_EQ(splitChecksum("OK").checksum, Checksum::Absent);
    for (const char* const bad : {"OK *BE", "OK *", "OK *B", "OK *BDBD", "OK *BD ", "OK*BD", "OL *BD"}) {
        EXPECT_EQ(splitChecksum(bad).checksum, Checksum::Wrong) << bad;
    }
}

}  // namespace
}  // namespace boresight::fdcanusb
