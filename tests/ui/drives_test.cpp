// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/ui/window_fixture.h"
#include "ui/drives/drives_panel.h"
#include "ui/drives/protection_model.h"
#include "ui/drives/protection_panel.h"
#include "ui/drives/turn_page.h"
#include "ui/jog/jog_panel.h"
#include "ui/kit/command_button.h"
#include "ui/log/log_panel.h"
#include "ui/north/calibration_panel.h"
#include "ui/window/panel_tabs.h"

#include <QDoubleSpinBox>
#include <QPlainTextEdit>
#include <QTableView>

namespace boresight::ui {
namespace {

class DrivesTest : public WindowFixture
{
protected:
    template <class Panel>
    Panel& open()
    {
        auto* const panel = window.findChild<Panel*>();
        window.findChild<PanelTabs*>()->bringUp(*panel);
        return *panel;
    }

    void click(const char* button) { QTest::mouseClick(named<QPushButton>(button), Qt::LeftButton); }
    void expectBlocked(const char* button, const char* why)
    {
        auto* const one = named<CommandButton>(button);
        EXPECT_FALSE(one->isEnabled()) << button;
        EXPECT_TRUE(one->toolTip().contains(QString::fromUtf8(why))) << one->toolTip().toStdString();
    }

    // The button of the open question.
    CommandButton* act(const char* text) { return &findSeen<CommandButton>(window, text); }
    QString questionText()
    {
        for (const QPlainTextEdit* const text : window.findChildren<QPlainTextEdit*>()) {
            if (text->isVisible()) {
                return text->toPlainText();
            }
        }
        return {};
    }
    QString cell(int row, ProtectionModel::Column column) { return model().index(row, column).data().toString(); }
    int rowOf(const char* setting)
    {
        for (int row = 0; row < model().rowCount(); ++row) {
            if (cell(row, ProtectionModel::Setting) == QLatin1String(setting)) {
                return row;
            }
        }
        ADD_FAILURE() << "no row " << setting;
        return 0;
    }
    ProtectionModel& model() { return *window.findChild<ProtectionModel*>(); }
    QTableView& table() { return *named<QTableView>("Protection"); }
};

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

// REQ-UI-46: A mount without drives that can be read has no tabs for them, and no line in the header.
TEST_F(DrivesTest, AMountWithoutSuchDrivesHasNoPanelsForThem)
{
    const QTabWidget& mount = *named<QTabWidget>("The mount itself");
    const auto isOffered = [&](QWidget* panel) { return mount.isTabVisible(mount.indexOf(panel)); };
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
    EXPECT_EQ(text("Turn of the azimuth drive"), QStringLiteral("known"));
    StationStatus unknown = samples::idle();
    unknown.drives->azimuth = {};
    unknown.azimuth.turnKnown = false;
    give(samples::update(unknown));
    EXPECT_EQ(text("UUID of the azimuth drive"), QStringLiteral("---"));
    EXPECT_EQ(text("Id of the azimuth drive"), QStringLiteral("---"));
    EXPECT_EQ(named<ValueLabel>("Turn of the azimuth drive")->symbol(), Symbol::Warning);
}

TEST_F(DrivesTest, ABoardThatTheProfileDoesNotKnowIsListed)
{
    EXPECT_EQ(text("Unknown boards on the bus"), QString());
    StationStatus status = samples::idle();
    status.drives->strangers = {{.id = 5,
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

// Story: with a board missing the drives were read again every two seconds, and Release bus was shut most of the time.
TEST_F(DrivesTest, TheBusCanBeReleasedWhileTheDrivesAreRead)
{
    open<DrivesPanel>();
    give(samples::update(samples::reading()));
    EXPECT_TRUE(named<CommandButton>("Release bus")->isEnabled());
    StationStatus fixing = samples::reading();
    fixing.drives->survey = SurveyState::Fixing;
    give(samples::update(fixing));
    expectBlocked("Release bus", "settings are being written");
}

// REQ-UI-11: The drives' safety settings are shown, wanted beside found. What writes, switches off or moves asks first
// and lists what it will do.
TEST_F(DrivesTest, TheTableSetsFoundAgainstWantedWithShapeAndWord)
{
    give(samples::update(samples::factoryDrives()));
    open<ProtectionPanel>();
    const int mode = rowOf("When not fed");
    EXPECT_EQ(cell(mode, ProtectionModel::Wanted), QStringLiteral("10 (hold)"));
    EXPECT_EQ(cell(mode, ProtectionModel::FoundAzimuth), QStringLiteral("12 (damp)"));
    EXPECT_EQ(cell(mode, ProtectionModel::Verdict), QStringLiteral("dangerous"));
    EXPECT_FALSE(model().index(mode, ProtectionModel::Verdict).data(Qt::DecorationRole).isNull());
    EXPECT_EQ(model().index(mode, ProtectionModel::Setting).data(Qt::ToolTipRole).toString(),
              QStringLiteral("servo.timeout_mode"));
    const int right = rowOf("Watchdog time");
    EXPECT_EQ(cell(right, ProtectionModel::Verdict), QStringLiteral("right"));
    EXPECT_TRUE(model().index(right, ProtectionModel::Verdict).data(Qt::DecorationRole).isNull());
    EXPECT_EQ(cell(rowOf("Speed limit"), ProtectionModel::Verdict), QStringLiteral("advised"));
}

TEST_F(DrivesTest, NoSettingValueOrVerdictIsCutOff)
{
    open<ProtectionPanel>();
    for (const StationStatus& status : {samples::idle(), samples::factoryDrives(), samples::reading()}) {
        give(samples::update(status));
        QTest::qWait(1);
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
    EXPECT_EQ(cell(model().rowCount() - 1, ProtectionModel::Verdict), QStringLiteral("right"));
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

// Story: of an elevation that its drive counts the other way, the page said "lower limit 93°, upper limit -3°".
TEST_F(DrivesTest, TheLimitsOfAReversedDriveAreShownTheOperatorsWayRound)
{
    StationStatus status = samples::idle();
    for (ProtectionLine& line : status.drives->elevation.protections) {
        if (line.key.startsWith(QLatin1String("servopos.position_"))) {
            const bool lower = line.key.endsWith(QLatin1String("min"));
            line.wanted = line.found =
                lower ? QStringLiteral("-0.258333 turns (93.0°)") : QStringLiteral("0.008333 turns (-3.0°)");
            line.reversed = true;
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
              QStringLiteral("8 dangerous, 6 advised. Select a line to read why it matters"));
    table().setFocus();
    while (table().currentIndex().row() < rowOf("When not fed")) {
        QTest::keyClick(&table(), Qt::Key_Down);
    }
    const QString reason = text("Why the selected setting matters");
    EXPECT_EQ(reason, QStringLiteral("servo.timeout_mode: wanted 10 (hold), found AZ 12 (damp), EL 12 (damp).\n"
                                     "mode 12 only damps: a loaded elevation creeps down when the computer dies"));
    EXPECT_FALSE(named<ValueLabel>("Why the selected setting matters")->isElided());
    give(samples::update(samples::reading()));
    EXPECT_EQ(table().currentIndex().row(), rowOf("When not fed")) << "the line moved, the selection with it";
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
    expectBlocked("Read again", "the drives are being read");
    EXPECT_EQ(text("Survey of the drives"), QStringLiteral("reading servo.timeout_mode of elevation"));
}

// REQ-UI-11
TEST_F(DrivesTest, FixListsWhatItWritesAndWritesOnlyAfterASecondPress)
{
    give(samples::update(samples::factoryDrives()));
    auto& panel = open<ProtectionPanel>();
    click("Fix …");
    EXPECT_TRUE(panel.isAsking());
    EXPECT_TRUE(requests.empty());
    EXPECT_TRUE(questionText().contains(
        QStringLiteral("AZ  servopos.position_min: -0.01 turns (-3.6°) → -0.258333 turns (-93.0°)")));
    EXPECT_TRUE(questionText().contains(QStringLiteral("EL  servo.timeout_mode: 12 (damp) → 10 (hold)")));
    EXPECT_FALSE(questionText().contains(QLatin1String("max_voltage"))) << "it is right already";
    const QStringList parts = questionText().split(QStringLiteral("Left for you"));
    ASSERT_EQ(parts.size(), 2);
    EXPECT_FALSE(parts[0].contains(QLatin1String("rotor_to_output_ratio"))) << "never written by itself";
    EXPECT_TRUE(parts[1].contains(QLatin1String("rotor_to_output_ratio: 1, wanted 0.00666667")));
    QTest::mouseClick(act("Write"), Qt::LeftButton);
    EXPECT_EQ(asked<request::FixDrives>().size(), 1u);
    give(samples::acceptance(samples::factoryDrives(), requests.back().id));
    EXPECT_FALSE(panel.isAsking());
}

TEST_F(DrivesTest, FixNeedsDrivesThatAreReadSwitchedOffAndWrong)
{
    StationStatus status = samples::factoryDrives();
    status.drives->switchedOn = true;
    give(samples::update(status));
    expectBlocked("Fix …", "is switched on");
    give(samples::update(samples::idle()));
    expectBlocked("Fix …", "every setting is right");
    status.drives->fixable = false;
    give(samples::update(status));
    expectBlocked("Fix …", "Change the marked settings by hand");
    status.drives->survey = SurveyState::NotDone;
    give(samples::update(status));
    expectBlocked("Fix …", "the drives are not read yet");
    give(samples::update(samples::released()));
    expectBlocked("Fix …", "the drives are not read yet");
}

TEST_F(DrivesTest, AnOpenQuestionIsBlockedWhenItCanNotBeDoneAnyMore)
{
    StationStatus status = samples::factoryDrives();
    give(samples::update(status));
    open<ProtectionPanel>();
    click("Fix …");
    status.drives->switchedOn = true;
    give(samples::update(status));
    EXPECT_FALSE(act("Write")->isEnabled());
    QTest::mouseClick(act("Write"), Qt::LeftButton);
    status.drives->switchedOn = false;
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

// Story: Esc stopped the mount and left the question open, while the help says that it closes it.
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
    EXPECT_TRUE(questionText().contains(QLatin1String("Nobody feeds the drives")));
    EXPECT_TRUE(questionText().contains(QLatin1String("an unbalanced elevation then drops a little")));
    QTest::mouseClick(act("Leave the bus"), Qt::LeftButton);
    EXPECT_EQ(asked<request::ReleaseBus>().size(), 1u);
}

// REQ-UI-11
TEST_F(DrivesTest, TheProofRunsAtTheChosenRateAfterASecondPressAndEndsAtOnce)
{
    auto& panel = open<DrivesPanel>();
    auto* const rate = named<QDoubleSpinBox>("Rate of the proof");
    rate->setFocus();
    rate->selectAll();
    QTest::keyClicks(rate, QStringLiteral("3.5"));
    click("Run (both axes) …");
    EXPECT_TRUE(questionText().contains(QStringLiteral("3.5°/s")));
    EXPECT_TRUE(questionText().contains(QLatin1String("stops feeding its drive")));
    EXPECT_TRUE(requests.empty());
    EXPECT_TRUE(questionText().contains(QLatin1String("an unbalanced elevation drops a little")));
    QTest::mouseClick(act("Move the mount"), Qt::LeftButton);
    ASSERT_EQ(asked<request::ProveCrashStop>().size(), 1u);
    EXPECT_NEAR(asked<request::ProveCrashStop>().front().rate.degrees(), 3.5, 1e-9);
    give(samples::acceptance(samples::proving(), requests.back().id));
    EXPECT_FALSE(panel.isAsking());
    EXPECT_EQ(text("Crash-stop proof"), QStringLiteral("azimuth at 2.0°/s, not fed since 0.3 s"));
    EXPECT_FALSE(rate->isEnabled());
    click("End proof");
    EXPECT_EQ(asked<request::EndProof>().size(), 1u);
}

// Story: Hold was grey while the proof moved the mount.
TEST_F(DrivesTest, HoldIsOfferedDuringAProofThatForbidsEveryOtherMotion)
{
    give(samples::update(samples::proving()));
    EXPECT_TRUE(named<CommandButton>("Hold")->isEnabled());
    EXPECT_FALSE(named<CommandButton>("Park")->isEnabled());
}

TEST_F(DrivesTest, TheRateOfTheProofStaysSlow)
{
    auto* const rate = named<QDoubleSpinBox>("Rate of the proof");
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
    EXPECT_EQ(text("Crash stop of the elevation"), QStringLiteral("not proved yet"));
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

// REQ-UI-12: Nothing is offered that the drives, an unknown wrap or a released bus forbid, and the reason is shown.
TEST_F(DrivesTest, AnArmingObstacleDisablesEveryMotionControlWithItsReason)
{
    give(samples::update(samples::factoryDrives()));
    const char* const why = "first: azimuth servopos.position_min";
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
