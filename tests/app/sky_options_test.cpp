// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/boresightctl/sky_options.h"

#include "tests/fakes/text_of.h"

#include <gmock/gmock.h>

namespace boresight::ctl {
namespace {

using testing::HasSubstr;

using Line = std::vector<std::string>;

const Line kPasses{"--elements", "a.tle", "--site", "38.757,-9.117,80", "--from", "2024-05-10", "--days=2"};
const Line kEphemeris{"--elements=a.tle", "--norad", "25544", "--site", "38.757,-9.117,80", "--times", "-"};

Line with(Line line, const Line& more)
{
    line.insert(line.end(), more.begin(), more.end());
    return line;
}

std::string refusalOfPasses(const Line& line)
{
    const auto options = parsePassesOptions(line);
    return options ? "accepted" : textOf(options.error());
}

std::string refusalOfEphemeris(const Line& line)
{
    const auto options = parseEphemerisOptions(line);
    return options ? "accepted" : textOf(options.error());
}

TEST(SkyOptions, AreReadInAnyOrderWithBlankOrEquals)
{
    const auto options =
        parsePassesOptions(with(kPasses, {"--min-el=-2.5", "--elements", "more", "--format", "table", "--norad", "7"}));
    ASSERT_TRUE(options) << textOf(options.error());
    EXPECT_EQ(options->elements, (std::vector<std::string>{"a.tle", "more"}));
    EXPECT_EQ(options->site, (Site{38.757_deg, -9.117_deg, 80.0}));
    EXPECT_EQ(options->days, 2.0);
    EXPECT_EQ(options->minimumElevation, -2.5_deg);
    EXPECT_EQ(options->format, TableFormat::Table);
    EXPECT_EQ(options->number, 7);
    EXPECT_TRUE(parseEphemerisOptions(kEphemeris));
    EXPECT_TRUE(parsePassesOptions(with(kPasses, {"--from", "now"})));
}

TEST(SkyOptions, ASiteMayBeAFileOfGpredict)
{
    const auto options = parsePassesOptions(with(kPasses, {"--site", "/x/home.qth"}));
    ASSERT_TRUE(options) << textOf(options.error());
    EXPECT_FALSE(options->site);
    EXPECT_EQ(options->siteFile, QStringLiteral("/x/home.qth"));
    EXPECT_EQ(parsePassesOptions(with({"--site", "/x/home.qth"}, kPasses))->siteFile, QString());
}

// REQ-CTL-03: An option that is missing, unknown, in the wrong place or has an invalid value is refused with its name
// and the expected value.
TEST(SkyOptions, AreRefusedWithWhatIsExpected)
{
    EXPECT_EQ(refusalOfPasses({}), "--elements FILE is missing");
    EXPECT_EQ(refusalOfPasses({"--elements", "a"}), "--site LAT,LON,ALT is missing");
    EXPECT_THAT(refusalOfPasses({"--elements", "http://example.org/a"}),
                HasSubstr("--elements: \"http://example.org/a\" does not begin with https://"));
    EXPECT_EQ(refusalOfPasses({"--elements", "a", "--site", "1,2,3"}), "--from UTC is missing");
    EXPECT_EQ(refusalOfPasses({"--elements", "a", "--site", "1,2,3", "--from", "now"}), "--days D is missing");
    EXPECT_EQ(refusalOfPasses({"--times", "a"}), "there is no option --times");
    EXPECT_EQ(refusalOfPasses({"--elements", "--site"}), "--elements needs a value");
    EXPECT_THAT(refusalOfPasses({"a.tle"}), HasSubstr("\"a.tle\" is not an option"));
    for (const char* const site : {"38.757,-9.117", "91,0,0", "0,361,0", "0,0,1e6", "0,0,0,0", "0,0,x", "nan,0,0"}) {
        EXPECT_THAT(refusalOfPasses(with(kPasses, {"--site", site})), HasSubstr("expected LAT,LON,ALT (degrees north"));
    }
    for (const char* const days : {"0", "-1", "3661", "two", "inf"}) {
        EXPECT_THAT(refusalOfPasses(with(kPasses, {"--days", days})),
                    HasSubstr("expected a number above 0, up to 3660"));
    }
    EXPECT_THAT(refusalOfPasses(with(kPasses, {"--min-el", "90"})),
                HasSubstr("expected degrees above -90 and below 90"));
    EXPECT_THAT(refusalOfPasses(with(kPasses, {"--norad", "1.5"})), HasSubstr("expected a catalogue number"));
    EXPECT_THAT(refusalOfPasses(with(kPasses, {"--norad", "1000000000"})), HasSubstr("expected a catalogue number"));
    EXPECT_THAT(refusalOfPasses(with(kPasses, {"--format", "xml"})), HasSubstr("expected csv, table or json"));
    EXPECT_THAT(refusalOfPasses(with(kPasses, {"--from", "soon"})), HasSubstr("--from \"soon\" is not a time"));
}

// REQ-CTL-03
TEST(SkyOptions, APlanNeedsAMountASatelliteAndATime)
{
    const auto refusal = [](const Line& line) {
        const auto options = parsePlanOptions(line);
        return options ? "accepted" : textOf(options.error());
    };
    const Line whole{"--profile", "m.toml", "--elements", "a.tle", "--norad", "7", "--from", "2024-05-10"};
    EXPECT_EQ(refusal(whole), "accepted");
    EXPECT_EQ(refusal({}), "--profile FILE is missing");
    EXPECT_EQ(refusal({whole.begin(), whole.begin() + 2}), "--elements FILE is missing");
    EXPECT_EQ(refusal({whole.begin(), whole.begin() + 4}), "--norad N is missing");
    EXPECT_EQ(refusal({whole.begin(), whole.begin() + 6}), "--from UTC is missing");
    EXPECT_EQ(refusal(with(whole, {"--site", "1,2,3"})), "there is no option --site") << "it is in the profile";
    for (const char* const bound : {"0", "-1", "181", "x"}) {
        EXPECT_THAT(refusal(with(whole, {"--bound", bound})), HasSubstr("expected degrees above 0, up to 180"));
    }
    EXPECT_EQ(parsePlanOptions(with(whole, {"--bound", "2.5"}))->bound, 2.5_deg);
    EXPECT_TRUE(parsePlanOptions(with(whole, {"--motion", "on"}))->motion);
}

// REQ-CTL-03
TEST(SkyOptions, ABodyIsNoSatellite)
{
    EXPECT_EQ(refusalOfEphemeris({"--body", "moon", "--site", "1,2,3", "--times", "-"}), "accepted");
    EXPECT_EQ(refusalOfEphemeris(with(kEphemeris, {"--refraction", "radio"})), "accepted");
    EXPECT_EQ(refusalOfEphemeris(with(kEphemeris, {"--doppler", "on"})), "accepted");
    EXPECT_EQ(refusalOfEphemeris(with(kEphemeris, {"--doppler", "yes"})), "--doppler \"yes\": expected on or off");
    EXPECT_EQ(refusalOfEphemeris({"--body", "moon", "--site", "1,2,3", "--times", "-", "--doppler", "on"}),
              "--doppler needs a satellite: add --elements and --norad");
    EXPECT_EQ(refusalOfEphemeris(with(kEphemeris, {"--refraction", "optical"})),
              "--refraction \"optical\": expected none, light or radio");
    EXPECT_EQ(refusalOfPasses(with(kPasses, {"--refraction", "light"})), "there is no option --refraction");
    EXPECT_THAT(refusalOfEphemeris({"--body", "pluto"}),
                HasSubstr("--body \"pluto\": expected one of sun, moon, mercury,"));
    EXPECT_EQ(refusalOfEphemeris({"--body", "mars", "--site", "1,2,3", "--times", "-"}), "accepted");
    EXPECT_THAT(refusalOfEphemeris(with(kEphemeris, {"--body", "sun"})),
                HasSubstr("--body and --radec need no elements"));
    EXPECT_EQ(refusalOfEphemeris({"--elements", "a.tle"}), "--norad N is missing");
    EXPECT_EQ(refusalOfEphemeris({"--body", "sun"}), "--site LAT,LON,ALT is missing");
    EXPECT_EQ(refusalOfEphemeris({"--body", "sun", "--site", "1,2,3"}), "--times FILE is missing");
}

// REQ-CTL-941
TEST(SkyOptions, ATableStandsForAllElse)
{
    EXPECT_EQ(refusalOfEphemeris({"--table", "a.oem", "--site", "1,2,3", "--times", "-"}), "accepted");
    EXPECT_THAT(refusalOfEphemeris({"--table", "a.oem", "--body", "sun", "--site", "1,2,3", "--times", "-"}),
                HasSubstr("--table is used alone"));
    EXPECT_EQ(refusalOfEphemeris({"--table", "a.oem"}), "--site LAT,LON,ALT is missing");
}

// REQ-CTL-940: Celestial coordinates are given in hours and degrees, as decimal or sexagesimal numbers.
TEST(SkyOptions, APlaceAmongTheStars)
{
    const auto placeOf = [](const char* text) {
        const std::vector<std::string> line{"--radec", text, "--site", "1,2,3", "--times", "-"};
        const Result<SkyOptions> options = parseEphemerisOptions(line);
        return options ? std::get<ephemeris::StarPlace>(*options->object) : ephemeris::StarPlace{};
    };
    EXPECT_NEAR(placeOf("12:30:49.4,12:23:28").rightAscension.degrees(), 187.705833, 1e-6);
    EXPECT_NEAR(placeOf("12:30:49.4,12:23:28").declination.degrees(), 12.391111, 1e-6);
    EXPECT_NEAR(placeOf("17.5,-0:30").declination.degrees(), -0.5, 1e-9);
    EXPECT_NEAR(placeOf("17.5,-0:30").rightAscension.degrees(), 262.5, 1e-9);
    for (const char* wrong : {"24,0", "-1,0", "1,91", "1", "1:60,0", "1:2:3:4,0", "a,b", "1,2,3", "1::2,0"}) {
        EXPECT_THAT(refusalOfEphemeris({"--radec", wrong}), HasSubstr("expected HOURS,DEGREES of J2000")) << wrong;
    }
}

}  // namespace
}  // namespace boresight::ctl
