// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/elements/element_address.h"

#include <gmock/gmock.h>

namespace boresight::orbit {
namespace {

using testing::HasSubstr;
using testing::MatchesRegex;
using testing::SizeIs;

std::string reasonOf(std::string_view entry)
{
    const auto address = parseElementAddress(entry);
    return address ? "taken" : address.error().text.toStdString();
}

// REQ-ELEMENTWEB-01: Elements come from a group of CelesTrak by its name, or from any https address. Plain http is
// refused, except for this computer. Each refusal has a reason.
TEST(ElementAddress, AGroupOfCelestrakIsTheAddressThatItDocuments)
{
    const auto group = parseElementAddress("celestrak:Stations");
    ASSERT_TRUE(group);
    EXPECT_EQ(group->name, QStringLiteral("CelesTrak group stations"));
    EXPECT_EQ(group->url.toEncoded().toStdString(),
              "https://celestrak.org/NORAD/elements/gp.php?GROUP=stations&FORMAT=json");
    EXPECT_THAT(group->file.toStdString(), MatchesRegex("celestrak-stations-[0-9a-f]{12}"));
    for (const char* const bad : {"celestrak:", "celestrak:a b", "celestrak:x&FORMAT=tle", "celestrak:../x"}) {
        EXPECT_THAT(reasonOf(bad), HasSubstr("is not the name of a CelesTrak group")) << bad;
    }
}

// REQ-ELEMENTWEB-01
TEST(ElementAddress, HttpsIsTakenAndPlainHttpOnThisComputerOnly)
{
    const auto address = parseElementAddress("https://example.org/sets/a.json?key=secret#top");
    ASSERT_TRUE(address);
    EXPECT_EQ(address->name, QStringLiteral("https://example.org/sets/a.json?…")) << "a query may hold a secret";
    EXPECT_EQ(address->url.toEncoded().toStdString(), "https://example.org/sets/a.json?key=secret");
    EXPECT_THAT(address->file.toStdString(), MatchesRegex("example.org-[0-9a-f]{12}"));
    for (const char* const mirror : {"http://localhost:8080/a", "http://127.0.0.1/a", "http://[::1]:80/a"}) {
        EXPECT_EQ(reasonOf(mirror), "taken") << mirror;
    }
    EXPECT_THAT(reasonOf("http://example.org/a"), HasSubstr("does not begin with https://"));
    EXPECT_THAT(reasonOf("http://127.0.0.1.example.org/a"), HasSubstr("does not begin with https://"));
    EXPECT_THAT(reasonOf("file:///etc/passwd"), HasSubstr("is not an address"));
    EXPECT_THAT(reasonOf("ftp://example.org/a"), HasSubstr("does not begin with https://"));
    EXPECT_THAT(reasonOf("https://"), HasSubstr("is not an address"));
    EXPECT_THAT(reasonOf("https://a b/"), HasSubstr("is not an address"));
    EXPECT_THAT(reasonOf("https://example.org/" + std::string(3000, 'a')), HasSubstr("is not an address"));
    EXPECT_THAT(reasonOf("https://me:word@example.org/a"), HasSubstr("user name or a password"));
}

TEST(ElementAddress, APathIsNoAddress)
{
    EXPECT_FALSE(isElementAddress("/srv/elements"));
    EXPECT_FALSE(isElementAddress("/srv/odd://name"));
    EXPECT_FALSE(isElementAddress("weather.tle"));
    EXPECT_TRUE(isElementAddress("celestrak:"));
    EXPECT_TRUE(isElementAddress("http://example.org"));
    EXPECT_THAT(elementAddresses({"/srv/a.tle", "celestrak:weather", "celestrak:Weather", "http://example.org/a"}),
                SizeIs(1));
}

}  // namespace
}  // namespace boresight::orbit
