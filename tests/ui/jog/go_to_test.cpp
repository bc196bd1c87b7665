// SPDX-License-Identifier: GPL-3.0-or-later
// The go-to line with its recent directions, and the nearest allowed direction after a refusal.
#include "tests/ui/jog/jog_desk_fixture.h"
#include "ui/jog/nearest_offer.h"
#include "ui/kit/touch_combo.h"
#include "ui/sky/polar_plot.h"

#include <QAbstractItemView>

namespace boresight::ui {
namespace {

// REQ-UI-02c: Accepted go-tos can be chosen again. Presets are in the profile and are applied without other edits.
TEST_F(JogDeskTest, TheLastTenDirectionsThatWereAcceptedCanBeChosenAgain)
{
    QSignalSpy kept(&window, &MainWindow::recentGoTosChanged);
    auto* const recent = named<TouchCombo>("Recent directions");
    EXPECT_FALSE(recent->isEnabled());
    for (int azimuth = 10; azimuth <= 130; azimuth += 10) {
        goTo(std::to_string(azimuth).c_str(), "20");
    }
    goTo("100", "20");  // repeated: it moves to the front and is not doubled
    EXPECT_EQ(recent->count(), 10);
    EXPECT_EQ(recent->itemText(0), QStringLiteral("az 100.00°  el 20.00°"));
    EXPECT_EQ(recent->itemText(1), QStringLiteral("az 130.00°  el 20.00°"));
    ASSERT_EQ(kept.count(), 14);
    EXPECT_EQ(kept.back().front().toStringList().front(), QStringLiteral("100.00 20.00"));

    requests.clear();
    recent->setFocus();
    recent->showPopup();
    QTest::keyClick(recent->view(), Qt::Key_Down);
    QTest::keyClick(recent->view(), Qt::Key_Return);
    EXPECT_EQ(named<QLineEdit>("Azimuth")->text(), QStringLiteral("130.00"));
    EXPECT_TRUE(requests.empty()) << "selecting moves nothing";
    QTest::keyClick(named<CommandButton>("Go"), Qt::Key_Space);
    ASSERT_EQ(asked<request::PointSky>().size(), 1u);
    EXPECT_NEAR(asked<request::PointSky>().front().direction.azimuth.degrees(), 130.0, 1e-9);
}

// REQ-UI-400: A go-to with one empty field moves only the other axis. The button Horizon uses the azimuth that is
// entered.
TEST_F(JogDeskTest, AnEmptyFieldKeepsItsAxis)
{
    auto* const azimuth = named<QLineEdit>("Azimuth");
    auto* const elevation = named<QLineEdit>("Elevation");
    azimuth->clear();
    elevation->setText(QStringLiteral("12.5"));
    click("Go");
    ASSERT_EQ(asked<request::PointAxis>().size(), 1u);
    EXPECT_EQ(asked<request::PointAxis>().back().axis, Axis::Elevation);
    EXPECT_NEAR(asked<request::PointAxis>().back().angle.degrees(), 12.5, 1e-9);
    give(samples::acceptance(holding(), requests.back().id));
    EXPECT_EQ(named<TouchCombo>("Recent directions")->count(), 0) << "it is no direction";
    azimuth->setText(QStringLiteral(" 315 "));
    elevation->clear();
    click("Go");
    ASSERT_EQ(asked<request::PointAxis>().size(), 2u);
    EXPECT_EQ(asked<request::PointAxis>().back().axis, Axis::Azimuth);
    EXPECT_NEAR(asked<request::PointAxis>().back().angle.degrees(), 315.0, 1e-9);
    give(samples::acceptance(holding(), requests.back().id));
    click("Horizon");
    ASSERT_TRUE(asked<request::Horizon>().back().azimuth.has_value());
    EXPECT_NEAR(asked<request::Horizon>().back().azimuth->degrees(), 315.0, 1e-9);
    give(samples::acceptance(holding(), requests.back().id));
    azimuth->clear();
    click("Horizon");
    EXPECT_FALSE(asked<request::Horizon>().back().azimuth.has_value());
    give(samples::acceptance(holding(), requests.back().id));

    requests.clear();
    click("Go");
    EXPECT_TRUE(requests.empty()) << "both are empty";
    EXPECT_TRUE(text("Refused direction").contains(QStringLiteral("Enter an azimuth, an elevation or both")));
    elevation->setText(QStringLiteral("1o"));
    click("Go");
    EXPECT_TRUE(requests.empty());
    EXPECT_TRUE(text("Refused direction").contains(QStringLiteral("The elevation is not a number.")));
    QTest::keyClicks(elevation, QStringLiteral("0"));
    EXPECT_EQ(text("Refused direction"), QString()) << "it was about what stood there before";
}

// Story: a click into a field with an old number placed the cursor, and the typed digits were added to that number.
// REQ-UI-1790: A click into a go-to field selects its number, so that typing replaces the number. The next click places
// the cursor.
TEST_F(JogDeskTest, AClickIntoAFieldSelectsItsNumber)
{
    for (const char* const name : {"Azimuth", "Elevation"}) {
        auto& field = *named<QLineEdit>(name);
        field.setText(QStringLiteral("113.50"));
        named<QPushButton>("Presets, home, horizon, unwrap")->setFocus();
        QTest::mouseClick(&field, Qt::LeftButton);
        EXPECT_EQ(field.selectedText(), QStringLiteral("113.50")) << name;
        QTest::mouseClick(&field, Qt::LeftButton);
        EXPECT_FALSE(field.hasSelectedText()) << name;
        named<QPushButton>("Presets, home, horizon, unwrap")->setFocus();
        QTest::mouseClick(&field, Qt::LeftButton);
        QTest::keyClicks(&field, QStringLiteral("20"));
        EXPECT_EQ(field.text(), QStringLiteral("20")) << name;
    }
    EXPECT_TRUE(requests.empty());
}

// REQ-UI-952: The go-to line is shown on every tab. In the guide it is hidden, because the guide needs its room.
TEST_F(JogDeskTest, TheGoToLineIsThereOnEveryTab)
{
    for (const char panel : kPanels) {
        openPanel(panel);
        EXPECT_TRUE(named<CommandButton>("Go")->isVisible()) << panel;
        EXPECT_TRUE(named<CommandButton>("Park")->isVisible()) << panel;
    }
    const int sky = window.findChild<PolarPlot*>()->width();
    QTest::mouseClick(named<QPushButton>("Presets, home, horizon, unwrap"), Qt::LeftButton);
    QApplication::processEvents();
    EXPECT_EQ(window.findChild<PolarPlot*>()->width(), sky) << "the sky keeps its size";
    QTest::keyClick(&window, Qt::Key_F3);
    EXPECT_FALSE(named<CommandButton>("Go")->isVisible());
    QTest::keyClick(&window, Qt::Key_G, Qt::ControlModifier);
    EXPECT_TRUE(named<QLineEdit>("Azimuth")->hasFocus());
    EXPECT_TRUE(named<CommandButton>("Go")->isVisible());
    QTest::keyClick(&window, Qt::Key_F3);
    QTest::keyClick(&window, Qt::Key_P, Qt::ControlModifier);
    EXPECT_TRUE(named<CommandButton>("Park")->isVisible()) << "a refusal would be seen";
}

// Story: after Ctrl+G, two numbers and Enter the first Esc only left the field, and the mount moved on.
TEST_F(JogDeskTest, AfterGoByEnterTheFirstEscStops)
{
    QTest::keyClick(&window, Qt::Key_G, Qt::ControlModifier);
    auto& azimuth = *named<QLineEdit>("Azimuth");
    QTest::keyClicks(&azimuth, QStringLiteral("20"));
    auto& elevation = *named<QLineEdit>("Elevation");
    elevation.setFocus();
    QTest::keyClicks(&elevation, QStringLiteral("30"));
    QTest::keyClick(&elevation, Qt::Key_Return);
    give(samples::acceptance(holding(), requests.back().id));
    EXPECT_FALSE(elevation.hasFocus());
    QTest::keyClick(&window, Qt::Key_Escape);
    EXPECT_EQ(asked<request::Stop>().size(), 1U);
}

// REQ-UI-02c
TEST_F(JogDeskTest, ARefusedDirectionIsNotRemembered)
{
    named<QLineEdit>("Azimuth")->setText(QStringLiteral("10"));
    named<QLineEdit>("Elevation")->setText(QStringLiteral("95"));
    click("Go");
    give(samples::refusal(holding(), requests.back().id, "elevation 95.0° above limit 90.0°"));
    EXPECT_EQ(named<TouchCombo>("Recent directions")->count(), 0);
}

// REQ-UI-02f: Beside the refusal of a direction one button goes to the nearest allowed direction, which the station has
// computed. If there is none, there is no button.
TEST_F(JogDeskTest, ARefusedDirectionOffersTheNearestAllowedOne)
{
    const auto refused = [this] {
        named<QLineEdit>("Azimuth")->setText(QStringLiteral("315"));
        named<QLineEdit>("Elevation")->setText(QStringLiteral("10"));
        click("Go");
        give(samples::refusal(holding(), requests.back().id, "315.0° / 10.0° lies in keep-out \"x\""));
        give(samples::update(holding()));
    };
    refused();
    EXPECT_TRUE(window.findChild<NearestOffer*>()->isHidden()) << "the station knows no other direction";
    judge = [](const SkyPointing&) {
        return DirectionVerdict{.whyNot = QStringLiteral("x"), .nearest = SkyPointing{330_deg, 25_deg}};
    };
    refused();
    auto& offer = *window.findChild<NearestOffer*>();
    ASSERT_TRUE(offer.isVisible());
    EXPECT_EQ(offer.text(), QStringLiteral("Go to az 330.0°  el 25.0°"));
    QTest::mouseClick(&offer, Qt::LeftButton);
    EXPECT_EQ(asked<request::PointSky>().back().direction, (SkyPointing{330_deg, 25_deg}));
    give(samples::acceptance(holding(), requests.back().id));
    EXPECT_TRUE(offer.isHidden());
    refused();
    ASSERT_TRUE(offer.isVisible());
    QTest::keyClicks(named<QLineEdit>("Azimuth"), QStringLiteral("1"));
    EXPECT_TRUE(offer.isHidden()) << "the refusal was about another direction";
}

// REQ-UI-02g: The refusal of one axis alone also offers the nearest allowed direction. For the other axis the present
// direction of the beam counts. The same holds for the refusal of Park, whose position may lie behind a new horizon.
TEST_F(JogDeskTest, ARefusedAxisOffersTheNearestAllowedDirection)
{
    std::vector<SkyPointing> judged;
    judge = [&judged](const SkyPointing& at) {
        judged.push_back(at);
        return DirectionVerdict{.whyNot = QStringLiteral("x"), .nearest = SkyPointing{330_deg, 25_deg}};
    };
    StationStatus status = holding();
    status.actual = SkyPointing{200_deg, 40_deg};
    give(samples::update(status));
    const auto refusedGoTo = [&](const char* azimuth, const char* elevation) {
        named<QLineEdit>("Azimuth")->setText(QLatin1String(azimuth));
        named<QLineEdit>("Elevation")->setText(QLatin1String(elevation));
        click("Go");
        give(samples::refusal(status, requests.back().id, "elevation 1.0° is below the horizon"));
        give(samples::update(status));
    };
    auto& offer = *window.findChild<NearestOffer*>();
    refusedGoTo("", "1");
    ASSERT_TRUE(offer.isVisible());
    EXPECT_EQ(judged.back(), (SkyPointing{200_deg, 1_deg}));
    QTest::mouseClick(&offer, Qt::LeftButton);
    EXPECT_EQ(asked<request::PointSky>().back().direction, (SkyPointing{330_deg, 25_deg}));
    give(samples::acceptance(status, requests.back().id));
    EXPECT_TRUE(offer.isHidden());
    EXPECT_EQ(named<TouchCombo>("Recent directions")->count(), 0) << "one axis is no direction";

    refusedGoTo("315", "");
    EXPECT_TRUE(offer.isVisible());
    EXPECT_EQ(judged.back(), (SkyPointing{315_deg, 40_deg}));
    status.actual.reset();
    give(samples::update(status));
    refusedGoTo("315", "");
    EXPECT_TRUE(offer.isHidden()) << "nobody knows which direction that would be";
}

// REQ-UI-02g
TEST_F(JogDeskTest, ARefusedParkOffersTheNearestAllowedDirection)
{
    SkyPointing judged;
    judge = [&judged](const SkyPointing& at) {
        judged = at;
        return DirectionVerdict{.whyNot = QStringLiteral("x"), .nearest = SkyPointing{0_deg, 15_deg}};
    };
    StationStatus status = holding();
    profile::Profile profile = *status.profile;
    profile.park = {.azimuth = 10_deg, .elevation = 2_deg};
    profile.pointing.azimuthOffset = 20_deg;
    status.profile = std::make_shared<const profile::Profile>(profile);
    status.permissions.refuse(Action::Park, QStringLiteral("The park position lies below the horizon."));
    give(samples::update(status));
    QTest::keyClick(&window, Qt::Key_P, Qt::ControlModifier);
    give(samples::update(status));
    auto& offer = *window.findChild<NearestOffer*>();
    ASSERT_TRUE(offer.isVisible());
    EXPECT_NEAR(judged.azimuth.degrees(), 30.0, 1e-9) << "where the beam would look, not what the axis shows";
    EXPECT_TRUE(text("Refused direction").startsWith(QStringLiteral("Park: ")));
    QTest::mouseClick(&offer, Qt::LeftButton);
    EXPECT_EQ(asked<request::PointSky>().back().direction, (SkyPointing{0_deg, 15_deg}));
}

TEST_F(JogDeskTest, DirectionsOfAnEarlierStartComeBackAndRubbishDoesNot)
{
    WindowSettings earlier = settings();
    earlier.recentGoTos = {QStringLiteral("113.50 10.00"), QStringLiteral("rubbish"), QStringLiteral("1 2 3")};
    const MainWindow other(clock, earlier);
    for (const TouchCombo* const box : other.findChildren<TouchCombo*>()) {
        if (box->accessibleName() == QStringLiteral("Recent directions")) {
            ASSERT_EQ(box->count(), 1);
            EXPECT_EQ(box->itemText(0), QStringLiteral("az 113.50°  el 10.00°"));
        }
    }
}

}  // namespace
}  // namespace boresight::ui
