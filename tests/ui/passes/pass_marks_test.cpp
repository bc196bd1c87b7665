// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/ui/event_loop.h"
#include "tests/ui/passes/passes_fixture.h"
#include "ui/kit/command_button.h"
#include "ui/passes/note_line.h"
#include "ui/passes/passes_panel.h"

#include <QComboBox>
#include <QLineEdit>
#include <QToolButton>

#include <gmock/gmock.h>

namespace boresight::ui {
namespace {

using testing::HasSubstr;

// Favourites and notes, as the profile of the station has them.
class MarkedPassesTest : public PassesFixture
{
protected:
    MarkedPassesTest() { giveFound(status); }

    // Puts the last requested profile into effect.
    void accept()
    {
        status.profile = std::make_shared<const profile::Profile>(asked<request::ApplyProfile>().back().profile);
        StationUpdate applied = samples::update(status);
        applied.answers.push_back({.requestId = requests.back().id});
        give(applied);
    }
    void refuse() { give(samples::refusal(status, requests.back().id, "no")); }
    void mark(orbit::SatelliteMarks marks)
    {
        profile::Profile profile = *status.profile;
        profile.satellites = std::move(marks);
        status.profile = std::make_shared<const profile::Profile>(profile);
        give(samples::update(status));
    }
    [[nodiscard]] orbit::SatelliteMarks askedMarks() const
    {
        return asked<request::ApplyProfile>().empty() ? orbit::SatelliteMarks()
                                                      : asked<request::ApplyProfile>().back().profile.satellites;
    }
    [[nodiscard]] int numberOf(int row)
    {
        const auto& model = *qobject_cast<PassTable*>(table().model());
        return static_cast<int>(model.book()->elementsOf(model.pass(row)).number);
    }
    QString star(int row)
    {
        return table().model()->index(row, PassTable::Favourite).data(Qt::AccessibleTextRole).toString();
    }
    NoteLine& note() { return *named<NoteLine>("Note about the satellite"); }

    StationStatus status = withSatellites();
};

// REQ-PASSES-960: A click on the star of a row, Space, or the button makes the satellite a favourite of the profile, or
// removes it from the favourites. The list can be limited to favourites.
TEST_F(MarkedPassesTest, AClickOnTheStarMakesAFavourite)
{
    const QRect cell = table().visualRect(table().model()->index(1, PassTable::Favourite));
    EXPECT_GE(cell.width(), kRowHeight);
    EXPECT_EQ(star(1), QStringLiteral("No favourite"));
    QTest::mouseClick(table().viewport(), Qt::LeftButton, {}, cell.center());
    EXPECT_EQ(askedMarks(),
              (orbit::SatelliteMarks{{.number = numberOf(1), .favourite = orbit::Favourite::On, .note = {}}}));
    EXPECT_EQ(star(1), QStringLiteral("No favourite")) << "the screen follows the next status";
    accept();
    EXPECT_EQ(star(1), QStringLiteral("Favourite"));
    QTest::keyClick(&table(), Qt::Key_Space);
    EXPECT_TRUE(askedMarks().empty());
    accept();
    EXPECT_EQ(star(1), QStringLiteral("No favourite"));
}

TEST_F(MarkedPassesTest, TheButtonDoesTheSame)
{
    window.resize(1280, 1000);
    settle();
    QTest::mouseClick(named<CommandButton>("Add to favourites"), Qt::LeftButton);
    ASSERT_EQ(askedMarks().size(), 1U);
    accept();
    EXPECT_EQ(star(0), QStringLiteral("Favourite"));
    EXPECT_NE(named<CommandButton>("Remove from favourites"), nullptr);
}

TEST_F(MarkedPassesTest, FavouritesOnly)
{
    mark({{.number = 25544, .favourite = orbit::Favourite::On, .note = {}}, {.number = 40069, .note = "a note"}});
    auto* const only = named<QToolButton>("Favourites only");
    QTest::mouseClick(only, Qt::LeftButton);
    EXPECT_EQ(names(), (std::vector<std::string>{"ALPHA ONE"}));
    mark({});
    EXPECT_EQ(rows(), 0);
    EXPECT_EQ(text("The selected pass"), QString());
    EXPECT_THAT(text("About the passes").toStdString(), HasSubstr("No favourite passes"));
    QTest::mouseClick(only, Qt::LeftButton);
    EXPECT_EQ(names().size(), 3U);
}

// REQ-ANTENNA-931: If there are several antennas, one can be chosen for a satellite beside its note, and is stored in
// the profile. With one antenna there is nothing to choose.
TEST_F(MarkedPassesTest, AnAntennaIsChosenForASatellite)
{
    window.resize(1280, 1000);
    settle();
    auto* const antenna = named<QComboBox>("Antenna for the satellite");
    EXPECT_FALSE(antenna->isVisible());
    profile::Profile profile = *status.profile;
    profile.antennas = {{.name = "70 cm"}};
    status.profile = std::make_shared<const profile::Profile>(profile);
    give(samples::update(status));
    ASSERT_TRUE(antenna->isVisible());
    EXPECT_EQ(antenna->count(), 3);
    EXPECT_EQ(antenna->currentText(), QStringLiteral("as chosen by hand"));
    settle();
    EXPECT_GT(antenna->width(), antenna->fontMetrics().horizontalAdvance(QStringLiteral("as chosen by hand")));
    antenna->setCurrentIndex(2);
    Q_EMIT antenna->activated(2);
    EXPECT_EQ(askedMarks(), (orbit::SatelliteMarks{{.number = numberOf(0), .note = {}, .antenna = "70 cm"}}));
    EXPECT_EQ(antenna->currentText(), QStringLiteral("as chosen by hand")) << "the screen follows the next status";
    accept();
    EXPECT_EQ(antenna->currentText(), QStringLiteral("70 cm"));
}

// REQ-PASSES-961: A satellite has a note of one line, for example about frequency and polarisation. It is shown with
// the selected pass and edited there. Enter, or leaving the line, stores it in the profile. Esc reverts it.
TEST_F(MarkedPassesTest, ANoteIsTypedAndStored)
{
    window.resize(1280, 1000);
    settle();
    note().setFocus();
    QTest::keyClicks(&note(), QStringLiteral("145.800 MHz FM"));
    EXPECT_TRUE(requests.empty()) << "typing stores nothing";
    give(samples::update(status));
    EXPECT_EQ(note().text(), QStringLiteral("145.800 MHz FM")) << "a status leaves what is being typed";
    QTest::keyClick(&note(), Qt::Key_Return);
    EXPECT_EQ(askedMarks(), (orbit::SatelliteMarks{{.number = numberOf(0), .note = "145.800 MHz FM"}}));
    accept();
    QTest::keyClicks(&note(), QStringLiteral(", RHCP"));
    named<QLineEdit>("Satellites to list")->setFocus(Qt::TabFocusReason);
    EXPECT_EQ(askedMarks().front().note, "145.800 MHz FM, RHCP");
    accept();
    note().setFocus();
    QTest::keyClicks(&note(), QStringLiteral("xxx"));
    QTest::keyClick(&window, Qt::Key_Escape);
    EXPECT_EQ(note().text(), QStringLiteral("145.800 MHz FM, RHCP"));
    EXPECT_EQ(asked<request::ApplyProfile>().size(), 2U);
    EXPECT_TRUE(asked<request::Stop>().empty());
}

TEST_F(MarkedPassesTest, ARefusedNoteStaysToBeCorrected)
{
    window.resize(1280, 1000);
    settle();
    note().setFocus();
    QTest::keyClicks(&note(), QStringLiteral("137 MHz"));
    QTest::keyClick(&note(), Qt::Key_Return);
    refuse();
    EXPECT_EQ(note().text(), QStringLiteral("137 MHz"));
    EXPECT_THAT(text("Refused").toStdString(), HasSubstr("Note: no"));
}

TEST_F(MarkedPassesTest, TheNoteIsThatOfTheSelectedSatellite)
{
    mark({{.number = numberOf(0), .note = "first"}});
    EXPECT_EQ(note().text(), QStringLiteral("first"));
    int other = 1;
    while (numberOf(other) == numberOf(0)) {
        ++other;
    }
    table().selectRow(other);
    give(samples::update(status));
    EXPECT_EQ(note().text(), QString());
    table().selectRow(0);
    give(samples::update(status));
    EXPECT_EQ(note().text(), QStringLiteral("first"));
    EXPECT_TRUE(requests.empty());
}

}  // namespace
}  // namespace boresight::ui
