// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/profile/commissioning.h"
#include "tests/ui/window_fixture.h"
#include "ui/calibration_panel.h"
#include "ui/command_button.h"
#include "ui/direction_arrow.h"
#include "ui/guide_client.h"
#include "ui/guide_connect.h"
#include "ui/guide_directions.h"
#include "ui/guide_north.h"
#include "ui/guide_page.h"
#include "ui/guide_site.h"
#include "ui/guide_travel.h"
#include "ui/guide_zero.h"
#include "ui/jog_button.h"
#include "ui/jog_panel.h"
#include "ui/protection_panel.h"
#include "ui/step_button.h"
#include "ui/stop_button.h"

#include <QApplication>
#include <QCheckBox>
#include <QClipboard>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLineEdit>
#include <QListWidget>
#include <QPlainTextEdit>

namespace boresight::ui {
namespace {

class GuideTest : public WindowFixture
{
protected:
    GuideTest()
    {
        status = samples::freshMount();
        give(samples::update(status));
        QObject::connect(&window, &MainWindow::guideProgressed, &window,
                         [this](const GuideProgress& progress) { kept = progress; });
        QTest::keyClick(&window, Qt::Key_F3);
    }

    GuidePage& guide() { return *window.findChild<GuidePage*>(); }
    bool isOpen() { return guide().isVisible() && !window.findChild<JogPanel*>()->isVisible(); }
    StepButton& stepButton(GuideStep step) { return *window.findChildren<StepButton*>().at(static_cast<int>(step)); }
    template <class Page>
    Page& open(GuideStep step)
    {
        QTest::mouseClick(&stepButton(step), Qt::LeftButton);
        return *guide().findChild<Page*>();
    }
    // In the guide, not on a panel that is also there.
    template <class T>
    T& inGuide(const char* name)
    {
        for (T* const widget : guide().findChildren<T*>()) {
            if (widget->accessibleName() == QString::fromUtf8(name) && widget->isVisible()) {
                return *widget;
            }
        }
        throw std::runtime_error(std::string("nothing in the guide is called ") + name);
    }
    void click(const char* name) { QTest::mouseClick(&inGuide<QPushButton>(name), Qt::LeftButton); }
    GuideStep current() { return guide().progress().current; }

    // The station takes it: what applies now is in force, the rest waits, and a reconnect puts all in force.
    void accept()
    {
        StationUpdate update = samples::update(status);
        update.answers.push_back({requests.back().id, std::nullopt});
        give(update);
    }
    profile::Profile lastApplied() { return asked<request::ApplyProfile>().back().profile; }
    void putInForce(const profile::Profile& profile)
    {
        status.profile = std::make_shared<const profile::Profile>(profile);
        give(samples::update(status));
    }
    // Applied, connected anew, in force: as the station does with all that needs a reconnect.
    void goThroughWithReconnect()
    {
        const profile::Profile wanted = lastApplied();
        accept();
        ASSERT_EQ(asked<request::Reconnect>().size(), 1u);
        EXPECT_EQ(asked<request::Reconnect>().back().profile, wanted);
        accept();
        putInForce(wanted);
    }
    void moveTo(AxisPosition place, AxisState state = AxisState::Moving)
    {
        status.azimuth.actual = place.azimuth;
        status.elevation.actual = place.elevation;
        status.azimuth.state = state;
        status.elevation.state = state;
        give(samples::update(status));
    }
    JogButton& hold(Axis axis, bool upwards)
    {
        const char* const names[2][2] = {
            {"Turn azimuth back at 1.0°/s while held", "Turn azimuth on at 1.0°/s while held"},
            {"Lower elevation at 1.0°/s while held", "Raise elevation at 1.0°/s while held"}};
        return inGuide<JogButton>(names[axis == Axis::Elevation][upwards]);
    }
    bool lastJogIsZero() { return !asked<request::Jog>().empty() && asked<request::Jog>().back().rates == AxisRates{}; }

    StationStatus status;
    GuideProgress kept;
};

TEST_F(GuideTest, TakesThePlaceOfThePanelsAndCoversNothing)
{
    ASSERT_TRUE(isOpen());
    EXPECT_EQ(window.size(), QSize(1024, 700));
    auto* const stop = window.findChild<StopButton*>();
    const QRect page(guide().mapTo(&window, QPoint()), guide().size());
    for (QWidget* const above : {static_cast<QWidget*>(stop), static_cast<QWidget*>(named<ValueLabel>("Station state")),
                                 static_cast<QWidget*>(named<ValueLabel>("Actual azimuth")),
                                 static_cast<QWidget*>(named<ValueLabel>("Worst alarm"))}) {
        EXPECT_TRUE(above->isVisible());
        EXPECT_FALSE(page.intersects(QRect(above->mapTo(&window, QPoint()), above->size())));
    }
    openPanel('1');
    EXPECT_FALSE(isOpen());
    QTest::keyClick(&window, Qt::Key_F3);
    EXPECT_TRUE(isOpen());
    EXPECT_TRUE(kept.open);
    QTest::keyClick(&window, Qt::Key_F3);
    EXPECT_FALSE(kept.open);
}

TEST_F(GuideTest, StopWorksOnEveryStepByButtonAndKey)
{
    for (const GuideStep step : kGuideSteps) {
        open<QWidget>(step);
        requests.clear();
        QTest::mousePress(window.findChild<StopButton*>(), Qt::LeftButton);
        EXPECT_EQ(asked<request::Stop>().size(), 1u) << title(step).toStdString();
        QTest::mouseRelease(window.findChild<StopButton*>(), Qt::LeftButton);
        QTest::keyClick(&window, Qt::Key_F12);
        QTest::keyClick(QApplication::focusWidget(), Qt::Key_Escape);
        EXPECT_EQ(asked<request::Stop>().size(), 3u) << title(step).toStdString();
    }
}

TEST_F(GuideTest, NextNeedsWhatCanBeSeenAndSkipLeavesItForLater)
{
    EXPECT_EQ(stepButton(GuideStep::Connect).state(), StepState::Done);
    EXPECT_EQ(stepButton(GuideStep::Directions).state(), StepState::Open);
    click("Next");
    click("Next");
    EXPECT_EQ(current(), GuideStep::Directions);
    EXPECT_FALSE(inGuide<QPushButton>("Next").isEnabled());
    EXPECT_TRUE(inGuide<QPushButton>("Next").toolTip().contains(QStringLiteral("not confirmed")));
    QTest::keyClick(&guide(), Qt::Key_Right, Qt::AltModifier);
    EXPECT_EQ(current(), GuideStep::Directions) << "nor by its key";
    click("Skip");
    EXPECT_EQ(current(), GuideStep::Travel);
    EXPECT_EQ(stepButton(GuideStep::Directions).state(), StepState::Later);
    click("Next");
    EXPECT_EQ(stepButton(GuideStep::Travel).state(), StepState::Done) << "it is right as it is";
    QTest::keyClick(&guide(), Qt::Key_Left, Qt::AltModifier);
    EXPECT_EQ(current(), GuideStep::Travel);
    EXPECT_TRUE(requests.empty()) << "looking at the steps asks nothing of the station";
}

TEST_F(GuideTest, FinishLaterGoesToThePanelsAndComesBackToTheSameStep)
{
    open<QWidget>(GuideStep::North);
    click("Skip");
    click("Finish later");
    EXPECT_FALSE(isOpen());
    EXPECT_FALSE(kept.open);
    QTest::mouseClick(named<QAbstractButton>("Commissioning guide"), Qt::LeftButton);
    EXPECT_TRUE(isOpen());
    EXPECT_EQ(current(), GuideStep::Site);
    EXPECT_EQ(stepButton(GuideStep::North).state(), StepState::Later);
}

TEST_F(GuideTest, TheLastStepEndsTheGuide)
{
    open<GuideClient>(GuideStep::Client);
    click("Finish");
    EXPECT_FALSE(isOpen());
    EXPECT_TRUE(kept.passed.contains(GuideStep::Client));
}

TEST_F(GuideTest, AnotherMountBeginsAnew)
{
    open<GuideNorth>(GuideStep::North);
    click("Next");
    profile::Profile other = *status.profile;
    other.mount.name = "Roof";
    putInForce(other);
    EXPECT_EQ(current(), GuideStep::Connect);
    EXPECT_EQ(kept.mount, QStringLiteral("Roof"));
    EXPECT_TRUE(kept.passed.empty());
}

TEST_F(GuideTest, AdaptersAreListedByTheirNamesAndScannedWithoutMovingAnything)
{
    QSignalSpy scans(&window.host(), &HostDesk::scanWanted);
    auto& page = open<GuideConnect>(GuideStep::Connect);
    Q_EMIT window.host().adaptersFound(adaptersOf({}, {{QStringLiteral("can0"), true}}));
    auto& list = inGuide<QListWidget>("Adapters of this computer");
    ASSERT_EQ(list.count(), 2);
    EXPECT_EQ(list.currentRow(), 1) << "the one in use";
    EXPECT_FALSE(inGuide<QPushButton>("Use this").isEnabled());
    EXPECT_TRUE(inGuide<QPlainTextEdit>("Who answers").toPlainText().contains(QStringLiteral("azimuth, id 1: 24.1 V")));
    click("Scan");
    EXPECT_EQ(asked<request::ReadDrives>().size(), 1u) << "the station has this bus and looks itself";
    EXPECT_EQ(scans.count(), 0);

    QTest::keyClick(&list, Qt::Key_Up);
    requests.clear();
    click("Scan");
    ASSERT_EQ(scans.count(), 1);
    EXPECT_EQ(scans.front().front().toString(), QStringLiteral("socketcan:can0"));
    EXPECT_FALSE(inGuide<QPushButton>("Scan").isEnabled());
    Q_EMIT window.host().scanned({.bus = QStringLiteral("socketcan:can0"),
                                  .drives = {{.id = 4, .uuid = {}, .firmware = {}, .voltage = 24.0},
                                             {.id = 9, .uuid = {}, .firmware = {}, .voltage = 23.9}},
                                  .problems = {QStringLiteral("id 9: fault 38")}});
    const QString found = inGuide<QPlainTextEdit>("Who answers").toPlainText();
    EXPECT_TRUE(found.contains(QStringLiteral("id 4: 24.0 V")));
    EXPECT_TRUE(found.contains(QStringLiteral("fault 38")));
    EXPECT_TRUE(requests.empty());

    click("Use this");
    EXPECT_EQ(lastApplied().bus, "socketcan:can0");
    EXPECT_EQ(lastApplied().azimuth.id, 4);
    EXPECT_EQ(lastApplied().elevation.id, 9);
    EXPECT_EQ(lastApplied().mount.directions, profile::Directions::Unconfirmed);
    goThroughWithReconnect();
    EXPECT_TRUE(page.isVisible());
}

TEST_F(GuideTest, WhatIsRefusedStandsBesideTheButtonAndLeavesNoEditBehind)
{
    open<GuideConnect>(GuideStep::Connect);
    Q_EMIT window.host().adaptersFound(adaptersOf({}, {{QStringLiteral("can0"), true}}));
    inGuide<QListWidget>("Adapters of this computer").setCurrentRow(0);
    click("Use this");
    give(samples::refusal(status, requests.back().id, "Boresight is closing"));
    EXPECT_TRUE(asked<request::Reconnect>().empty());
    EXPECT_TRUE(inGuide<ValueLabel>("Refused").text().contains(QStringLiteral("closing")));
    EXPECT_TRUE(inGuide<QPushButton>("Use this").isEnabled()) << "nothing is left half done";
}

TEST_F(GuideTest, AHeldTestMoveIsSlowAndEndsOnRelease)
{
    open<GuideDirections>(GuideStep::Directions);
    for (const auto& [axis, upwards, rates] : {std::tuple{Axis::Azimuth, true, AxisRates{1_deg_s, 0_deg_s}},
                                               std::tuple{Axis::Azimuth, false, AxisRates{-1_deg_s, 0_deg_s}},
                                               std::tuple{Axis::Elevation, true, AxisRates{0_deg_s, 1_deg_s}},
                                               std::tuple{Axis::Elevation, false, AxisRates{0_deg_s, -1_deg_s}}}) {
        requests.clear();
        QTest::mousePress(&hold(axis, upwards), Qt::LeftButton);
        ASSERT_TRUE(QTest::qWaitFor([this] { return asked<request::Jog>().size() >= 3; }, 2000));
        EXPECT_EQ(asked<request::Jog>().back().rates, rates);
        QTest::mouseRelease(&hold(axis, upwards), Qt::LeftButton);
        EXPECT_TRUE(lastJogIsZero());
    }
}

TEST_F(GuideTest, SpaceHoldsATestMoveAndEverythingThatTakesItAwayEndsIt)
{
    open<GuideDirections>(GuideStep::Directions);
    JogButton& button = hold(Axis::Azimuth, true);
    const auto begin = [&] {
        requests.clear();
        button.setFocus();
        QTest::keyPress(&button, Qt::Key_Space);
        ASSERT_FALSE(asked<request::Jog>().empty());
        EXPECT_FALSE(lastJogIsZero());
    };
    begin();
    QTest::keyRelease(&button, Qt::Key_Space);
    EXPECT_TRUE(QTest::qWaitFor([this] { return lastJogIsZero(); }, 1000)) << "release";
    begin();
    QTest::keyClick(&window, Qt::Key_Tab);
    EXPECT_TRUE(lastJogIsZero()) << "focus";
    QTest::keyRelease(&button, Qt::Key_Space);
    begin();
    openPanel('1');
    EXPECT_TRUE(lastJogIsZero()) << "another panel";
    QTest::keyClick(&window, Qt::Key_F3);
    begin();
    give(samples::update(samples::stopped()));
    EXPECT_TRUE(lastJogIsZero()) << "STOP";
    give(samples::update(status));
    begin();
    give(samples::refusal(status, requests.front().id, "no farther than 2°"));
    EXPECT_TRUE(lastJogIsZero()) << "a refusal";
    EXPECT_TRUE(inGuide<ValueLabel>("Refused").text().contains(QStringLiteral("no farther")));
}

TEST_F(GuideTest, ARepeatedKeyIsOneHold)
{
    open<GuideDirections>(GuideStep::Directions);
    JogButton& button = hold(Axis::Elevation, true);
    button.setFocus();
    QTest::keyPress(&button, Qt::Key_Space);
    for (int repeat = 0; repeat < 3; ++repeat) {  // an X server's pairs that Qt did not see through
        QTest::keyRelease(&button, Qt::Key_Space);
        QTest::keyPress(&button, Qt::Key_Space);
    }
    for (const request::Jog& jog : asked<request::Jog>()) {
        EXPECT_EQ(jog.rates, (AxisRates{0_deg_s, 1_deg_s}));
    }
    QTest::keyRelease(&button, Qt::Key_Space);
}

TEST_F(GuideTest, TheArrowFollowsTheMotionAndConfirmingNeedsBothToBeSeen)
{
    open<GuideDirections>(GuideStep::Directions);
    auto& arrow = inGuide<DirectionArrow>("Direction of the azimuth");
    EXPECT_EQ(arrow.turning(), Turning::Rests);
    status.azimuth.rate = 1_deg_s;
    moveTo({.azimuth = 10.5_deg, .elevation = 20_deg});
    EXPECT_EQ(arrow.turning(), Turning::Grows);
    EXPECT_EQ(arrow.accessibleDescription(), QStringLiteral("clockwise, seen from above"));
    status.azimuth.rate = -1_deg_s;
    moveTo({.azimuth = 10.4_deg, .elevation = 20_deg});
    EXPECT_EQ(arrow.turning(), Turning::Shrinks);
    auto& confirm = inGuide<QPushButton>("Both turn as the arrows show");
    EXPECT_FALSE(confirm.isEnabled());
    EXPECT_TRUE(confirm.toolTip().contains(QStringLiteral("elevation")));
    status.azimuth.rate = 0_deg_s;
    moveTo({.azimuth = 10.4_deg, .elevation = 19.5_deg});
    moveTo({.azimuth = 10.4_deg, .elevation = 19.5_deg}, AxisState::Holding);
    ASSERT_TRUE(confirm.isEnabled());
    QTest::mouseClick(&confirm, Qt::LeftButton);
    EXPECT_EQ(lastApplied().mount.directions, profile::Directions::Confirmed);
    accept();
    putInForce(lastApplied());
    EXPECT_TRUE(asked<request::Reconnect>().empty()) << "it applies at once";
    EXPECT_EQ(stepButton(GuideStep::Directions).state(), StepState::Done);
    click("Next");
    EXPECT_EQ(current(), GuideStep::Travel);
}

TEST_F(GuideTest, WrongMotorsAreSwappedAndAWrongDirectionReversedByOnePress)
{
    open<GuideDirections>(GuideStep::Directions);
    moveTo({.azimuth = 11_deg, .elevation = 21_deg});
    EXPECT_FALSE(inGuide<QPushButton>("AZ turned the other way").isEnabled()) << "not in motion";
    moveTo({.azimuth = 11_deg, .elevation = 21_deg}, AxisState::Holding);
    click("The other axis moved:\nswap the motors");
    EXPECT_EQ(lastApplied().azimuth.id, 2);
    EXPECT_EQ(lastApplied().elevation.id, 1);
    goThroughWithReconnect();
    EXPECT_FALSE(inGuide<QPushButton>("Both turn as the arrows show").isEnabled()) << "to be seen anew";
    requests.clear();
    click("AZ turned the other way");
    EXPECT_EQ(lastApplied().azimuth.geometry.sign, -1);
    EXPECT_NEAR(lastApplied().azimuth.geometry.offset.degrees(), -22.0, 1e-9) << "it reads 11° as before";
    goThroughWithReconnect();
    EXPECT_EQ(lastApplied().mount.directions, profile::Directions::Unconfirmed);
}

TEST_F(GuideTest, DrivesThatAreNotFitAreMendedFirst)
{
    status = samples::factoryDrives();
    give(samples::update(status));
    open<GuideDirections>(GuideStep::Directions);
    EXPECT_FALSE(hold(Axis::Azimuth, true).isEnabled());
    EXPECT_TRUE(inGuide<ValueLabel>("What is in the way").text().contains(QStringLiteral("step 2, Protect")));
    EXPECT_EQ(stepButton(GuideStep::Protection).state(), StepState::Open);
    open<ProtectionPanel>(GuideStep::Protection);
    click("Fix …");
    EXPECT_TRUE(asked<request::FixDrives>().empty()) << "it asks first";
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_Escape);
    EXPECT_TRUE(asked<request::Stop>().empty()) << "Esc closed the question";
    click("Fix …");
    click("Write");
    EXPECT_EQ(asked<request::FixDrives>().size(), 1u);
}

TEST_F(GuideTest, AnOpenQuestionAboutATurnIsSaidAndReached)
{
    give(samples::update(samples::asking(Axis::Azimuth, 3, 180_deg, true)));
    EXPECT_TRUE(isOpen()) << "the guide is not taken away";
    EXPECT_TRUE(inGuide<ValueLabel>("What is in the way").text().contains(QStringLiteral("Ctrl+9")));
    openPanel('9');
    EXPECT_FALSE(isOpen());
}

TEST_F(GuideTest, EndsAreTypedOrSetWhereTheMountStands)
{
    open<GuideTravel>(GuideStep::Travel);
    EXPECT_FALSE(inGuide<QPushButton>("Use these ends").isEnabled());
    QTest::mouseClick(&inGuide<QPushButton>("Set the lower end of azimuth here"), Qt::LeftButton);
    inGuide<QDoubleSpinBox>("Upper end of azimuth").setValue(380.0);
    auto& lowest = inGuide<QDoubleSpinBox>("Lower end of elevation");
    lowest.setFocus();
    lowest.selectAll();
    QTest::keyClicks(&lowest, QStringLiteral("95"));
    QTest::keyClick(&lowest, Qt::Key_Tab);
    give(samples::update(status));
    EXPECT_FALSE(inGuide<QPushButton>("Use these ends").isEnabled());
    EXPECT_TRUE(inGuide<QPushButton>("Use these ends").toolTip().contains(QStringLiteral("not below")));
    lowest.setValue(5.0);
    give(samples::update(status));
    EXPECT_TRUE(requests.empty()) << "nothing changes before it is used";
    click("Use these ends");
    EXPECT_EQ(lastApplied().azimuth.geometry.travel, (TravelRange{.min = 10_deg, .max = 380_deg}));
    EXPECT_EQ(lastApplied().elevation.geometry.travel, (TravelRange{.min = 5_deg, .max = 90_deg}));
    EXPECT_EQ(lastApplied().park, (AxisPosition{.azimuth = 10_deg, .elevation = 5_deg})) << "it came inside";
    goThroughWithReconnect();
    EXPECT_EQ(stepButton(GuideStep::Travel).state(), StepState::Done);
}

TEST_F(GuideTest, LevelIsSetHereAndItsEffectToldBefore)
{
    open<GuideZero>(GuideStep::Level);
    moveTo({.azimuth = 10_deg, .elevation = 3.2_deg}, AxisState::Holding);
    EXPECT_TRUE(inGuide<ValueLabel>("What the elevation reads now").text().contains(QStringLiteral("3.20°")));
    EXPECT_TRUE(inGuide<ValueLabel>("What the change does").text().contains(QStringLiteral("-3.20°")));
    EXPECT_TRUE(inGuide<ValueLabel>("What the change does").text().contains(QStringLiteral("-3.2°…86.8°")));
    moveTo({.azimuth = 10_deg, .elevation = 3.2_deg}, AxisState::Moving);
    EXPECT_FALSE(inGuide<QPushButton>("Set it").isEnabled()) << "not in motion";
    moveTo({.azimuth = 10_deg, .elevation = 3.2_deg}, AxisState::Holding);
    inGuide<QCheckBox>("Cable and stops are where they were: their numbers change").click();
    EXPECT_TRUE(inGuide<ValueLabel>("What the change does").text().contains(QStringLiteral("0.0°…90.0°")));
    click("Set it");
    EXPECT_NEAR(lastApplied().elevation.geometry.offset.degrees(), 93.2, 1e-9);
    EXPECT_EQ(lastApplied().elevation.geometry.travel, status.profile->elevation.geometry.travel);
    goThroughWithReconnect();
    EXPECT_EQ(stepButton(GuideStep::Level).state(), StepState::Done);
}

TEST_F(GuideTest, NorthIsSetInThePointingModelAtOnceAndTheCableKeepsItsNumbers)
{
    open<GuideNorth>(GuideStep::North);
    moveTo({.azimuth = 10_deg, .elevation = 20_deg}, AxisState::Moving);
    EXPECT_FALSE(inGuide<QPushButton>("Set north").isEnabled()) << "not in motion";
    moveTo({.azimuth = 10_deg, .elevation = 20_deg}, AxisState::Holding);
    EXPECT_TRUE(inGuide<ValueLabel>("Where the antenna points now").text().contains(QStringLiteral("10.00°")));
    inGuide<QDoubleSpinBox>("True azimuth of the antenna").setValue(350.0);
    EXPECT_TRUE(inGuide<ValueLabel>("What the change does").text().contains(QStringLiteral("0.00° → -20.00°")));
    const auto connects = asked<request::Reconnect>().size();
    click("Set north");
    EXPECT_NEAR(lastApplied().pointing.azimuthOffset.degrees(), -20.0, 1e-9);
    EXPECT_EQ(lastApplied().azimuth.geometry, status.profile->azimuth.geometry);
    EXPECT_EQ(lastApplied().limits, status.profile->limits);
    EXPECT_EQ(asked<request::Reconnect>().size(), connects) << "it applies now";
}

TEST_F(GuideTest, TheOtherWaysToNorthAreOnePressAway)
{
    open<GuideNorth>(GuideStep::North);
    QTest::mouseClick(&inGuide<QPushButton>("Sensor, Sun, Moon (Ctrl+9)"), Qt::LeftButton);
    EXPECT_FALSE(window.findChild<GuidePage*>()->isVisible());
    EXPECT_TRUE(window.findChild<CalibrationPanel*>()->isVisible());
}

TEST_F(GuideTest, AZeroNeedsAKnownTurn)
{
    give(samples::update(samples::asking(Axis::Azimuth, 3, 180_deg, true)));
    open<GuideNorth>(GuideStep::North);
    EXPECT_FALSE(inGuide<QPushButton>("Set north").isEnabled());
    EXPECT_TRUE(inGuide<QPushButton>("Set north").toolTip().contains(QStringLiteral("turn")));
}

TEST_F(GuideTest, SiteAndLocatorFollowEachOther)
{
    open<GuideSite>(GuideStep::Site);
    EXPECT_FALSE(inGuide<QPushButton>("Set the site").isEnabled());
    auto& locator = inGuide<QLineEdit>("Maidenhead locator");
    locator.setFocus();
    QTest::keyClicks(&locator, QStringLiteral("JN58t"));
    EXPECT_FALSE(inGuide<ValueLabel>("What is wrong").text().isEmpty());
    QTest::keyClicks(&locator, QStringLiteral("d"));
    EXPECT_EQ(locator.text(), QStringLiteral("JN58td"));
    EXPECT_NEAR(inGuide<QDoubleSpinBox>("Latitude").value(), 48.146, 0.001);  // published: 48°08.75' N, 11°37.5' E
    EXPECT_NEAR(inGuide<QDoubleSpinBox>("Longitude").value(), 11.625, 0.001);
    inGuide<QDoubleSpinBox>("Longitude").setValue(-8.5);
    EXPECT_EQ(locator.text(), QStringLiteral("IN58sd"));
    inGuide<QDoubleSpinBox>("Height").setValue(523.0);
    click("Set the site");
    EXPECT_TRUE(lastApplied().site.known);
    EXPECT_NEAR(lastApplied().site.longitude.degrees(), -8.5, 1e-9);
    EXPECT_EQ(lastApplied().site.heightMetres, 523.0);
    accept();
    putInForce(lastApplied());
    EXPECT_EQ(stepButton(GuideStep::Site).state(), StepState::Done);
}

TEST_F(GuideTest, GpredictsSettingsAreCopied)
{
    open<GuideClient>(GuideStep::Client);
    click("Copy the settings for Gpredict");
    EXPECT_TRUE(QApplication::clipboard()->text().contains(QStringLiteral("Port: 4533")));
}

TEST_F(GuideTest, ChangesThatWaitOnAnotherPanelAreNotAppliedWithIt)
{
    openPanel('3');
    named<QDoubleSpinBox>("Lowest elevation")->setValue(12.0);
    QTest::keyClick(&window, Qt::Key_F3);
    open<GuideDirections>(GuideStep::Directions);
    const auto& swap = inGuide<QPushButton>("The other axis moved:\nswap the motors");
    EXPECT_FALSE(swap.isEnabled());
    EXPECT_TRUE(swap.toolTip().contains(QStringLiteral("another panel")));
}

TEST(GuideProgressText, SurvivesTheSettingsFile)
{
    const GuideProgress progress{.open = true,
                                 .current = GuideStep::Travel,
                                 .passed = {GuideStep::Level},
                                 .later = {GuideStep::North, GuideStep::Site},
                                 .mount = QStringLiteral("Roof | west")};
    EXPECT_EQ(guideProgressFrom(toText(progress)), progress);
    EXPECT_EQ(guideProgressFrom(QStringLiteral("rubbish")), GuideProgress{});
}

// A window that was closed with the guide on the screen opens with it, at the same step.
TEST(GuideAtStart, OpensWhereItWas)
{
    const fakes::ManualClock clock;
    WindowSettings settings;
    settings.guide = {.open = true,
                      .current = GuideStep::Site,
                      .passed = {GuideStep::Level},
                      .mount = QString::fromStdString(samples::idle().profile->mount.name)};
    MainWindow window(clock, settings);
    window.show();
    window.showUpdate(samples::update(samples::idle()));
    auto* const guide = window.findChild<GuidePage*>();
    ASSERT_NE(guide, nullptr);
    EXPECT_TRUE(guide->isVisible());
    EXPECT_EQ(guide->progress(), settings.guide);
    window.closeNow();
}

}  // namespace
}  // namespace boresight::ui
