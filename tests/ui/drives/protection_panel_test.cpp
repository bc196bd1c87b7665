// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/drives/protection_panel.h"

#include "core/drive_check/setting_names.h"
#include "tests/ui/drives/drives_fixture.h"

namespace boresight::ui {
namespace {

// REQ-UI-11: The panel shows the wanted and the found safety settings of the drives. An action that writes, switches
// off or moves asks first and lists what it will do.
TEST_F(DrivesTest, TheTableSetsFoundAgainstWantedWithShapeAndWord)
{
    give(samples::update(samples::factoryDrives()));
    open<ProtectionPanel>();
    const int mode = rowOf("If commands stop");
    EXPECT_EQ(cell(mode, ProtectionModel::Wanted), QStringLiteral("10 (hold)"));
    EXPECT_EQ(cell(mode, ProtectionModel::FoundAzimuth), QStringLiteral("12 (damp)"));
    EXPECT_EQ(cell(mode, ProtectionModel::Verdict), QStringLiteral("unsafe"));
    EXPECT_FALSE(model().index(mode, ProtectionModel::Verdict).data(Qt::DecorationRole).isNull());
    EXPECT_EQ(model().index(mode, ProtectionModel::Setting).data(Qt::ToolTipRole).toString(),
              QStringLiteral("servo.timeout_mode"));
    const int right = rowOf("Watchdog time");
    EXPECT_EQ(cell(right, ProtectionModel::Verdict), QStringLiteral("OK"));
    EXPECT_TRUE(model().index(right, ProtectionModel::Verdict).data(Qt::DecorationRole).isNull());
    EXPECT_EQ(cell(rowOf("Speed limit"), ProtectionModel::Verdict), QStringLiteral("advised"));
}

TEST_F(DrivesTest, NoSettingValueOrVerdictIsCutOff)
{
    open<ProtectionPanel>();
    for (const StationStatus& status : {samples::idle(), samples::factoryDrives(), samples::reading()}) {
        give(samples::update(status));
        settle();
        for (int row = 0; row < model().rowCount(); ++row) {
            for (const int column : {ProtectionModel::Setting, ProtectionModel::Wanted, ProtectionModel::FoundAzimuth,
                                     ProtectionModel::FoundElevation, ProtectionModel::Verdict}) {
                EXPECT_LE(table().sizeHintForIndex(model().index(row, column)).width(), table().columnWidth(column))
                    << cell(row, ProtectionModel::Setting).toStdString() << ' ' << column;
            }
        }
    }
}

TEST_F(DrivesTest, WhatMustBeMendedStandsOnTop)
{
    give(samples::update(samples::factoryDrives()));
    EXPECT_EQ(cell(0, ProtectionModel::Setting), QStringLiteral("Lower limit AZ"));
    EXPECT_EQ(cell(model().rowCount() - 1, ProtectionModel::Verdict), QStringLiteral("OK"));
    EXPECT_EQ(rowOf("Bus address AZ"), 9);
}

TEST_F(DrivesTest, AxesThatWantDifferentValuesHaveARowEach)
{
    const int azimuth = rowOf("Upper limit AZ");
    EXPECT_EQ(cell(azimuth, ProtectionModel::Wanted), QStringLiteral("453.0°"));
    EXPECT_EQ(cell(azimuth, ProtectionModel::FoundAzimuth), QStringLiteral("453.0°"));
    EXPECT_EQ(cell(azimuth, ProtectionModel::FoundElevation), QString());
    EXPECT_EQ(rowOf("Upper limit EL"), azimuth + 1);
    EXPECT_EQ(cell(azimuth + 1, ProtectionModel::Wanted), QStringLiteral("93.0°"));
    EXPECT_EQ(cell(azimuth + 1, ProtectionModel::FoundAzimuth), QString());
}

// Story: for an elevation axis whose drive counts in reverse, the page showed "lower limit 93°, upper limit -3°".
TEST_F(DrivesTest, TheLimitsOfAReversedDriveAreShownTheOperatorsWayRound)
{
    StationStatus status = samples::idle();
    for (ProtectionLine& line : status.drives->elevation.protections) {
        if (line.key.startsWith(QLatin1String("servopos.position_"))) {
            const bool lower = line.key.endsWith(QLatin1String("min"));
            line.wanted = line.found =
                lower ? QStringLiteral("-0.258333 turns (93.0°)") : QStringLiteral("0.008333 turns (-3.0°)");
            line.wantedBrief = line.foundBrief = lower ? QStringLiteral("93.0°") : QStringLiteral("-3.0°");
            line.name = drive_check::settingName(line.key.toStdString(), true);
        }
    }
    give(samples::update(status));
    EXPECT_EQ(cell(rowOf("Upper limit EL"), ProtectionModel::FoundElevation), QStringLiteral("93.0°"));
    EXPECT_EQ(cell(rowOf("Lower limit EL"), ProtectionModel::FoundElevation), QStringLiteral("-3.0°"));
    EXPECT_EQ(rowOf("Lower limit EL"), rowOf("Lower limit AZ") + 1);
}

TEST_F(DrivesTest, ARangeIsShownInDegreesNotInTurns)
{
    StationStatus status = samples::idle();
    for (ProtectionLine& line : status.drives->elevation.protections) {
        if (line.key == QLatin1String("servo.default_velocity_limit")) {
            line.wanted = QStringLiteral("0.0222 to 0.0444 turns/s (8 to 16°/s)");
            line.wantedBrief = QStringLiteral("8 to 16°/s");
        }
    }
    give(samples::update(status));
    EXPECT_EQ(cell(rowOf("Speed limit EL"), ProtectionModel::Wanted), QStringLiteral("8 to 16°/s"));
}

TEST_F(DrivesTest, WhatIsNotReadYetIsNotCalledRight)
{
    give(samples::update(samples::reading()));
    EXPECT_EQ(cell(rowOf("Watchdog time"), ProtectionModel::Verdict), QStringLiteral("unread"));
    EXPECT_EQ(cell(rowOf("Speed limit"), ProtectionModel::Verdict), QStringLiteral("advised"));
}

TEST_F(DrivesTest, TheReasonOfTheSelectedLineIsReadWithTheKeyboardAndStaysWhileValuesCome)
{
    give(samples::update(samples::factoryDrives()));
    open<ProtectionPanel>();
    EXPECT_EQ(text("Why the selected setting matters"),
              QStringLiteral("8 unsafe, 6 advised. Select a line to read why it matters"));
    table().setFocus();
    while (table().currentIndex().row() < rowOf("If commands stop")) {
        QTest::keyClick(&table(), Qt::Key_Down);
    }
    const QString reason = text("Why the selected setting matters");
    EXPECT_EQ(reason, QStringLiteral("If commands stop: wanted 10 (hold), found AZ 12 (damp), EL 12 (damp).\n"
                                     "Mode 12 only damps. Without commands a loaded elevation creeps down."));
    EXPECT_FALSE(named<ValueLabel>("Why the selected setting matters")->isElided());
    give(samples::update(samples::reading()));
    EXPECT_EQ(table().currentIndex().row(), rowOf("If commands stop")) << "the line moved, the selection with it";
    EXPECT_TRUE(text("Why the selected setting matters").contains(QLatin1String("found AZ 12 (damp), EL unread")));
    QTest::keyClick(&table(), Qt::Key_Tab);
    EXPECT_FALSE(table().hasFocus()) << "focus trap";
}

TEST_F(DrivesTest, ReadAgainAsksAtOnceAndWaitsWhileReading)
{
    open<ProtectionPanel>();
    click("Read again");
    EXPECT_EQ(asked<request::ReadDrives>().size(), 1u);
    give(samples::refusal(samples::idle(), requests.back().id, "the mount is moving"));
    EXPECT_TRUE(named<CommandButton>("Read again")->isEnabled());
    give(samples::update(samples::reading()));
    expectBlocked("Read again", "Boresight is reading the drives. Wait a moment.");
    EXPECT_EQ(text("Drive check"), QStringLiteral("reading servo.timeout_mode of elevation"));
}

// REQ-UI-11
TEST_F(DrivesTest, FixListsWhatItWritesAndWritesOnlyAfterASecondPress)
{
    give(samples::update(samples::factoryDrives()));
    auto& panel = open<ProtectionPanel>();
    click("Fix …");
    EXPECT_TRUE(panel.isAsking());
    EXPECT_TRUE(requests.empty());
    EXPECT_TRUE(
        questionText().contains(QStringLiteral("AZ  Lower limit: -0.01 turns (-3.6°) → -0.258333 turns (-93.0°)")));
    EXPECT_TRUE(questionText().contains(QStringLiteral("EL  If commands stop: 12 (damp) → 10 (hold)")));
    EXPECT_FALSE(questionText().contains(QLatin1String("Max. supply"))) << "it is right already";
    const QStringList parts = questionText().split(QStringLiteral("Set these yourself"));
    ASSERT_EQ(parts.size(), 2);
    EXPECT_FALSE(parts[0].contains(QLatin1String("Gear ratio"))) << "never written by itself";
    EXPECT_TRUE(
        parts[1].contains(QLatin1String("Gear ratio (motor_position.rotor_to_output_ratio): 1, wanted 0.00666667")));
    QTest::mouseClick(act("Write"), Qt::LeftButton);
    EXPECT_EQ(asked<request::FixDrives>().size(), 1u);
    give(samples::acceptance(samples::factoryDrives(), requests.back().id));
    EXPECT_FALSE(panel.isAsking());
}

TEST_F(DrivesTest, FixNeedsDrivesThatAreReadSwitchedOffAndWrong)
{
    StationStatus status = samples::factoryDrives();
    status.permissions.refuse(Action::FixDrives, QStringLiteral("the azimuth drive is switched on"));
    give(samples::update(status));
    expectBlocked("Fix …", "is switched on");
    give(samples::update(samples::idle()));
    expectBlocked("Fix …", "every setting is right");
    give(samples::update(samples::released()));
    expectBlocked("Fix …", "the drives are not read yet");
}

TEST_F(DrivesTest, AnOpenQuestionIsBlockedWhenItCanNotBeDoneAnyMore)
{
    StationStatus status = samples::factoryDrives();
    give(samples::update(status));
    open<ProtectionPanel>();
    click("Fix …");
    status.permissions.refuse(Action::FixDrives, QStringLiteral("the azimuth drive is switched on"));
    give(samples::update(status));
    EXPECT_FALSE(act("Write")->isEnabled());
    QTest::mouseClick(act("Write"), Qt::LeftButton);
    status = samples::factoryDrives();
    give(samples::update(status));
    EXPECT_FALSE(act("Write")->isEnabled()) << "its list may be out of date";
    EXPECT_TRUE(asked<request::FixDrives>().empty());
}

// REQ-UI-11
TEST_F(DrivesTest, SwitchOffWarnsOfTheFallAndCancelHasTheFocus)
{
    auto& panel = open<ProtectionPanel>();
    click("Switch drives off …");
    EXPECT_TRUE(questionText().contains(QLatin1String("unbalanced elevation falls")));
    ASSERT_EQ(window.focusWidget()->accessibleName(), QStringLiteral("Cancel"));
    QTest::keyClick(window.focusWidget(), Qt::Key_Space);
    EXPECT_FALSE(panel.isAsking());
    EXPECT_EQ(window.focusWidget(), named<CommandButton>("Switch drives off …"));
    EXPECT_TRUE(requests.empty());
    QTest::keyClick(window.focusWidget(), Qt::Key_Space);
    act("Switch off")->setFocus();
    QTest::keyClick(act("Switch off"), Qt::Key_Space);
    EXPECT_EQ(asked<request::SwitchOff>().size(), 1u);
}

// REQ-UI-990: The drive of each axis has its own button. It asks first, says which axis loses its torque and that the
// other one holds, and is blocked with the station's reason.
TEST_F(DrivesTest, OneDriveIsSwitchedOffAloneAfterAQuestion)
{
    open<ProtectionPanel>();
    click("Elevation off …");
    EXPECT_TRUE(questionText().contains(QLatin1String("The azimuth stays as it is.")));
    EXPECT_TRUE(requests.empty());
    QTest::keyClick(act("Switch off"), Qt::Key_Space);
    ASSERT_EQ(asked<request::SwitchOff>().size(), 1u);
    EXPECT_EQ(asked<request::SwitchOff>().front().axis, Axis::Elevation);
    StationStatus status = samples::idle();
    status.permissions.refuse(Action::SwitchOffAzimuth, QStringLiteral("The azimuth drive is switched off already."));
    give(samples::update(status));
    EXPECT_FALSE(named<CommandButton>("Azimuth off …")->isEnabled());
    EXPECT_TRUE(named<CommandButton>("Elevation off …")->isEnabled());
}

// Story: Esc stopped the mount and left the question open, although the help says that Esc closes it.
TEST_F(DrivesTest, EscClosesTheQuestionAndTheNextOneStops)
{
    auto& panel = open<ProtectionPanel>();
    click("Switch drives off …");
    ASSERT_TRUE(panel.isAsking());
    QTest::keyClick(&window, Qt::Key_Escape);
    EXPECT_FALSE(panel.isAsking());
    EXPECT_TRUE(requests.empty());
    QTest::keyClick(&window, Qt::Key_Escape);
    EXPECT_EQ(asked<request::Stop>().size(), 1u);
}

TEST_F(DrivesTest, AQuestionThatIsLeftDoesNotWaitForAPress)
{
    auto& panel = open<ProtectionPanel>();
    click("Switch drives off …");
    openPanel('1');
    open<ProtectionPanel>();
    EXPECT_FALSE(panel.isAsking());
}

TEST_F(DrivesTest, ARefusedQuestionStaysWithTheReason)
{
    auto& panel = open<ProtectionPanel>();
    click("Switch drives off …");
    QTest::mouseClick(act("Switch off"), Qt::LeftButton);
    give(samples::refusal(samples::idle(), requests.back().id, "the mount is moving"));
    EXPECT_TRUE(panel.isAsking());
    bool shown = false;
    for (const ValueLabel* const label : panel.findChildren<ValueLabel*>()) {
        shown = shown || (label->isVisible() && label->text() == QLatin1String("Switch off: the mount is moving"));
    }
    EXPECT_TRUE(shown);
}

// REQ-ENDSWITCH-67: The page Protection shows each end switch of the profile: its end, its state, its input, and why it
// cannot be read. A switch that is not free is marked. Without end switches the page shows nothing of them.
TEST_F(DrivesTest, TheStateOfTheEndSwitchesIsShown)
{
    using end_switches::SwitchState;
    auto& panel = open<ProtectionPanel>();
    const auto& line = *findNamed<ValueLabel>(panel, "End switches");
    StationStatus status = samples::idle();
    give(samples::update(status));
    EXPECT_EQ(line.text(), QString());
    status.endSwitches = {
        {.which = {Axis::Azimuth, true}, .input = QStringLiteral("moteus:1:aux1.0"), .state = SwitchState::Free}};
    give(samples::update(status));
    EXPECT_EQ(line.text(), QStringLiteral("End switches: AZ upper end: free (moteus:1:aux1.0)"));
    EXPECT_EQ(line.tone(), Tone::Normal);
    status.endSwitches.push_back({.which = {Axis::Elevation, false},
                                  .input = QStringLiteral("moteus:2:aux1.0"),
                                  .state = SwitchState::Unread,
                                  .problem = QStringLiteral("The pin is no input")});
    give(samples::update(status));
    EXPECT_TRUE(line.text().endsWith(QStringLiteral("EL lower end: not read (moteus:2:aux1.0). The pin is no input")));
    EXPECT_EQ(line.tone(), Tone::Warning);
}

}  // namespace
}  // namespace boresight::ui
