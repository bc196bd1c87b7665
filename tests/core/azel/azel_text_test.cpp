// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/azel/azel_text.h"

#include "tests/fakes/text_of.h"

#include <gmock/gmock.h>

#include <cmath>
#include <string>

namespace boresight::azel {
namespace {

using testing::HasSubstr;

// The text that WSJT-X 2.6.1 wrote for IM58KS on 2026-11-24.
const std::string kSample =
    "22:30:04,105.3, 59.9,Moon\n"
    "22:30:04,298.4,-59.7,Sun\n"
    "22:30:04,  0.0,  0.0,Source\n"
    " 1296,  2189.0,   -4.41,  1625.0,   -9.79,Doppler, R\n";
const std::string kPol = "    -7.5,     0.3,    -0.1,    14.5,     9.9,Pol\n";

std::string replaced(std::string text, const std::string& what, const std::string& by)
{
    const std::size_t at = text.find(what);
    EXPECT_NE(at, std::string::npos) << what;
    return at != std::string::npos ? text.replace(at, what.size(), by) : text;
}

std::string reasonOf(const std::string& text)
{
    const auto read = readAzelText(text);
    return read ? "none" : textOf(read.error());
}

// REQ-AZEL-900: The text of WSJT-X is read: the time, Moon, Sun, whether the radio transmits, frequency and Dopplers.
// The line of its source is never used as a direction. Both kinds of line ends and additional lines change nothing.
TEST(AzelText, ReadsWhatWsjtxWrites)
{
    for (const std::string& text : {kSample, kSample + kPol, kSample + "any,thing\n" + kPol}) {
        const auto read = readAzelText(text);
        ASSERT_TRUE(read) << textOf(read.error());
        EXPECT_EQ(read->timeOfDay, std::chrono::hours(22) + std::chrono::minutes(30) + std::chrono::seconds(4));
        EXPECT_EQ(read->moon, (SkyPointing{105.3_deg, 59.9_deg}));
        EXPECT_EQ(read->sun, (SkyPointing{298.4_deg, -59.7_deg}));
        EXPECT_EQ(read->radio, Radio::Receives);
        EXPECT_EQ(read->megahertz, 1296.0);
        EXPECT_EQ(read->dxDoppler, 2189.0);
        EXPECT_EQ(read->selfDoppler, 1625.0);
    }
    std::string windows = kSample;
    for (std::size_t at = windows.find('\n'); at != std::string::npos; at = windows.find('\n', at + 2)) {
        windows.insert(at, "\r");
    }
    EXPECT_EQ(readAzelText(windows), readAzelText(kSample));
    EXPECT_EQ(readAzelText(replaced(kSample, ", R", ", T"))->radio, Radio::Transmits);
}

// REQ-AZEL-901: 360.0 and -0.0 are read as 0. A Moon below the horizon is valid. If a field is too narrow for its
// number, only this number is lost.
TEST(AzelText, ReadsTheOddNumbers)
{
    const auto moonOf = [](const std::string& place) {
        return readAzelText(replaced(kSample, "105.3, 59.9", place))->moon;
    };
    EXPECT_EQ(moonOf("360.0, 59.9").azimuth, Angle{});
    EXPECT_EQ(moonOf(" -0.0, 59.9").azimuth, Angle{});
    const Angle low = moonOf("  0.0, -0.0").elevation;
    EXPECT_EQ(low, Angle{});
    EXPECT_FALSE(std::signbit(low.radians()));
    EXPECT_EQ(moonOf("  0.0,-26.3").elevation, -26.3_deg);
    EXPECT_EQ(moonOf("005.0,-90.0"), (SkyPointing{5_deg, -90_deg}));

    const auto high = readAzelText(replaced(kSample, " 1296", "*****"));
    ASSERT_TRUE(high);
    EXPECT_EQ(high->megahertz, std::nullopt);
    EXPECT_EQ(high->radio, Radio::Receives);
    const auto first = readAzelText(replaced(kSample, "   -4.41", "********"));
    ASSERT_TRUE(first);
    EXPECT_EQ(first->selfDoppler, 1625.0);
    EXPECT_TRUE(readAzelText(replaced(kSample, "298.4,-59.7", " -1.5,  0.5"))) << "MAP65 tests the pointing";
}

// REQ-AZEL-902: The forms of related programs are read: without the flag, with whole Dopplers, with lines of
// frequencies, with two lines of the same name, and without the last line end.
TEST(AzelText, ReadsWhatTheRelativesWrite)
{
    const auto wsjt = readAzelText(replaced(kSample, ",Doppler, R", ",Doppler"));
    ASSERT_TRUE(wsjt);
    EXPECT_EQ(wsjt->radio, std::nullopt);
    EXPECT_EQ(wsjt->selfDoppler, 1625.0);

    const auto qmap = readAzelText(
        "22:30:04,105.3, 59.9,Moon\n22:30:04,298.4,-59.7,Sun\n22:30:04,  0.0,  0.0,Source\n"
        "1296,  2189,  1625,Doppler\n 125,1,fQSO\n 130,0,fQSO2\n");
    ASSERT_TRUE(qmap);
    EXPECT_EQ(qmap->dxDoppler, 2189.0);
    EXPECT_EQ(qmap->selfDoppler, 1625.0);

    const auto early = readAzelText(
        "22:30:04,105.3,059.9,Moon\n22:30:04,298.4,-59.7,Sun\n22:30:04,000.0,000.0,Sun\n"
        "  1296,  1625,Doppler\n 125,1,fQSO\n 130,0,fQSO2");
    ASSERT_TRUE(early);
    EXPECT_EQ(early->moon, (SkyPointing{105.3_deg, 59.9_deg}));
    EXPECT_EQ(early->sun, (SkyPointing{298.4_deg, -59.7_deg}));
}

// REQ-AZEL-903: A text that is cut anywhere is refused, unless no needed part is missing. A text with two times is
// refused, too.
TEST(AzelText, NothingIsTakenOfACutOrTornText)
{
    const auto whole = readAzelText(kSample + kPol);
    for (std::size_t length = 0; length < kSample.size(); ++length) {
        EXPECT_FALSE(readAzelText(kSample.substr(0, length))) << length;
    }
    for (std::size_t length = kSample.size(); length < kSample.size() + kPol.size(); ++length) {
        EXPECT_EQ(readAzelText((kSample + kPol).substr(0, length)), whole);
    }
    EXPECT_EQ(reasonOf(""), "the file is empty");
    EXPECT_EQ(reasonOf(" \r"), "the file is empty");
    EXPECT_EQ(reasonOf(kSample.substr(0, 40)), "the file is cut: the line of the Sun or of the Doppler is missing");
    EXPECT_EQ(reasonOf(replaced(kSample, "22:30:04,298.4", "22:30:05,298.4")),
              "The file is half written. Moon and Sun have different times.");
}

// REQ-AZEL-904: Any other text is refused, with a reason that repeats no part of it: other formats, invalid numbers or
// numbers out of range, texts that are too long, binary data, the form of AirScout.
TEST(AzelText, RefusesEverythingElse)
{
    for (const char* const place :
         {"  nan, 59.9", "  inf, 59.9", "360.1, 59.9", " -0.1, 59.9", "105.3, 90.1", "105.3,-90.1", "1.0e2, 59.9",
          "*****, 59.9", "     , 59.9", "1 5.3, 59.9", "105,3, 59.9", "0x1.0, 59.9", "105.3, 5..9", "105.3,"}) {
        const std::string reason = reasonOf(replaced(kSample, "105.3, 59.9", place));
        EXPECT_NE(reason, "none") << place;
        EXPECT_EQ(reason.find(place), std::string::npos);
    }
    for (const char* const time : {"24:30:04", "22:60:04", "22:30:60", "22-30-04", "2:30:04", "22:30:4", "-2:30:04",
                                   "22:+3:04", "        ", "22:30:04Z"}) {
        EXPECT_EQ(reasonOf(replaced(kSample, "22:30:04", time)), "the time of the Moon cannot be read") << time;
    }
    EXPECT_EQ(reasonOf("105.3,59.9\n"), "the file is from AirScout and has another form");
    EXPECT_EQ(reasonOf("# some notes\n"), "The file has no line for the Moon.");
    EXPECT_EQ(reasonOf(replaced(kSample, "Moon", "Mooo")), "The file has no line for the Moon.");
    EXPECT_THAT(reasonOf(kSample + std::string(1, '\0')), HasSubstr("characters that are not plain text"));
    EXPECT_THAT(reasonOf(std::string(132, '\0')), HasSubstr("characters that are not plain text"));
    EXPECT_THAT(reasonOf(kSample + "\x1b[2J\n"), HasSubstr("characters that are not plain text"));
    EXPECT_THAT(reasonOf(kSample + std::string(kLongestAzelText, 'x')), HasSubstr("longer than 512 bytes"));
    EXPECT_THAT(reasonOf(std::string(kLongestAzelText, '\n')), HasSubstr("no line for the Moon"));
}

}  // namespace
}  // namespace boresight::azel
