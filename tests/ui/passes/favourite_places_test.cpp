// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/passes/favourite_places.h"

#include "tests/ui/passes/passes_fixture.h"
#include "ui/sky/polar_plot.h"

#include <chrono>

namespace boresight::ui {
namespace {

using namespace std::chrono_literals;

const UtcTime kPlacesAt{std::chrono::sys_days{std::chrono::year{2026} / 3 / 1} + 5h};

class FavouritePlacesTest : public ::testing::Test
{
protected:
    // Satellites all around the Earth, so that at each moment some are up.
    FavouritePlacesTest()
    {
        std::vector<orbit::ElementSet> all;
        for (int i = 0; i < 300; ++i) {
            orbit::ElementSet one =
                fakes::lowOrbit(kPlacesAt, Angle::fromDegrees(36.0 * (i % 10)), Angle::fromDegrees(12.0 * i));
            one.number = 1 + i;
            one.name = "SAT " + std::to_string(1 + i);
            all.push_back(one);
        }
        satellites = std::make_shared<const std::vector<orbit::ElementSet>>(all);
    }
    static orbit::SatelliteMarks favourites(int count)
    {
        orbit::SatelliteMarks marks;
        for (int number = 1; number <= count; ++number) {
            orbit::setFavourite(marks, number, true);
        }
        return marks;
    }

    const Site site{.latitude = 38.757_deg, .longitude = -9.117_deg};
    Satellites satellites;
    FavouritePlaces places;
};

// REQ-PASSES-966: The sky shows the favourites that are up, each with its name, at most the 20 highest. The tracked
// satellite has its own mark.
TEST_F(FavouritePlacesTest, AreThoseThatAreUp)
{
    EXPECT_TRUE(places.at(kPlacesAt, {}).empty());
    places.setBasis(satellites, favourites(150), site);
    const auto up = places.at(kPlacesAt, {});
    ASSERT_GT(up.size(), 1U);
    ASSERT_LE(up.size(), kMostFavouritePlaces);
    const orbit::Observer observer(site);
    const orbit::JulianDate date = orbit::julianDate(kPlacesAt);
    int expected = 0;
    for (const orbit::ElementSet& one : *satellites) {
        const auto state = orbit::Sgp4(one).propagate(date);
        const SkyPointing direction = observer.look(orbit::groundState(*state, date)).direction;
        const bool isUp = one.number <= 150 && direction.elevation >= 0_deg;
        expected += isUp ? 1 : 0;
        EXPECT_EQ(
            std::ranges::count(up, SatellitePlace{.name = QString::fromStdString(one.name), .direction = direction}),
            isUp ? 1 : 0);
    }
    EXPECT_EQ(up.size(), static_cast<std::size_t>(expected));
    const std::int64_t first = up.front().name.mid(4).toLongLong();
    EXPECT_EQ(places.at(kPlacesAt, first).size(), up.size() - 1) << "the tracked one is drawn already";
    places.setBasis(satellites, favourites(150), std::nullopt);
    EXPECT_TRUE(places.at(kPlacesAt, {}).empty()) << "without a site nobody knows";
}

TEST(SkySatellites, NamesDoNotLieOverEachOther)
{
    SkySatellites marks;
    marks.setSky({.zenith = {200.0, 200.0}, .radius = 180.0});
    const std::vector<SatellitePlace> places{
        {.name = QStringLiteral("ALPHA"), .direction = {.azimuth = 90_deg, .elevation = 45_deg}},
        {.name = QStringLiteral("BETA"), .direction = {.azimuth = 91_deg, .elevation = 45_deg}},
        {.name = QStringLiteral("GAMMA"), .direction = {.azimuth = 270_deg, .elevation = 1_deg}}};
    EXPECT_FALSE(marks.show(places).isEmpty());
    ASSERT_EQ(marks.marks().size(), 3U);
    EXPECT_FALSE(marks.marks()[0].text.isEmpty());
    EXPECT_TRUE(marks.marks()[1].text.isEmpty());
    EXPECT_GT(marks.marks()[2].text.left(), marks.marks()[2].pixel.x()) << "on the disc";
    EXPECT_TRUE(marks.show(places).isEmpty()) << "nothing has moved";
    EXPECT_FALSE(marks.show({}).isEmpty());
    EXPECT_TRUE(marks.marks().empty());
}

class FavouritesInTheSkyTest : public PassesFixture
{};

TEST_F(FavouritesInTheSkyTest, ThePlotShowsThemOnEachPage)
{
    StationStatus status = withSatellites();
    profile::Profile profile = *status.profile;
    profile.satellites = {{.number = 40069, .favourite = orbit::Favourite::On, .note = {}}};
    status.profile = std::make_shared<const profile::Profile>(profile);
    giveFound(status);
    const auto& model = *qobject_cast<PassTable*>(table().model());
    int row = 0;
    while (model.book()->elementsOf(model.pass(row)).number != 40069) {
        ++row;
    }
    const UtcTime highest = model.pass(row).pass.tca.utc;
    openPanel('1');
    const SkySatellites& shown = window.findChild<PolarPlot*>()->markers().satellites();
    status.utc = highest;
    give(samples::update(status));
    ASSERT_EQ(shown.marks().size(), 1U);
    EXPECT_EQ(shown.marks().front().name.toStdString(), "BETA");
    profile.satellites.clear();
    status.profile = std::make_shared<const profile::Profile>(profile);
    status.utc += 1s;
    give(samples::update(status));
    EXPECT_TRUE(shown.marks().empty());
}

}  // namespace
}  // namespace boresight::ui
