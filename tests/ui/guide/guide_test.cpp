// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/station/adapters.h"
#include "tests/ui/guide/guide_fixture.h"
#include "ui/drives/protection_panel.h"
#include "ui/guide/guide_client.h"
#include "ui/guide/guide_connect.h"
#include "ui/guide/guide_directions.h"
#include "ui/guide/guide_north.h"
#include "ui/guide/guide_ready.h"
#include "ui/window/main_menu.h"
#include "ui/window/stop_button.h"

#include <QAbstractButton>
#include <QApplication>
#include <QClipboard>
#include <QDoubleSpinBox>
#include <QListWidget>
#include <QPlainTextEdit>

// The guide as a whole: its steps, their states, and where it continues.
namespace boresight::ui {
namespace {

// REQ-UI-34: The guide covers neither STOP nor state nor plot, makes only requests that the panels can make, and
// continues where it was left. The guide stores nothing that the station reports. Nothing that was confirmed on the
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
        window.setFocus();  // leaves the field of the step
        QTest::keyClick(&window, Qt::Key_Escape);
        EXPECT_EQ(asked<request::Stop>().size(), 3u) << title(step).toStdString();
    }
}

// Story: Next counted the travel, the level and north as done, although nobody had checked them.
// REQ-UI-960: A step is done if the station shows this or the operator has confirmed it. Next on a step that is not
// done marks it as skipped.
TEST_F(GuideTest, NextSkipsWhatIsNotDone)
{
    EXPECT_EQ(stepButton(GuideStep::Connect).state(), StepState::Done);
    EXPECT_EQ(stepButton(GuideStep::Directions).state(), StepState::Open);
    click("Next");
    click("Next");
    EXPECT_EQ(current(), GuideStep::Directions);
    EXPECT_EQ(stepButton(GuideStep::Protection).state(), StepState::Done) << "seen in the station";
    EXPECT_TRUE(inGuide<QPushButton>("Next").toolTip().contains(QStringLiteral("not confirmed")));
    EXPECT_TRUE(inGuide<QPushButton>("Next").toolTip().contains(QStringLiteral("skipped")));
    QTest::keyClick(&guide(), Qt::Key_Right, Qt::AltModifier);
    EXPECT_EQ(current(), GuideStep::Travel);
    EXPECT_EQ(stepButton(GuideStep::Directions).state(), StepState::Skipped);
    click("Next");
    EXPECT_EQ(stepButton(GuideStep::Travel).state(), StepState::Skipped);
    QTest::keyClick(&guide(), Qt::Key_Left, Qt::AltModifier);
    EXPECT_EQ(current(), GuideStep::Travel);
    EXPECT_TRUE(requests.empty()) << "looking at the steps asks nothing of the station";
}

// REQ-UI-960
TEST_F(GuideTest, TheOperatorConfirmsWhatNobodyCanSee)
{
    open<QWidget>(GuideStep::Level);
    click("Next");
    open<QWidget>(GuideStep::Level);
    EXPECT_EQ(stepButton(GuideStep::Level).state(), StepState::Skipped);
    click("Confirm: I have checked: elevation 0° is level");
    EXPECT_EQ(stepButton(GuideStep::Level).state(), StepState::Done);
    EXPECT_TRUE(kept.confirmed.contains(GuideStep::Level));
    EXPECT_FALSE(kept.skipped.contains(GuideStep::Level));
    EXPECT_EQ(current(), GuideStep::Level) << "confirming goes nowhere";
    open<QWidget>(GuideStep::Directions);
    for (const QPushButton* const button : guide().findChildren<QPushButton*>()) {
        EXPECT_FALSE(button->isVisible() && button->text() == QStringLiteral("Confirm")) << "this the station sees";
    }
    EXPECT_TRUE(requests.empty());
}

// REQ-UI-961: A step needs the operator while something is wrong or waits for an answer, even if it was confirmed or
// skipped. Its button shows this by a symbol and a word, also for the screen reader.
TEST_F(GuideTest, AStepNeedsYouWhileSomethingIsWrong)
{
    status = samples::factoryDrives();
    give(samples::update(status));
    open<QWidget>(GuideStep::Protection);
    click("Next");
    EXPECT_EQ(stepButton(GuideStep::Protection).state(), StepState::NeedsYou) << "skipped or not";
    EXPECT_TRUE(kept.skipped.contains(GuideStep::Protection));
    EXPECT_TRUE(stepButton(GuideStep::Protection).accessibleDescription().startsWith(QStringLiteral("needs you: ")));
    EXPECT_TRUE(stepButton(GuideStep::Protection).toolTip().contains(QStringLiteral("needs you")));

    status = samples::asking(Axis::Azimuth, 3, 180_deg, true);
    give(samples::update(status));
    EXPECT_EQ(stepButton(GuideStep::Travel).state(), StepState::NeedsYou);
    EXPECT_TRUE(stepButton(GuideStep::Travel).toolTip().contains(QStringLiteral("azimuth")));

    status = samples::freshMount();
    status.listening.clear();
    give(samples::update(status));
    EXPECT_EQ(stepButton(GuideStep::Client).state(), StepState::NeedsYou);
    EXPECT_EQ(stepButton(GuideStep::Protection).state(), StepState::Done) << "it is right now";
}

// REQ-UI-961
TEST_F(GuideTest, AMountThatDoesNotAnswerNeedsYouAndOneThatIsReadDoesNot)
{
    status.state = StationState::Disconnected;
    status.drives->driveCheck = DriveCheckState::Running;
    give(samples::update(status));
    EXPECT_EQ(stepButton(GuideStep::Connect).state(), StepState::Open);
    status.drives->driveCheck = DriveCheckState::NotDone;
    status.drives->armingObstacle = QStringLiteral("no drive answers on the bus");
    give(samples::update(status));
    EXPECT_EQ(stepButton(GuideStep::Connect).state(), StepState::NeedsYou);
    EXPECT_TRUE(stepButton(GuideStep::Connect).toolTip().contains(QStringLiteral("no drive answers")));
    EXPECT_EQ(stepButton(GuideStep::Protection).state(), StepState::Open);
    status.drives->released = true;
    give(samples::update(status));
    EXPECT_TRUE(stepButton(GuideStep::Connect).toolTip().contains(QStringLiteral("Take bus back")));
}

// REQ-UI-34
TEST_F(GuideTest, FinishLaterGoesToThePanelsAndComesBackToTheSameStep)
{
    open<QWidget>(GuideStep::North);
    click("Next");
    click("Finish later");
    EXPECT_FALSE(isOpen());
    EXPECT_FALSE(kept.open);
    Q_EMIT window.findChild<MainMenu*>()->guideWanted();
    EXPECT_TRUE(isOpen());
    EXPECT_EQ(current(), GuideStep::Site);
    EXPECT_EQ(stepButton(GuideStep::North).state(), StepState::Skipped);
}

// REQ-UI-962: The last page lists the present state of the steps: done, skipped, or in need of the operator. It leads
// back to each step, and shows what the first pass needs: the line for Gpredict, park, STOP.
TEST_F(GuideTest, TheLastPageEndsTheGuide)
{
    open<GuideReady>(GuideStep::Ready);
    click("Finish");
    EXPECT_FALSE(isOpen());
    EXPECT_FALSE(kept.confirmed.contains(GuideStep::Ready));
    EXPECT_TRUE(kept.skipped.empty());
}

// REQ-UI-962
TEST_F(GuideTest, TheLastPageLeadsBackToWhatWasSkipped)
{
    status.profile = samples::idle().profile;  // the directions are confirmed
    give(samples::update(status));
    open<QWidget>(GuideStep::North);
    click("Next");
    open<GuideReady>(GuideStep::Ready);
    auto& north = inGuide<StepButton>("Go to step 6: North");
    EXPECT_EQ(north.state(), StepState::Skipped);
    EXPECT_TRUE(inGuide<ValueLabel>("What is done").text().contains(QStringLiteral("Skipped: 1")))
        << inGuide<ValueLabel>("What is done").text().toStdString();
    status.listening.clear();
    give(samples::update(status));
    EXPECT_TRUE(
        inGuide<ValueLabel>("What is done").text().startsWith(QStringLiteral("Not ready: one step needs you.")));
    EXPECT_EQ(stepButton(GuideStep::Ready).state(), StepState::NeedsYou);
    QTest::mouseClick(&north, Qt::LeftButton);
    EXPECT_EQ(current(), GuideStep::North);
}

// REQ-UI-962
TEST_F(GuideTest, TheLastPageTellsWhatTheFirstPassNeeds)
{
    open<GuideReady>(GuideStep::Ready);
    EXPECT_TRUE(inGuide<ValueLabel>("Line for Gpredict").text().contains(QStringLiteral("Port 4533")));
    EXPECT_TRUE(inGuide<ValueLabel>("After the pass").text().contains(QStringLiteral("Ctrl+P")));
    EXPECT_TRUE(inGuide<ValueLabel>("After the pass").text().contains(QStringLiteral("F12")));
    EXPECT_TRUE(inGuide<ValueLabel>("Why the mount cannot point now").text().contains(QStringLiteral("directions")));
    click("Copy the line for Gpredict");
    EXPECT_TRUE(QApplication::clipboard()->text().contains(QStringLiteral("Port: 4533")));
    status = samples::idle();
    give(samples::update(status));
    EXPECT_TRUE(findNamed<ValueLabel>(guide(), "Why the mount cannot point now")->text().isEmpty());
}

TEST_F(GuideTest, AnotherMountBeginsAnew)
{
    open<GuideNorth>(GuideStep::North);
    click("Confirm: I have checked: north is right");
    profile::Profile other = *status.profile;
    other.mount.name = "Roof";
    putInForce(other);
    EXPECT_EQ(current(), GuideStep::Connect);
    EXPECT_EQ(kept.mount, QStringLiteral("Roof (simulated)"));
    EXPECT_TRUE(kept.confirmed.empty());
}

// Story: level and ends were confirmed on the simulated mount, and were still confirmed when the real mount was
// connected.
// REQ-UI-34
TEST_F(GuideTest, TheRealMountBeginsAnewAfterTheSimulatedOne)
{
    open<QWidget>(GuideStep::Level);
    click("Confirm: I have checked: elevation 0° is level");
    EXPECT_TRUE(kept.confirmed.contains(GuideStep::Level));
    profile::Profile real = *status.profile;
    real.bus = "socketcan:can0";
    putInForce(real);
    EXPECT_TRUE(kept.confirmed.empty());
    EXPECT_EQ(kept.mount, toQString(real.mount.name));
    EXPECT_EQ(stepButton(GuideStep::Travel).state(), StepState::Open);
}

// Story: the list arrived before the first status. It contained only the simulated mount, which was selected, and Scan
// answered for it.
TEST_F(GuideTest, TheBusInUseIsSelectedWhenItComesIntoTheList)
{
    open<GuideConnect>(GuideStep::Connect);
    Q_EMIT window.host().adaptersFound(adaptersOf({}, {}));
    QSignalSpy wanted(&window.host(), &HostDesk::adaptersWanted);
    profile::Profile real = *status.profile;
    real.bus = "socketcan:can7";
    status.simulated = false;
    putInForce(real);
    open<GuideConnect>(GuideStep::Connect);
    ASSERT_FALSE(wanted.isEmpty());
    EXPECT_EQ(wanted.back().front().toString(), QStringLiteral("socketcan:can7"));
    Q_EMIT window.host().adaptersFound(withNamed(adaptersOf({}, {}), QStringLiteral("socketcan:can7")));
    auto& list = inGuide<QListWidget>("Adapters of this computer");
    EXPECT_EQ(list.currentItem()->toolTip(), QStringLiteral("socketcan:can7"));
    list.setCurrentRow(1);
    Q_EMIT window.host().adaptersFound(withNamed(adaptersOf({}, {}), QStringLiteral("socketcan:can7")));
    EXPECT_EQ(list.currentRow(), 1) << "what the operator has selected stays";
}

// Story: a bus waited for its reconnect while the level of another mount was set.
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
    EXPECT_EQ(inGuide<QPlainTextEdit>("Who answers").toPlainText(),
              QStringLiteral("In use. This rotator has no boards that can be listed."));
}

// REQ-UI-973
TEST_F(GuideTest, ARotatorWithoutBoardsHasNoStepProtectAndNothingToExchange)
{
    profile::Profile simple = *status.profile;
    simple.azimuth.driver = profile::AxisDriver::Simple;
    simple.elevation.driver = profile::AxisDriver::Simple;
    status.drives.reset();
    putInForce(simple);
    EXPECT_FALSE(stepButton(GuideStep::Protection).isVisible());
    EXPECT_EQ(stepButton(GuideStep::Connect).state(), StepState::Done);
    open<GuideDirections>(GuideStep::Directions);
    EXPECT_FALSE(findNamed<QPushButton>(guide(), "The other axis moved:\nswap the motors")->isVisible());
    QTest::keyClick(&guide(), Qt::Key_Left, Qt::AltModifier);
    EXPECT_EQ(current(), GuideStep::Connect);
    open<GuideReady>(GuideStep::Ready);
    EXPECT_FALSE(findNamed<StepButton>(guide(), "Go to step 2: Protect")->isVisible());
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
    EXPECT_TRUE(inGuide<ValueLabel>("What is in the way").text().contains(QStringLiteral("step 2 (Protect)")));
    EXPECT_EQ(stepButton(GuideStep::Protection).state(), StepState::NeedsYou);
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
                                 .confirmed = {GuideStep::Level},
                                 .skipped = {GuideStep::North, GuideStep::Site},
                                 .mount = QStringLiteral("Roof | west")};
    EXPECT_EQ(guideProgressFrom(toText(progress)), progress);
    EXPECT_EQ(guideProgressFrom(QStringLiteral("rubbish")), GuideProgress{});
    EXPECT_EQ(guideProgressFrom(QStringLiteral("open|level|travel level|north|Roof")), GuideProgress{})
        << "of a time when each Next counted as done";
}

// A window that was closed while the guide was shown opens with the guide at the same step.
// REQ-UI-34 (GuideAtStart.*)
TEST(GuideAtStart, OpensWhereItWas)
{
    const fakes::ManualClock clock;
    WindowSettings settings;
    settings.guide = {.open = true,
                      .current = GuideStep::Site,
                      .confirmed = {GuideStep::Level},
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
