// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/targets/target_text.h"

#include "tests/fakes/text_of.h"

#include <gmock/gmock.h>

#include <string>
#include <vector>

namespace boresight::targets {
namespace {

using testing::HasSubstr;

std::vector<orbit::ElementSet> known()
{
    return {{.name = "ISS (ZARYA)", .number = 25544}, {.name = "NOAA 19", .number = 33591},
            {.name = "NOAA 20", .number = 43013},     {.name = "SWISSCUBE", .number = 35932},
            {.name = "FO29", .number = 24278},        {.name = "", .number = 99}};
}

Target read(std::string_view text)
{
    const Result<Target> target = parseTarget(text, known());
    EXPECT_TRUE(target) << text << ": " << (target ? "" : textOf(target.error()));
    return target.value_or(Target{});
}

std::string refusal(std::string_view text)
{
    const Result<Target> target = parseTarget(text, known());
    return target ? "" : textOf(target.error());
}

std::string nameOf(std::string_view text)
{
    return read(text).name.toStdString();
}

// REQ-TARGETS-910: Sun, Moon, planets and radio sources are read by their names, ignoring case and blanks.
TEST(TargetText, ReadsBodiesByName)
{
    EXPECT_TRUE(isSun(read("sun")));
    EXPECT_FALSE(isSun(read("Moon")));
    EXPECT_EQ(nameOf(" JUPITER "), "Jupiter");
    for (const char* const text : {"cas a", "Cas A", "cas-a", "CAS_A"}) {
        EXPECT_EQ(nameOf(text), "Cas A") << text;
    }
    EXPECT_EQ(nameOf("Sgr A*"), "Sgr A*");
    EXPECT_EQ(std::get<ephemeris::SkyObject>(read("mars").kind), ephemeris::SkyObject(ephemeris::Planet::Mars));
}

// REQ-TARGETS-911: A satellite is read by its number, its name, or words that occur only in its name. If several match
// they are named.
TEST(TargetText, ReadsSatellitesByNumberAndName)
{
    const auto number = [](std::string_view text) { return std::get<orbit::ElementSet>(read(text).kind).number; };
    EXPECT_EQ(number("25544"), 25544);
    EXPECT_EQ(number("iss (zarya)"), 25544);
    EXPECT_EQ(number("iss"), 25544) << "not in SWISSCUBE";
    EXPECT_EQ(number("noaa 19"), 33591);
    EXPECT_EQ(number("FO29"), 24278) << "a locator, too";
    EXPECT_EQ(nameOf("99"), "99");
    EXPECT_EQ(refusal("noaa"),
              "2 satellites have that name, among them NOAA 19 (33591), NOAA 20 (43013). Enter the number.");
    EXPECT_THAT(refusal("noaa 1"), HasSubstr("not a known satellite")) << "not NOAA 19";
    EXPECT_THAT(refusal("12345"), HasSubstr("\"12345\" is not a known satellite, a body or a locator"));
    EXPECT_THAT(refusal(""), HasSubstr("The bodies are: sun, moon"));
    EXPECT_THAT(refusal("12345"), testing::Not(HasSubstr("knows no satellites")));
    EXPECT_THAT(textOf(parseTarget("iss", {}).error()),
                testing::EndsWith("sgr-a. Boresight knows no satellites. Add their elements."));
}

// REQ-TARGETS-912: A locator means the centre of its square, by the short path or the long path.
TEST(TargetText, ReadsLocators)
{
    const auto place = std::get<EarthPosition>(read("im58kr").kind);
    EXPECT_NEAR(place.site.latitude.degrees(), 38.7292, 1e-3);
    EXPECT_NEAR(place.site.longitude.degrees(), -9.125, 1e-3);
    EXPECT_EQ(place.path, GreatCircle::Short);
    EXPECT_EQ(std::get<EarthPosition>(read("IM58kr long").kind).path, GreatCircle::Long);
    EXPECT_EQ(nameOf("IM58kr long"), "IM58kr, long path");
    EXPECT_EQ(nameOf("JN58"), "JN58");
}

// REQ-TARGETS-913: Directions, celestial coordinates and positions are read from their numbers. Invalid numbers are
// refused with an example.
TEST(TargetText, ReadsNumbers)
{
    EXPECT_EQ(std::get<SkyPointing>(read("azel 120.5,30").kind), (SkyPointing{120.5_deg, 30_deg}));
    EXPECT_EQ(nameOf("azel -90, 12"), "270.00° 12.00°");
    const auto star =
        std::get<ephemeris::StarPlace>(std::get<ephemeris::SkyObject>(read("radec 12:30:49.4,12:23:28").kind));
    EXPECT_NEAR(star.rightAscension.degrees(), 187.7058, 1e-4);
    EXPECT_NEAR(star.declination.degrees(), 12.3911, 1e-4);
    EXPECT_NEAR(parseStarPlace("0.5,-0:30").value().declination.degrees(), -0.5, 1e-9);
    EXPECT_EQ(std::get<EarthPosition>(read("place 38.757,-9.117,1200").kind).site,
              (Site{38.757_deg, -9.117_deg, 1200.0}));
    EXPECT_EQ(std::get<EarthPosition>(read("PLACE 38.757,-9.117").kind).site.heightMetres, 0.0);
    for (const char* const text : {"azel 120", "azel 1,2,3", "azel x,3", "azel 500,3", "azel 1,91", "azel nan,3"}) {
        EXPECT_THAT(refusal(text), HasSubstr("\"azel 120.5,30\"")) << text;
    }
    for (const char* const text : {"radec 12", "radec 24,3", "radec 12:60,3", "radec 12,91", "radec -1,3", "radec ,"}) {
        EXPECT_THAT(refusal(text), HasSubstr("\"radec 12.514,12.391\"")) << text;
    }
    for (const char* const text : {"place 91,0", "place 1", "place 1,2,3,4", "place 1,2,1e9", "place a,b"}) {
        EXPECT_THAT(refusal(text), HasSubstr("\"place 38.757,-9.117,1200\"")) << text;
    }
}

// REQ-TARGETS-914: "table FILE" and "oem FILE" name a file. Other texts name no file.
TEST(TargetText, NamesTheFileOfATable)
{
    EXPECT_EQ(tableFile(" Table  /tmp/My pass.csv "), QStringLiteral("/tmp/My pass.csv"));
    EXPECT_EQ(tableFile("OEM a.oem"), QStringLiteral("a.oem"));
    for (const char* const text : {"table", "tables x", "iss", "", "azel 1,2"}) {
        EXPECT_FALSE(tableFile(text)) << text;
    }
}

}  // namespace
}  // namespace boresight::targets
