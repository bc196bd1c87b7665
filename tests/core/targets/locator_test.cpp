// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/targets/locator.h"

#include "tests/fakes/text_of.h"

#include <gtest/gtest.h>

#include <limits>

using namespace boresight;
using namespace boresight::targets;

namespace {

GeoPoint at(double latitude, double longitude)
{
    return {.latitude = Angle::fromDegrees(latitude), .longitude = Angle::fromDegrees(longitude)};
}

std::string locatorOf(const GeoPoint& place, LocatorLength length)
{
    return toLocator(place, length).value_or("refused");
}

struct Reference
{
    double latitude;
    double longitude;
    const char* locator;  // 8 or 10 characters
};

// Values that many locator libraries use in their tests: W1AW, K6WRU, Munich, Montevideo, Washington, Wellington. With
// ten characters (centres): ARRL, Perth, Santiago.
const Reference kReferences[] = {
    {41.714775, -72.727260, "FN31pr21"},
    {37.413708, -122.1073236, "CM87wj79"},
    {48.14666, 11.60833, "JN58td25"},
    {-34.91, -56.21166, "GF15vc41"},
    {38.92, -77.065, "FM18lw20"},
    {-41.28333, 174.745, "RE78ir92"},
    {41.71484375, -72.72829861, "FN31pr21on"},
    {-31.949433295, 115.860217556, "OF78wb32fd"},
    {-33.453021464, -70.679750362, "FF46pn81kg"},
};

}  // namespace

// REQ-PROFILE-15 (Locator.*): Locators of 4 to 10 characters, both ways, agree with published values.
TEST(Locator, AgreesWithPublishedValues)
{
    for (const Reference& reference : kReferences) {
        const std::string whole = reference.locator;
        for (std::size_t length = 4; length <= whole.size(); length += 2) {
            EXPECT_EQ(locatorOf(at(reference.latitude, reference.longitude), static_cast<LocatorLength>(length)),
                      whole.substr(0, length));
        }
        const auto place = fromLocator(whole);
        ASSERT_TRUE(place) << whole;
        const bool isFine = whole.size() == 10;
        EXPECT_NEAR(place->latitude.degrees(), reference.latitude, isFine ? 0.5 / 5760 : 0.5 / 240) << whole;
        EXPECT_NEAR(place->longitude.degrees(), reference.longitude, isFine ? 0.5 / 2880 : 0.5 / 120) << whole;
    }
}

TEST(Locator, IsTheCentreOfItsSquare)
{
    const auto check = [](const char* text, double latitude, double longitude) {
        const auto place = fromLocator(text);
        ASSERT_TRUE(place) << text;
        EXPECT_NEAR(place->latitude.degrees(), latitude, 1e-9) << text;
        EXPECT_NEAR(place->longitude.degrees(), longitude, 1e-9) << text;
    };
    check("JN58", 48.5, 11.0);
    check("JN48QM", 48.0 + 12.5 / 24.0, 9.0 + 4.5 / 12.0);  // 48.5208333, 9.375
    check("jn58TD25", 48.14791666667, 11.60416666667);
    check("GF15vc41", -34.91041666667, -56.2125);
    check("FN31pr21on", 41.71484375, -72.72829861111);
    check("AA00aa00aa", -90.0 + 0.5 / 5760, -180.0 + 0.5 / 2880);
}

TEST(Locator, ThereAndBackIsTheSame)
{
    for (const char* text : {"AA00", "RR99", "IO91wm", "RR99xx", "AA00aa00", "QF56od51", "RR99xx99xx", "JJ00aa00aa"}) {
        const auto place = fromLocator(text);
        ASSERT_TRUE(place) << text;
        EXPECT_EQ(locatorOf(*place, static_cast<LocatorLength>(std::string_view(text).size())), text);
    }
}

TEST(Locator, TheEdgesOfTheGlobeAreInASquare)
{
    EXPECT_EQ(locatorOf(at(-90, -180), LocatorLength::Six), "AA00aa");
    EXPECT_EQ(locatorOf(at(90, 0), LocatorLength::Ten), "JR09ax09ax");
    EXPECT_EQ(locatorOf(at(0, 180), LocatorLength::Six), "AJ00aa") << "180° east is 180° west";
    EXPECT_EQ(locatorOf(at(0, 0), LocatorLength::Eight), "JJ00aa00");
    EXPECT_EQ(locatorOf(at(38, -10), LocatorLength::Ten), "IM58aa00aa") << "an edge belongs to the square it begins";
}

TEST(Locator, RefusesWhatIsNone)
{
    for (const char* text : {"", "JN", "JN5", "JN58t", "JN58td2", "JN58td25u", "JN58td25ulx", "SN58", "JS58", "J158",
                             "JN5x", "JN58yd", "JN58tY", "JN58td2a", "JN58td25uy", "JN58 t", "JN58t\xc3"}) {
        EXPECT_FALSE(fromLocator(text)) << text;
    }
    EXPECT_EQ(textOf(fromLocator("JN58tz").error()), "character 6 of a locator is one of a…x");
    EXPECT_FALSE(toLocator(at(90.1, 0)));
    EXPECT_FALSE(toLocator(at(std::numeric_limits<double>::quiet_NaN(), 0)));
    EXPECT_FALSE(toLocator(at(0, std::numeric_limits<double>::infinity())));
}
