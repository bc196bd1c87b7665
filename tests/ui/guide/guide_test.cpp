// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/station/adapters.h"
#include "tests/ui/guide/guide_fixture.h"
#include "ui/drives/protection_panel.h"
#include "ui/guide/guide_client.h"
#include "ui/guide/guide_connect.h"
#include "ui/guide/guide_directions.h"
#include "ui/guide/guide_north.h"
#include "ui/window/main_menu.h"
#include "ui/window/stop_button.h"

#include <QAbstractButton>
#include <QApplication>
#include <QClipboard>
#include <QDoubleSpinBox>
#include <QListWidget>
#include <QPlainTextEdit>

// The guide as a whole: its steps, what each needs, where it goes on.
namespace boresight::ui {
namespace {

// REQ-UI-34: The guide covers neither STOP nor state nor plot, asks nothing that the panels could not ask, and goes on
// where it was left. What can be seen in the station is never remembered instead. Nothing that was seen on the
// simulated mount counts for the real one.
TEST_F(GuideTest, TakesThePlaceOfThePanelsAndCoversNothing)
{
    ASSERT_TRUE(isOpen());
    EXPECT_EQ(window.size(), QSize(1024, 700));
    auto* const stop = window.findChild<StopButton*>();
    const QRect page(guide().mapTo(&window, QPoint()), guide().size());
    for (QWidget* const above : {static_cast<QWidget*>(stop), static_cast<QWidget*>(named<ValueLabel>("Station state")),
                                 static_cast<QWidget*>(named<ValueLabel>("Actual azimuth"))}) {
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
        window.setFocus();  // out of the field of the step
        QTest::keyClick(&window, Qt::Key_Escape);
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

// REQ-UI-34
TEST_F(GuideTest, FinishLaterGoesToThePanelsAndComesBackToTheSameStep)
{
    open<QWidget>(GuideStep::North);
    click("Skip");
    click("Finish later");
    EXPECT_FALSE(isOpen());
    EXPECT_FALSE(kept.open);
    Q_EMIT window.findChild<MainMenu*>()->guideWanted();
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
    EXPECT_EQ(kept.mount, QStringLiteral("Roof (simulated)"));
    EXPECT_TRUE(kept.passed.empty());
}

// Story: level and ends were ticked on the simulated mount, and stayed ticked when the real one was connected.
// REQ-UI-34
TEST_F(GuideTest, TheRealMountBeginsAnewAfterTheSimulatedOne)
{
    open<GuideDirections>(GuideStep::Travel);
    click("Next");
    click("Next");
    EXPECT_TRUE(kept.passed.contains(GuideStep::Level));
    profile::Profile real = *status.profile;
    real.bus = "socketcan:can0";
    putInForce(real);
    EXPECT_TRUE(kept.passed.empty());
    EXPECT_EQ(kept.mount, toQString(real.mount.name));
    EXPECT_EQ(stepButton(GuideStep::Travel).state(), StepState::Open);
}

// Story: a bus waited for its reconnect while the level of another mount was set for it.
TEST_F(GuideTest, NothingIsSetForAMountThatWaitsForItsReconnect)
{
    profile::Profile real = *status.profile;
    real.bus = "socketcan:can7";
    putInForce(real);
    open<GuideConnect>(GuideStep::Connect);
    Q_EMIT window.host().adaptersFound(adaptersOf({}, {{QStringLiteral("can0"), true}}));
    inGuide<QListWidget>("Adapters of this computer").setCurrentRow(0);
    click("Connect");
    status.waitingKeys = {"bus.name"};
    accept();
    give(samples::refusal(status, requests.back().id, "the drives move"));
    open<GuideDirections>(GuideStep::Directions);
    const auto& swap = inGuide<QPushButton>("The other axis moved:\nswap the motors");
    EXPECT_FALSE(swap.isEnabled());
    EXPECT_TRUE(swap.toolTip().contains(QStringLiteral("the bus socketcan:can0 is not in force yet")))
        << swap.toolTip().toStdString();
}

TEST_F(GuideTest, OfAMountWithoutDrivesOfThatKindNoneIsListed)
{
    open<GuideConnect>(GuideStep::Connect);
    Q_EMIT window.host().adaptersFound(adaptersOf({}, {{QStringLiteral("can0"), true}}));
    status.drives.reset();
    give(samples::update(status));
    EXPECT_EQ(inGuide<QPlainTextEdit>("Who answers").toPlainText(), QStringLiteral("In use."));
}

TEST_F(GuideTest, AdaptersAreListedByTheirNamesAndScannedWithoutMovingAnything)
{
    QSignalSpy scans(&window.host(), &HostDesk::scanWanted);
    auto& page = open<GuideConnect>(GuideStep::Connect);
    Q_EMIT window.host().adaptersFound(adaptersOf({}, {{QStringLiteral("can0"), true}}));
    auto& list = inGuide<QListWidget>("Adapters of this computer");
    ASSERT_EQ(list.count(), 2);
    EXPECT_EQ(list.currentRow(), 1) << "the one in use";
    EXPECT_FALSE(list.item(0)->text().contains(QStringLiteral("SIMULATED")));
    EXPECT_TRUE(list.item(1)->text().startsWith(QStringLiteral("SIMULATED")));
    for (const QString& drive : inGuide<QPlainTextEdit>("Who answers").toPlainText().split(QLatin1Char('\n'))) {
        EXPECT_EQ(drive.contains(QStringLiteral("(simulated)")), drive.contains(QStringLiteral("id "))) << "each drive";
    }
    EXPECT_FALSE(inGuide<QPushButton>("Connect").isEnabled());
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

    click("Connect");
    EXPECT_TRUE(asked<request::ApplyProfile>().empty()) << "nothing is made of the simulated mount";
    ASSERT_EQ(asked<request::Reconnect>().size(), 1u);
    const profile::Profile wanted = asked<request::Reconnect>().front().profile;
    EXPECT_EQ(wanted.bus, "socketcan:can0");
    EXPECT_EQ(wanted.azimuth.id, 4);
    EXPECT_EQ(wanted.elevation.id, 9);
    EXPECT_EQ(wanted.mount.directions, profile::Directions::Unconfirmed);
    accept();
    putInForce(wanted);
    EXPECT_TRUE(page.isVisible());
}

// REQ-UI-35
TEST_F(GuideTest, WhatIsRefusedStandsBesideTheButtonAndLeavesNoEditBehind)
{
    profile::Profile real = *status.profile;
    real.bus = "socketcan:can7";
    putInForce(real);
    open<GuideConnect>(GuideStep::Connect);
    Q_EMIT window.host().adaptersFound(adaptersOf({}, {{QStringLiteral("can0"), true}}));
    inGuide<QListWidget>("Adapters of this computer").setCurrentRow(0);
    click("Connect");
    give(samples::refusal(status, requests.back().id, "Boresight is closing"));
    EXPECT_TRUE(asked<request::Reconnect>().empty());
    EXPECT_TRUE(inGuide<ValueLabel>("Refused").text().contains(QStringLiteral("closing")));
    EXPECT_TRUE(inGuide<QPushButton>("Connect").isEnabled()) << "nothing is left half done";
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
    EXPECT_TRUE(swap.toolTip().contains(QStringLiteral("Another panel")));
}

// REQ-UI-34 (GuideProgressText.*)
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
// REQ-UI-34 (GuideAtStart.*)
TEST(GuideAtStart, OpensWhereItWas)
{
    const fakes::ManualClock clock;
    WindowSettings settings;
    settings.guide = {.open = true,
                      .current = GuideStep::Site,
                      .passed = {GuideStep::Level},
                      .mount = QStringLiteral("Boresight mount (simulated)")};
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
