// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/wind/wind_text.h"

#include <gtest/gtest.h>

namespace boresight::wind {
namespace {

// Returns -1 if the text is refused.
double speedOf(std::string_view text, const Format& format = {})
{
    return readWind(text, format).value_or(-1.0);
}

// REQ-WIND-02: A reading is a number, optionally preceded by the key or the word "wind", or a JSON object with the key.
// A point in the key leads into an object inside the object.
TEST(WindText, IsANumberOrAnObject)
{
    EXPECT_EQ(speedOf("12.3"), 12.3);
    EXPECT_EQ(speedOf(" 0\r\n"), 0.0);
    EXPECT_EQ(speedOf("wind 12.3\n"), 12.3);
    EXPECT_EQ(speedOf("gust  7", {.key = "gust"}), 7.0);
    EXPECT_EQ(speedOf("wind 7", {.key = "gust"}), 7.0);
    EXPECT_EQ(speedOf(R"({"temp": 21.5, "wind": 12.3})"), 12.3);
    EXPECT_EQ(speedOf(R"({"wind": "12.3"})"), 12.3);
    EXPECT_EQ(speedOf(R"({"wind": {"speed": 4, "gust": 9.5}})", {.key = "wind.gust"}), 9.5);
    EXPECT_EQ(speedOf(R"({"wind.gust": 3, "wind": {"gust": 9.5}})", {.key = "wind.gust"}), 3.0);
}

// REQ-WIND-03: A reading in km/h or in knots is converted to m/s, and every limit is in m/s.
TEST(WindText, IsConverted)
{
    EXPECT_NEAR(speedOf("54", {.unit = Unit::KilometresPerHour}), 15.0, 1e-12);
    EXPECT_NEAR(speedOf(R"({"wind": 30})", {.unit = Unit::Knots}), 15.4333, 1e-4);
    EXPECT_NEAR(speedOf("500", {.unit = Unit::KilometresPerHour}), 138.889, 1e-3);
}

// REQ-WIND-04: A text that is not clearly a wind speed is refused with the reason, and an unreadable number never
// becomes 0: garbage, several numbers, negative speeds, more than 150 m/s, a missing key, more than 4096 bytes.
TEST(WindText, AllElseIsRefused)
{
    for (const char* const text : {"",
                                   "\n",
                                   "wind",
                                   "calm",
                                   "12,3",
                                   "12.3 m/s",
                                   "12 13",
                                   "gust 12",
                                   "-1",
                                   "nan",
                                   "inf",
                                   "151",
                                   "1e9",
                                   "0x10",
                                   "{",
                                   "{}",
                                   "[12.3]",
                                   R"({"speed": 12.3})",
                                   R"({"wind": null})",
                                   R"({"wind": true})",
                                   R"({"wind": {"speed": 12}})",
                                   R"({"wind": "strong"})",
                                   R"({"wind": -3})",
                                   R"({"wind": 1e300})",
                                   "\xff\xfe"}) {
        EXPECT_EQ(speedOf(text), -1.0) << text;
    }
    EXPECT_EQ(speedOf(R"({"wind": 5})", {.key = "wind.gust"}), -1.0);
    EXPECT_EQ(speedOf(std::string(4097, ' ') + "5"), -1.0);
    EXPECT_EQ(speedOf(std::string(4000, ' ') + "5"), 5.0);
    EXPECT_EQ(speedOf(std::string("5\0", 2)), -1.0);
    EXPECT_EQ(readWind("strong", {}).error().text, QStringLiteral("the wind speed is not a number"));
}

}  // namespace
}  // namespace boresight::wind
