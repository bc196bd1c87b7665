// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/ui/sample_permissions.h"
#include "tests/ui/window_fixture.h"
#include "ui/hold/jog_button.h"
#include "ui/jog/jog_panel.h"
#include "ui/jog/nearest_offer.h"
#include "ui/jog/rate_slider.h"
#include "ui/kit/choice_button.h"
#include "ui/kit/command_button.h"
#include "ui/kit/touch_combo.h"
#include "ui/sky/polar_plot.h"

#include <QAbstractItemView>
#include <QLineEdit>

namespace boresight::ui {
namespace {

// The controls around the jog pad: rate, steps and trim, go-to with its recent directions, presets, horizon and park.
class JogDeskTest : public WindowFixture
{
protected:
    JogDeskTest()
    {
        give(samples::update(holding()));
        QTest::mouseClick(named<QPushButton>("Presets, home, horizon, unwrap"), Qt::LeftButton);
    }

    static StationStatus holding()
    {
        StationStatus status = samples::bounded();
        status.state = StationState::Hold;
        return status;
    }
    static StationStatus withPresets(std::vector<profile::Preset> presets)
    {
        StationStatus status = holding();
        profile::Profile profile = *status.profile;
        profile.presets = std::move(presets);
        status.profile = std::make_shared<const profile::Profile>(profile);
        return status;
    }
    void click(const char* button) { QTest::mouseClick(named<CommandButton>(button), Qt::LeftButton); }
    RateSlider& slider() { return *named<RateSlider>("Jog rate"); }
    QLineEdit& presetName() { return *named<QLineEdit>("Name of the preset"); }
    void hold(JogDirection direction)
    {
        JogButton& button = window.findChild<JogPanel*>()->pad().button(direction);
        QTest::mousePress(&button, Qt::LeftButton);
        QTest::mouseRelease(&button, Qt::LeftButton);
    }
    void goTo(const char* azimuth, const char* elevation)
    {
        named<QLineEdit>("Azimuth")->setText(QLatin1String(azimuth));
        named<QLineEdit>("Elevation")->setText(QLatin1String(elevation));
        click("Go");
        give(samples::acceptance(holding(), requests.back().id));
    }
};

TEST_F(JogDeskTest, TheRateGoesFromSlowToFastOfTheProfileByKeysAndMouse)
{
    EXPECT_EQ(text("Rate while held"), QStringLiteral("2.0°/s"));
    slider().setFocus();
    QTest::keyClick(&slider(), Qt::Key_End);
    EXPECT_EQ(text("Rate while held"), QStringLiteral("6.0°/s"));
    hold(JogDirection::Right);
    EXPECT_EQ(asked<request::Jog>().front().rates, (AxisRates{6_deg_s, 0_deg_s}));
    QTest::keyClick(&slider(), Qt::Key_Home);
    EXPECT_EQ(text("Rate while held"), QStringLiteral("0.20°/s"));
    EXPECT_EQ(slider().accessibleDescription(), QStringLiteral("0.20°/s"));
    QTest::keyClick(&slider(), Qt::Key_Right);
    const AngularRate oneUp = slider().rate();
    EXPECT_GT(oneUp, 0.2_deg_s);
    EXPECT_LT(oneUp, 0.25_deg_s);
    QTest::mouseClick(&slider(), Qt::LeftButton, {}, QPoint(slider().width() / 2, 20));
    EXPECT_NEAR(slider().rate().degrees(), std::sqrt(0.2 * 6.0), 0.1) << "the middle is the geometric mean";
}

TEST_F(JogDeskTest, AProfileWithOtherRatesMovesTheEnds)
{
    slider().setFocus();
    QTest::keyClick(&slider(), Qt::Key_End);
    StationStatus status = holding();
    profile::Profile profile = *status.profile;
    profile.jog.fast = 3_deg_s;
    status.profile = std::make_shared<const profile::Profile>(profile);
    give(samples::update(status));
    EXPECT_EQ(text("Rate while held"), QStringLiteral("3.0°/s"));
    hold(JogDirection::Up);
    EXPECT_EQ(asked<request::Jog>().front().rates, (AxisRates{0_deg_s, 3_deg_s}));
}

TEST_F(JogDeskTest, BeforeTheDirectionsAreConfirmedOnlyJoggingIsOfferedAndNotFast)
{
    StationStatus status = holding();
    profile::Profile profile = *status.profile;
    profile.mount.directions = profile::Directions::Unconfirmed;
    status.profile = std::make_shared<const profile::Profile>(profile);
    status.permissions = samples::freshMount().permissions;
    give(samples::update(status));
    for (const char* const name : {"Go", "Horizon", "Home", "Park", "Go to"}) {
        EXPECT_FALSE(named<CommandButton>(name)->isEnabled()) << name;
        EXPECT_TRUE(
            named<CommandButton>(name)->toolTip().contains(QStringLiteral("directions of the axes are not confirmed")))
            << name;
    }
    slider().setFocus();
    QTest::keyClick(&slider(), Qt::Key_End);
    hold(JogDirection::Up);
    EXPECT_EQ(asked<request::Jog>().front().rates, (AxisRates{0_deg_s, 5_deg_s}));
}

TEST_F(JogDeskTest, EachStepSizeIsWhatOnePressMoves)
{
    QTest::mouseClick(named<ChoiceButton>("Step mode: a press moves one step only"), Qt::LeftButton);
    const std::pair<const char*, Angle> sizes[] = {
        {"0.01°", 0.01_deg}, {"0.1°", 0.1_deg}, {"1°", 1_deg}, {"5°", 5_deg}};
    for (const auto& [size, angle] : sizes) {
        requests.clear();
        const QByteArray name = QStringLiteral("One step is %1 (Ctrl + arrow)").arg(QString::fromUtf8(size)).toUtf8();
        QTest::mouseClick(named<ChoiceButton>(name.constData()), Qt::LeftButton);
        hold(JogDirection::Left);
        ASSERT_EQ(asked<request::Nudge>().size(), 1u);
        EXPECT_EQ(asked<request::Nudge>().front().azimuth, -angle);
        EXPECT_EQ(asked<request::Nudge>().front().elevation, 0_deg);
        EXPECT_TRUE(asked<request::Jog>().empty());
    }
}

// REQ-UI-1652: A step smaller than the rotator can move is not offered, with the reason. If it was chosen, the smallest
// possible step replaces it.
TEST_F(JogDeskTest, AStepThatTheRotatorCannotMakeIsNotOffered)
{
    const auto button = [this](const char* size) {
        const QByteArray name = QStringLiteral("One step is %1 (Ctrl + arrow)").arg(QString::fromUtf8(size)).toUtf8();
        return named<ChoiceButton>(name.constData());
    };
    QTest::mouseClick(button("0.01°"), Qt::LeftButton);
    StationStatus status = samples::idle();
    status.capabilities.axes[1]->step = 1_deg;
    give(samples::update(status));
    EXPECT_FALSE(button("0.01°")->isEnabled());
    EXPECT_FALSE(button("0.1°")->isEnabled());
    EXPECT_TRUE(button("1°")->isEnabled());
    EXPECT_TRUE(button("1°")->isChecked());
    EXPECT_EQ(button("0.1°")->toolTip(), QStringLiteral("This rotator moves in steps of 1°."));
    QTest::mouseClick(named<ChoiceButton>("Step mode: a press moves one step only"), Qt::LeftButton);
    requests.clear();
    hold(JogDirection::Left);
    ASSERT_EQ(asked<request::Nudge>().size(), 1u);
    EXPECT_EQ(asked<request::Nudge>().front().azimuth, -1_deg);

    QTest::mouseClick(button("5°"), Qt::LeftButton);
    give(samples::update(samples::idle()));
    EXPECT_TRUE(button("0.01°")->isEnabled());
    EXPECT_TRUE(button("5°")->isChecked()) << "what can be made stays chosen";
}

// REQ-UI-02b: A step during a pass trims the client's target. The trim is shown with every panel, and one button clears
// it.
TEST_F(JogDeskTest, ATrimIsShownByTheReadoutsInEveryPanelAndCleared)
{
    QTest::mouseClick(named<QPushButton>("Presets, home, horizon, unwrap"), Qt::LeftButton);
    StationStatus status = samples::tracking(200);
    give(samples::update(status));
    EXPECT_FALSE(named<CommandButton>("Clear trim")->isEnabled());
    EXPECT_EQ(text("Trim"), QStringLiteral("No trim"));
    status.trim = SkyPointing{.azimuth = 0.3_deg, .elevation = -0.1_deg};
    give(samples::update(status));
    for (const char panel : kPanels) {
        openPanel(panel);
        EXPECT_EQ(text("Detail of azimuth"), QStringLiteral("trim +0.30°"));
        EXPECT_EQ(text("Detail of elevation"), QStringLiteral("trim -0.10°"));
        EXPECT_TRUE(named<ValueLabel>("Detail of azimuth")->isVisible());
    }
    openPanel('1');
    auto* const clear = named<CommandButton>("Clear trim");
    EXPECT_TRUE(clear->toolTip().contains(QStringLiteral("Trim: AZ +0.30° EL -0.10°")));
    QTest::mouseClick(clear, Qt::LeftButton);
    EXPECT_EQ(asked<request::ClearTrim>().size(), 1u);
    status.trim.reset();
    give(samples::acceptance(status, requests.back().id));
    EXPECT_EQ(text("Detail of azimuth"), QString());
    EXPECT_FALSE(clear->isEnabled());
}

TEST_F(JogDeskTest, AWoundCableIsUnwoundByOneClick)
{
    EXPECT_FALSE(named<CommandButton>("Unwrap")->isEnabled());
    EXPECT_TRUE(named<CommandButton>("Unwrap")->toolTip().contains(QStringLiteral("cannot be unwrapped further")));
    StationStatus status = holding();
    status.permissions = samples::permitted();
    give(samples::update(status));
    click("Unwrap");
    EXPECT_EQ(asked<request::Unwind>().size(), 1u);
    status.permissions = samples::withoutMotion(QStringLiteral("STOP is latched. Reset STOP first."));
    give(samples::acceptance(status, requests.back().id));
    EXPECT_FALSE(named<CommandButton>("Unwrap")->isEnabled());
}

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

// REQ-UI-02c
TEST_F(JogDeskTest, APresetIsSavedWhereTheMountPointsUnderATypedName)
{
    EXPECT_FALSE(named<CommandButton>("Save here")->isEnabled());
    EXPECT_TRUE(named<CommandButton>("Save here")->toolTip().contains(QStringLiteral("Type a name first")));
    presetName().setFocus();
    QTest::keyClicks(&presetName(), QStringLiteral("beacon"));
    EXPECT_FALSE(named<CommandButton>("Go to")->isEnabled());
    click("Save here");
    ASSERT_EQ(asked<request::ApplyProfile>().size(), 1u);
    const auto sent = asked<request::ApplyProfile>().back().profile;
    ASSERT_EQ(sent.presets.size(), 1u);
    EXPECT_EQ(sent.presets[0], (profile::Preset{"beacon", *holding().actual}));
    EXPECT_EQ(sent.limits, holding().profile->limits) << "nothing else is applied with it";

    give(samples::acceptance(withPresets(sent.presets), requests.back().id));
    EXPECT_TRUE(named<CommandButton>("Go to")->isEnabled());
    requests.clear();
    QTest::keyClick(&presetName(), Qt::Key_Return);
    ASSERT_EQ(asked<request::PointSky>().size(), 1u);
    EXPECT_EQ(asked<request::PointSky>().front().direction, *holding().actual);
}

TEST_F(JogDeskTest, APresetIsChosenReplacedAndDeleted)
{
    give(samples::update(withPresets({{"south", {180_deg, 40_deg}}, {"house", {285_deg, 10_deg}}})));
    auto* const names = named<TouchCombo>("Preset");
    ASSERT_EQ(names->count(), 2);
    judge = [](const SkyPointing& at) {
        return DirectionVerdict{.whyNot = at.azimuth > 200_deg ? QStringLiteral("the keep-out \"house\"") : QString()};
    };
    presetName().setText(QStringLiteral("house"));
    give(samples::update(withPresets({{"south", {180_deg, 40_deg}}, {"house", {285_deg, 10_deg}}})));
    EXPECT_FALSE(named<CommandButton>("Go to")->isEnabled()) << "it lies in a keep-out";
    EXPECT_TRUE(named<CommandButton>("Go to")->toolTip().contains(QStringLiteral("house")));
    presetName().setText(QStringLiteral("south"));
    EXPECT_TRUE(named<CommandButton>("Go to")->isEnabled()) << "the verdict on another direction does not count";
    click("Go to");
    EXPECT_EQ(asked<request::PointSky>().back().direction, (SkyPointing{180_deg, 40_deg}));
    click("Save here");
    ASSERT_EQ(asked<request::ApplyProfile>().size(), 1u);
    EXPECT_EQ(asked<request::ApplyProfile>().back().profile.presets.size(), 2u);
    EXPECT_EQ(asked<request::ApplyProfile>().back().profile.presets[0].direction, *holding().actual);
    give(samples::refusal(withPresets({{"south", {180_deg, 40_deg}}}), requests.back().id, "not now"));
    click("Delete");
    ASSERT_EQ(asked<request::ApplyProfile>().size(), 2u);
    EXPECT_TRUE(asked<request::ApplyProfile>().back().profile.presets.empty());
    give(samples::acceptance(withPresets({}), requests.back().id));
    EXPECT_EQ(names->count(), 0);
    EXPECT_TRUE(presetName().text().isEmpty());
    EXPECT_FALSE(named<CommandButton>("Delete")->isEnabled());
}

TEST_F(JogDeskTest, NothingIsSavedFromAnOldPosition)
{
    give(samples::update(samples::withAge(holding(), std::chrono::milliseconds(900))));
    presetName().setText(QStringLiteral("beacon"));
    EXPECT_FALSE(named<CommandButton>("Save here")->isEnabled());
    EXPECT_TRUE(
        named<CommandButton>("Save here")->toolTip().contains(QStringLiteral("direction of the mount is unknown")));
}

TEST_F(JogDeskTest, HorizonAndHomeAskAndAForbiddenHomeIsNotOffered)
{
    click("Horizon");
    EXPECT_EQ(asked<request::Horizon>().size(), 1u);
    EXPECT_TRUE(named<CommandButton>("Home")->isEnabled());
    StationStatus status = holding();
    status.permissions.refuse(Action::Home, QStringLiteral("elevation 5.0° below the horizon 6.0°"));
    give(samples::acceptance(status, requests.back().id));
    EXPECT_FALSE(named<CommandButton>("Home")->isEnabled());
    EXPECT_TRUE(named<CommandButton>("Home")->toolTip().contains(QStringLiteral("below the horizon 6.0°")));
}

// REQ-UI-908: Rarely used controls of the panel Jog open behind one button and fit at 1024×700.
TEST_F(JogDeskTest, TheRareControlsHaveRoomAndGoAway)
{
    settle();
    EXPECT_TRUE(named<CommandButton>("Home")->isVisible());
    EXPECT_EQ(window.size(), QSize(1024, 700));
    QTest::mouseClick(named<QPushButton>("Presets, home, horizon, unwrap"), Qt::LeftButton);
    EXPECT_FALSE(named<CommandButton>("Home")->isVisible());
    EXPECT_TRUE(named<CommandButton>("Park")->isVisible());
}

TEST_F(JogDeskTest, ParkBecomesUnparkThatMovesNothing)
{
    click("Park");
    EXPECT_EQ(asked<request::Park>().size(), 1u);
    StationStatus parked = holding();
    parked.state = StationState::Parked;
    give(samples::acceptance(parked, requests.back().id));
    requests.clear();
    click("Unpark");
    EXPECT_EQ(asked<request::Hold>().size(), 1u);
    EXPECT_EQ(requests.size(), 1u);
    give(samples::acceptance(holding(), requests.back().id));
    EXPECT_TRUE(named<CommandButton>("Park")->isEnabled());
}

}  // namespace
}  // namespace boresight::ui
