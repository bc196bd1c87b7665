// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/drives/drives_panel.h"

#include "tests/ui/drives/drives_fixture.h"
#include "ui/drives/protection_panel.h"
#include "ui/drives/turn_page.h"
#include "ui/jog/jog_panel.h"
#include "ui/kit/page_room.h"
#include "ui/log/log_panel.h"
#include "ui/north/calibration_panel.h"

#include <QDoubleSpinBox>

namespace boresight::ui {
namespace {

TEST_F(DrivesTest, KeysOpenThePanels)
{
    QWidget* shown = window.findChild<JogPanel*>();
    for (const auto& [digit, panel] : {std::pair<char, QWidget*>('6', window.findChild<DrivesPanel*>()),
                                       std::pair<char, QWidget*>('7', window.findChild<ProtectionPanel*>()),
                                       std::pair<char, QWidget*>('5', window.findChild<LogPanel*>()),
                                       std::pair<char, QWidget*>('1', window.findChild<JogPanel*>())}) {
        openPanel(digit);
        EXPECT_TRUE(panel->isVisible()) << digit;
        EXPECT_FALSE(shown->isVisible()) << digit;
        shown = panel;
    }
    openPanel('9');
    EXPECT_TRUE(window.findChild<CalibrationPanel*>()->isVisible());
    EXPECT_FALSE(window.findChild<TurnPage*>()->isVisible()) << "no question is open";
}

// REQ-UI-46: A mount without drives that can be read has no tabs for drives, and no line in the header.
TEST_F(DrivesTest, AMountWithoutSuchDrivesHasNoPanelsForThem)
{
    const QTabWidget& mount = *named<QTabWidget>("The mount itself");
    const auto isOffered = [&](QWidget* panel) { return mount.isTabVisible(tabOf(mount, *panel)); };
    auto* const drives = window.findChild<DrivesPanel*>();
    auto* const protection = window.findChild<ProtectionPanel*>();
    EXPECT_TRUE(isOffered(drives));
    EXPECT_TRUE(isOffered(protection));
    StationStatus status = samples::idle();
    status.drives.reset();
    status.line = {};
    give(samples::update(status));
    EXPECT_FALSE(isOffered(drives));
    EXPECT_FALSE(isOffered(protection));
    for (const char digit : {'6', '7'}) {
        openPanel(digit);
        EXPECT_FALSE(drives->isVisible());
        EXPECT_FALSE(protection->isVisible());
    }
    EXPECT_EQ(text("Line to the mount"), QString());
    give(samples::update(samples::idle()));
    EXPECT_TRUE(isOffered(drives));
    openPanel('6');
    EXPECT_TRUE(drives->isVisible());
    EXPECT_EQ(text("Line to the mount"), QStringLiteral("CAN"));
}

TEST_F(DrivesTest, ShowsWhoTheDrivesAre)
{
    EXPECT_EQ(text("Id of the elevation drive"), QStringLiteral("2"));
    EXPECT_EQ(text("UUID of the azimuth drive"), QStringLiteral("3f2a9c1d…e811"));
    EXPECT_EQ(named<ValueLabel>("UUID of the azimuth drive")->toolTip(),
              QStringLiteral("3f2a9c1d-77b0-4e0c-9a52-5b1d20c4e811"));
    EXPECT_EQ(text("Firmware of the azimuth drive"), QStringLiteral("1.1.0"));
    EXPECT_EQ(text("Register map of the azimuth drive"), QStringLiteral("5"));
    EXPECT_EQ(text("Cable wrap of the azimuth drive"), QStringLiteral("known"));
    StationStatus unknown = samples::idle();
    unknown.drives->azimuth = {};
    unknown.azimuth.turnKnown = false;
    give(samples::update(unknown));
    EXPECT_EQ(text("UUID of the azimuth drive"), QStringLiteral("---"));
    EXPECT_EQ(text("Id of the azimuth drive"), QStringLiteral("---"));
    EXPECT_EQ(named<ValueLabel>("Cable wrap of the azimuth drive")->symbol(), Symbol::Warning);
}

// The mount has only the other axis, or another kind of rotator turns this axis.
TEST_F(DrivesTest, AnAxisWithoutSuchADriveShowsNothingOfOne)
{
    StationStatus one = samples::idle();
    one.drives->elevation = {.present = false};
    give(samples::update(one));
    for (const char* const what : {"Id of the elevation drive", "UUID of the elevation drive",
                                   "Cable wrap of the elevation drive", "Crash stop of the elevation"}) {
        EXPECT_EQ(text(what), QStringLiteral("---")) << what;
    }
    EXPECT_EQ(text("Cable wrap of the azimuth drive"), QStringLiteral("known"));
}

TEST_F(DrivesTest, ABoardThatTheProfileDoesNotKnowIsListed)
{
    EXPECT_EQ(text("Unknown boards on the bus"), QString());
    StationStatus status = samples::idle();
    status.drives->unknownBoards = {{.id = 5,
                                     .identity = {.uuid = QStringLiteral("3f2a9c1d-77b0-4e0c-9a52-5b1d20c4e811"),
                                                  .firmware = QStringLiteral("1.1.0"),
                                                  .registerMap = 5}}};
    open<DrivesPanel>();
    give(samples::update(status));
    EXPECT_EQ(text("Unknown boards on the bus"),
              QStringLiteral("Also on the bus, not in the profile: id 5 (3f2a9c1d…e811, 1.1.0)"));
    EXPECT_FALSE(named<ValueLabel>("Unknown boards on the bus")->isElided());
}

TEST_F(DrivesTest, WhatIsNotKnownIsShownWhole)
{
    open<DrivesPanel>();
    give(samples::update(samples::released()));
    for (const char* const one : {"Register map of the azimuth drive", "Firmware of the elevation drive",
                                  "UUID of the elevation drive", "May the mount move"}) {
        EXPECT_FALSE(named<ValueLabel>(one)->isElided()) << one;
    }
}

// Story: while a board was missing the drives were read again every two seconds, and Release bus was blocked most of
// the time.
TEST_F(DrivesTest, TheBusCanBeReleasedWhileTheDrivesAreRead)
{
    open<DrivesPanel>();
    give(samples::update(samples::reading()));
    EXPECT_TRUE(named<CommandButton>("Release bus")->isEnabled());
    StationStatus fixing = samples::reading();
    fixing.drives->driveCheck = DriveCheckState::Fixing;
    fixing.permissions.refuse(Action::ReleaseBus, QStringLiteral("Boresight is writing the settings of the drives"));
    give(samples::update(fixing));
    expectBlocked("Release bus", "is writing the settings");
}

TEST_F(DrivesTest, TheBusIsReleasedAndTakenBackByOneButton)
{
    open<DrivesPanel>();
    StationStatus off = samples::idle();
    off.drives->switchedOn = false;
    give(samples::update(off));
    click("Release bus");
    EXPECT_EQ(asked<request::ReleaseBus>().size(), 1u);
    give(samples::acceptance(samples::released(), requests.back().id));
    EXPECT_EQ(text("Reason of the state"), QStringLiteral("bus released to other tools"));
    EXPECT_EQ(text("Station state"), QStringLiteral("DISCONNECTED"));
    EXPECT_NE(named<ValueLabel>("Station state")->tone(), Tone::Alarm) << "the operator wanted it";
    expectBlocked("Go", "The bus is released to other tools");
    click("Take bus back");
    EXPECT_EQ(asked<request::TakeBus>().size(), 1u);
    give(samples::update(samples::tracking(100)));
    expectBlocked("Release bus", "The mount moves");
}

// REQ-UI-11
TEST_F(DrivesTest, ReleasingTheBusOfDrivesThatAreOnAsksFirst)
{
    open<DrivesPanel>();
    click("Release bus");
    EXPECT_TRUE(requests.empty());
    EXPECT_TRUE(questionText().contains(QLatin1String("The drives get no more commands")));
    EXPECT_TRUE(questionText().contains(QLatin1String("An unbalanced elevation then drops a little")));
    QTest::mouseClick(act("Leave the bus"), Qt::LeftButton);
    EXPECT_EQ(asked<request::ReleaseBus>().size(), 1u);
}

// REQ-UI-11
TEST_F(DrivesTest, TheProofRunsAtTheChosenRateAfterASecondPressAndEndsAtOnce)
{
    auto& panel = open<DrivesPanel>();
    auto* const rate = named<QDoubleSpinBox>("Rate of the test");
    rate->setFocus();
    rate->selectAll();
    QTest::keyClicks(rate, QStringLiteral("3.5"));
    click("Run (both axes) …");
    EXPECT_TRUE(questionText().contains(QStringLiteral("3.5°/s")));
    EXPECT_TRUE(questionText().contains(QLatin1String("stops the commands to the drive")));
    EXPECT_TRUE(requests.empty());
    EXPECT_TRUE(questionText().contains(QLatin1String("An unbalanced elevation then drops a little")));
    QTest::mouseClick(act("Move the mount"), Qt::LeftButton);
    ASSERT_EQ(asked<request::ProveCrashStop>().size(), 1u);
    EXPECT_NEAR(asked<request::ProveCrashStop>().front().rate.degrees(), 3.5, 1e-9);
    give(samples::acceptance(samples::proving(), requests.back().id));
    EXPECT_FALSE(panel.isAsking());
    EXPECT_EQ(text("Crash-stop test"), QStringLiteral("azimuth at 2.0°/s, not fed since 0.3 s"));
    EXPECT_FALSE(rate->isEnabled());
    click("End test");
    EXPECT_EQ(asked<request::EndProof>().size(), 1u);
}

// Story: the Hold button was grey while the crash-stop test moved the mount.
TEST_F(DrivesTest, HoldIsOfferedDuringAProofThatForbidsEveryOtherMotion)
{
    give(samples::update(samples::proving()));
    EXPECT_TRUE(named<CommandButton>("Hold")->isEnabled());
    EXPECT_FALSE(named<CommandButton>("Park")->isEnabled());
}

TEST_F(DrivesTest, TheRateOfTheProofStaysSlow)
{
    auto* const rate = named<QDoubleSpinBox>("Rate of the test");
    rate->setValue(60.0);
    EXPECT_DOUBLE_EQ(rate->value(), 5.0);
    rate->setValue(0.0);
    EXPECT_DOUBLE_EQ(rate->value(), 0.5);
}

TEST_F(DrivesTest, EachAxisShowsItsLastProofWithTheDate)
{
    EXPECT_EQ(text("Crash stop of the azimuth"),
              QStringLiteral("2.0°/s: stopped after 0.21° in 0.14 s, 2026-11-21 11:59Z"));
    StationStatus status = samples::proving();
    status.drives->azimuth.crashStop->drive = status.drives->elevation.identity.uuid;
    give(samples::update(status));
    EXPECT_EQ(text("Crash stop of the elevation"), QStringLiteral("not tested yet"));
    EXPECT_EQ(named<ValueLabel>("Crash stop of the azimuth")->symbol(), Symbol::Warning) << "another drive";
}

// REQ-UI-12
TEST_F(DrivesTest, NoProofWhileTheMountMovesOrATurnIsUnknown)
{
    give(samples::update(samples::tracking(100)));
    expectBlocked("Run (both axes) …", "The mount moves");
    give(samples::update(samples::asking(Axis::Elevation, 3, 30_deg, false)));
    expectBlocked("Run (both axes) …", "The cable wrap of the elevation drive is unknown");
}

// REQ-UI-12: An action that the drives, an unknown wrap or a released bus forbid is not offered, and the reason is
// shown.
TEST_F(DrivesTest, AnArmingObstacleDisablesEveryMotionControlWithItsReason)
{
    give(samples::update(samples::factoryDrives()));
    const char* const why = "first: azimuth lower limit";
    for (const char* const button : {"Go", "Home", "Park", "Hold", "Go here", "Run (both axes) …"}) {
        expectBlocked(button, why);
    }
    for (const char* const jog : {"Elevation up while held", "Azimuth clockwise while held"}) {
        auto* const button = named<QPushButton>(jog);
        EXPECT_FALSE(button->isEnabled());
        EXPECT_TRUE(button->toolTip().contains(QLatin1String(why)));
    }
    EXPECT_TRUE(text("May the mount move").startsWith(QLatin1String("Nothing may move: 5 settings")));
}

}  // namespace
}  // namespace boresight::ui
