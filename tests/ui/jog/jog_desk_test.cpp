// SPDX-License-Identifier: GPL-3.0-or-later
// Rate, steps, trim, presets, horizon and park.
#include "tests/ui/jog/jog_desk_fixture.h"
#include "ui/kit/choice_button.h"
#include "ui/kit/touch_combo.h"

namespace boresight::ui {
namespace {

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
    settle();
    EXPECT_EQ(text("Trim"), QStringLiteral("AZ +0.30°\nEL -0.10°"));
    EXPECT_FALSE(named<ValueLabel>("Trim")->isElided()) << "both axes are read at 1024×700";
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

// REQ-WIND-21b
TEST_F(JogDeskTest, UnparkIsDisabledWithTheReasonWhileTheWindKeepsTheMountParked)
{
    const auto why = QStringLiteral("The wind reached 17.0 m/s. The limit is 15.0 m/s.");
    StationStatus parked = holding();
    parked.state = StationState::Parked;
    parked.permissions.refuse(Action::Hold, why);
    give(samples::update(parked));
    const auto* const unpark = named<CommandButton>("Unpark");
    EXPECT_FALSE(unpark->isEnabled());
    EXPECT_TRUE(unpark->toolTip().contains(why)) << unpark->toolTip().toStdString();
}

}  // namespace
}  // namespace boresight::ui
