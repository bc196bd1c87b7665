// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/power/power_text.h"

#include "tests/fakes/text_of.h"

#include <gtest/gtest.h>

namespace boresight::power {
namespace {

std::optional<double> read(std::string_view line)
{
    const auto power = parsePower(line);
    return power ? std::optional(*power) : std::nullopt;
}

// REQ-POWER-01: A number in dB is read alone, after a name, or beside a frequency. The decimal separator may be a
// comma.
TEST(PowerText, ANumberOrANameWithIt)
{
    EXPECT_EQ(read("-73.2"), -73.2);
    EXPECT_EQ(read("  12 \r"), 12.0);
    EXPECT_EQ(read("+3.5 dB"), 3.5);
    EXPECT_EQ(read("RSSI: -73.2 dBm\r\n"), -73.2);
    EXPECT_EQ(read("STRENGTH -73.2"), -73.2);
    EXPECT_EQ(read("l=1e1"), 10.0);
    EXPECT_EQ(read("-73.2dBFS."), -73.2);
    EXPECT_EQ(read("{\"power\": -73.2}"), -73.2);
    EXPECT_EQ(read("CH2 -40.5"), -40.5);  // 2 is part of a name
}

// REQ-POWER-01
TEST(PowerText, ACommaMayStandForThePoint)
{
    EXPECT_EQ(read("-73,2"), -73.2);  // as a German or Portuguese program writes it
    EXPECT_EQ(read("-73,2,1"), std::nullopt);
    EXPECT_EQ(read("1,234.5"), std::nullopt);
    EXPECT_EQ(read("-73,-74"), std::nullopt);
}

// REQ-POWER-01
TEST(PowerText, TheOneInDecibelsAmongOthers)
{
    EXPECT_EQ(read("VFO 14.074 MHz -73 dBm"), -73.0);
    EXPECT_EQ(read("14.074MHz -73.5dB"), -73.5);
    EXPECT_EQ(read("14074000 Hz -73"), -73.0);
    EXPECT_EQ(read("2026-11-22T01:30:00 -73.2 dB"), -73.2);
    EXPECT_EQ(read("14074000 -73.2 dBm 5"), -73.2);
}

// Story: in a line with several numbers the first one was used.
// REQ-POWER-02: An ambiguous line is refused with the reason and never guessed: "S7", two numbers, another unit, a
// date.
TEST(PowerText, WhatIsNotSureIsRefused)
{
    for (const char* const line : {"",
                                   "no number",
                                   "- . e",
                                   "S7",
                                   "S9+10dB",
                                   "14.074 -73",
                                   "-73.2, -74.1",
                                   "-73.2 dB -74.1 dB",
                                   "-73.2 at 1200",
                                   "-- 12",
                                   "- 73",
                                   "RSSI-73.2",
                                   "VFO 14.074 MHz",
                                   "5 mW",
                                   "30 %",
                                   "2026-11-22",
                                   "01:30:00 -73.2",
                                   "1.2.3",
                                   "0x10",
                                   "nan",
                                   "inf",
                                   "1e400",
                                   "501",
                                   "-73.2 µV"}) {
        EXPECT_EQ(read(line), std::nullopt) << line;
    }
}

// REQ-POWER-02
TEST(PowerText, TheReasonIsTold)
{
    EXPECT_EQ("it contains no number", textOf(parsePower("S7").error()));
    EXPECT_EQ("it contains several numbers, and none is clearly the power", textOf(parsePower("14.074 -73").error()));
    EXPECT_EQ("its unit is not dB", textOf(parsePower("5 mW").error()));
    EXPECT_EQ("its number is ambiguous", textOf(parsePower("- 73").error()));
    EXPECT_EQ("a power above 500 dB is not possible", textOf(parsePower("14074000").error()));
}

}  // namespace
}  // namespace boresight::power
