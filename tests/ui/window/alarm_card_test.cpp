// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/alarm_card.h"

#include "core/alarms/catalogue.h"
#include "tests/ui/sample_alarms.h"
#include "tests/ui/window_fixture.h"
#include "ui/kit/command_button.h"
#include "ui/kit/lines_view.h"
#include "ui/log/log_panel.h"
#include "ui/window/guide_room.h"
#include "ui/window/panel_tabs.h"

#include <QLineEdit>
#include <QPlainTextEdit>
#include <QTableView>

namespace boresight::ui {
namespace {

constexpr QSize kWithRoom{1920, 1080};  // room for one line for each sentence

class AlarmCardTest : public WindowFixture
{
protected:
    AlarmCard& card() { return *window.findChild<AlarmCard*>(); }
    PanelTabs& panels() { return *window.findChild<PanelTabs*>(); }
    bool seen(const char* button) { return named<QPushButton>(button)->isVisible(); }
    // After the moment in which a new button does nothing.
    void press(const char* button)
    {
        elapse(Seconds(1.0));
        QTest::mouseClick(named<CommandButton>(button), Qt::LeftButton);
    }
};

// REQ-UI-802 (AlarmCardTest.*): The top alarm is shown completely in the window, with the one button that helps. The
// card is shown only while there is an alarm, a latched STOP or a notice. A click on its text opens its line in the
// log, and the count opens the list.
TEST_F(AlarmCardTest, IsThereOnlyWhileThereIsAnAlarm)
{
    window.resize(kWithRoom);
    QCoreApplication::processEvents();
    EXPECT_FALSE(card().isVisible());
    give(samples::update(samples::faulted()));
    EXPECT_TRUE(card().isVisible());
    EXPECT_TRUE(text("Worst alarm").startsWith(QStringLiteral("The azimuth drive reports fault 38")));
    const Alarm alarm = samples::faulted().alarms.front();
    for (const QString& sentence : {alarm.action, alarm.remedy}) {
        EXPECT_TRUE(text("What was done and what to do").contains(sentence)) << sentence.toStdString();
    }
    give(samples::update(samples::idle()));
    EXPECT_FALSE(card().isVisible());
    window.warn(QStringLiteral("The profile was not stored."));
    EXPECT_TRUE(card().isVisible()) << "a notice, too";
    window.warn({});
    EXPECT_FALSE(card().isVisible());
}

TEST_F(AlarmCardTest, AnAlarmThatIsOverSaysSo)
{
    StationStatus status = samples::faulted();
    status.state = StationState::Standby;
    for (Alarm& alarm : status.alarms) {
        alarm.active = false;
    }
    give(samples::update(status));
    EXPECT_TRUE(text("Worst alarm").startsWith(QStringLiteral("Cleared: ")));
    EXPECT_TRUE(seen("Acknowledge"));
    EXPECT_FALSE(named<CommandButton>("Reset stop")->isVisible());
}

// Story: an alarm of the cable had ended, and the card still said "Press Unwrap now", a button that was gone.
TEST_F(AlarmCardTest, AnAlarmThatIsOverAsksForNothing)
{
    StationStatus status = samples::tracking(0.0);
    status.alarms = {{.name = QStringLiteral("cable.turns-back"),
                      .severity = Severity::Warning,
                      .what = QStringLiteral("The azimuth reaches its cable end."),
                      .action = QStringLiteral("Boresight will unwrap the cable there."),
                      .remedy = QStringLiteral("Press Unwrap now."),
                      .help = AlarmHelp::Unwind}};
    give(samples::update(status));
    EXPECT_TRUE(text("What was done and what to do").contains(QStringLiteral("Unwrap now")));
    status.alarms.front().active = false;
    give(samples::update(status));
    EXPECT_FALSE(text("What was done and what to do").contains(QStringLiteral("Unwrap now")));

    // A fault that is over still needs its Re-arm.
    status = samples::faulted();
    status.alarms.front().active = false;
    status.alarms.front().remedy = QStringLiteral("Then press Re-arm.");
    status.alarms.front().help = AlarmHelp::Rearm;
    give(samples::update(status));
    EXPECT_TRUE(text("What was done and what to do").contains(QStringLiteral("Re-arm")));
}

TEST_F(AlarmCardTest, StopInAFaultLeavesBothWaysBackOneAfterTheOther)
{
    StationStatus status = samples::faulted();
    status.stopLatched = true;
    give(samples::update(status));
    QTest::mouseClick(named<CommandButton>("Re-arm"), Qt::LeftButton);
    EXPECT_EQ(asked<request::Rearm>().size(), 1u);
    give(samples::acceptance(samples::stopped(), requests.back().id));
    EXPECT_EQ(text("Worst alarm"), QStringLiteral("STOP is latched."));
    press("Reset stop");
    EXPECT_EQ(asked<request::ResetStop>().size(), 1u);
}

// Story: the second press of a double click on Re-arm hit Park now, whose alarm came next, and the mount moved.
// REQ-UI-1780: For a moment after another button has taken its place on the alarm card, a press does nothing.
TEST_F(AlarmCardTest, TheSecondPressOfADoubleClickOnReArmMovesNothing)
{
    give(samples::update(samples::faulted()));
    QTest::mouseClick(named<CommandButton>("Re-arm"), Qt::LeftButton);
    give(samples::acceptance(samples::alarmed(alarmEntry("wind.not-parked")), requests.back().id));
    QTest::mouseClick(named<CommandButton>("Park now"), Qt::LeftButton);
    EXPECT_TRUE(asked<request::Park>().empty());
    press("Park now");
    EXPECT_EQ(asked<request::Park>().size(), 1u);
}

// Story: a second click on Re-arm hit Acknowledge, which had moved under the pointer.
// REQ-UI-1006: No button of the alarm card moves to the place of another one that has just disappeared.
TEST_F(AlarmCardTest, ASecondClickOnAButtonThatIsGoneHitsNoOther)
{
    for (const QSize size : {QSize(1024, 700), QSize(1280, 800)}) {
        window.resize(size);
        StationStatus status = samples::faulted();
        give(samples::update(status));
        settle();
        const QPoint place = named<CommandButton>("Re-arm")->mapTo(&card(), QPoint(20, 20));
        ASSERT_EQ(card().childAt(place), named<CommandButton>("Re-arm"));
        status.state = StationState::Standby;
        for (Alarm& alarm : status.alarms) {
            alarm.active = false;
        }
        give(samples::update(status));
        settle();
        ASSERT_TRUE(seen("Acknowledge"));
        EXPECT_EQ(qobject_cast<QPushButton*>(card().childAt(place)), nullptr) << size.width();
    }
}

TEST_F(AlarmCardTest, StopBesideAnotherAlarmCanBeReset)
{
    StationStatus status = samples::cableEnding();
    status.stopLatched = true;
    status.state = StationState::Stopped;
    give(samples::update(status));
    EXPECT_TRUE(seen("Unwrap now"));
    EXPECT_TRUE(seen("Reset stop"));
}

// REQ-CONTROL-31c
TEST_F(AlarmCardTest, BothChoicesAtTheCableEndSayWhatTheyLose)
{
    window.resize(kWithRoom);
    QCoreApplication::processEvents();
    StationStatus status = samples::cableEnding();
    give(samples::update(status));
    EXPECT_FALSE(text("What was done and what to do").contains(QStringLiteral("Holding at the end loses")));
    status.cableEnd->lostByHolding = Seconds(190.0);
    give(samples::update(status));
    EXPECT_TRUE(text("What was done and what to do")
                    .endsWith(QStringLiteral("Holding at the end loses the target for about 3 min 10 s if it keeps its "
                                             "azimuth rate.")))
        << "a stream of a client";
    status.tracked = TrackedTarget{.name = QStringLiteral("ISS"), .isUp = true};
    status.cableEnd->lostByHolding = Seconds(192.4);
    give(samples::update(status));
    const QString cost = QStringLiteral("Holding at the end loses the target for 3 min 12 s.");
    EXPECT_TRUE(text("What was done and what to do").endsWith(cost));
    EXPECT_FALSE(text("What was done and what to do").contains(QStringLiteral("Unwrapping loses")))
        << "what Boresight will do says it";
    status.alarms.front().acknowledged = true;
    give(samples::update(status));
    EXPECT_EQ(text("What was done and what to do").replace(QLatin1Char('\n'), QLatin1Char(' ')),
              QStringLiteral("Unwrapping loses the target for 37 s. ") + cost)
        << "the choice is open";
    EXPECT_TRUE(named<ValueLabel>("What was done and what to do")->isVisible());
}

TEST_F(AlarmCardTest, TheButtonDoesWhatHelps)
{
    give(samples::update(samples::cableEnding()));
    QTest::mouseClick(named<CommandButton>("Unwrap now"), Qt::LeftButton);
    EXPECT_EQ(asked<request::Unwind>().size(), 1u);
    give(samples::acceptance(samples::alarmed(alarmEntry("bus.left-alone")), requests.back().id));
    press("Reconnect");
    ASSERT_EQ(asked<request::Reconnect>().size(), 1u);
    EXPECT_EQ(asked<request::Reconnect>().front().profile, *samples::idle().profile);
}

TEST_F(AlarmCardTest, TheButtonOpensThePanelThatHelps)
{
    const auto opens = [this](const AlarmEntry& entry, const char* button) {
        openPanel('1');
        give(samples::update(samples::alarmed(entry)));
        press(button);
        return panels().arrangement().panel;
    };
    EXPECT_EQ(opens(alarmEntry("drives.dangerous"), "Open Protection"), 7);
    EXPECT_EQ(opens(alarmEntry("drive.no-reply"), "Open Drives"), 6);
    EXPECT_EQ(opens(alarmEntry("cable.ends"), "Open Limits"), 3);
    EXPECT_EQ(opens(alarmEntry("north.not-set"), "Open North"), 9);
    EXPECT_EQ(opens(alarmEntry("rotctld.open"), "Open Profile"), 8);
}

// REQ-UI-1701: The alarm about a clock that was set has the button Use new time.
TEST_F(AlarmCardTest, TheNewTimeIsUsedByItsButton)
{
    give(samples::update(samples::alarmed(alarmEntry("clock.kept"))));
    QTest::mouseClick(named<CommandButton>("Use new time"), Qt::LeftButton);
    EXPECT_EQ(asked<request::UseNewTime>().size(), 1u);
}

// REQ-WIND-28: The alarm about the wind has the buttons Move anyway and Park now.
TEST_F(AlarmCardTest, TheWindHasTwoButtons)
{
    give(samples::update(samples::alarmed(alarmEntry("wind.parks"))));
    QTest::mouseClick(named<CommandButton>("Move anyway"), Qt::LeftButton);
    EXPECT_EQ(asked<request::OverrideWind>().size(), 1u);
    const StationStatus notParked = samples::alarmed(alarmEntry("wind.not-parked"));
    give(samples::acceptance(notParked, requests.back().id));
    EXPECT_TRUE(named<CommandButton>("Move anyway")->isVisible());
    press("Park now");
    EXPECT_EQ(asked<request::Park>().size(), 1u);
}

// Every help in the catalogue has a button with a text and an effect.
TEST_F(AlarmCardTest, EveryHelpActs)
{
    for (const AlarmEntry* const entry : alarmCatalogue()) {
        if (entry->help == AlarmHelp::None) {
            continue;
        }
        openPanel('1');
        requests.clear();
        StationStatus status = samples::alarmed(*entry);
        if (entry->help == AlarmHelp::Unwind) {
            status.permissions = samples::cableEnding().permissions;
        }
        status.state = entry->help == AlarmHelp::Rearm ? StationState::Fault : StationState::Standby;
        status.stopLatched = entry->help == AlarmHelp::ResetStop;
        give(samples::update(status));
        const QString button = buttonText(entry->help);
        ASSERT_FALSE(button.isEmpty()) << entry->id;
        press(button.toUtf8().constData());
        const bool showsGuide = window.findChild<GuideRoom*>()->currentWidget() != &panels();
        EXPECT_TRUE(requests.size() == 1 || panels().arrangement().panel != 1 || showsGuide) << entry->id;
        for (const NumberedRequest& request : requests) {
            give(samples::acceptance(status, request.id));
        }
    }
}

TEST_F(AlarmCardTest, AClickOnTheTextOpensItsLineInTheLog)
{
    StationUpdate update = samples::update(samples::faulted());
    const Alarm& alarm = update.status.alarms.front();
    for (std::uint64_t i = 1; i <= 40; ++i) {
        update.log.push_back(
            samples::logEntry(i, Severity::Advisory, QStringLiteral("operator"), QStringLiteral("go")));
    }
    LogEntry line = samples::logEntry(41, alarm.severity, QStringLiteral("azimuth drive"),
                                      QStringLiteral("Fault 38: The line of the alarm."));
    line.utc = alarm.since;
    line.kind = LogKind::Alarm;
    line.alarm = {.name = alarm.name, .about = alarm.about};
    LogEntry other = line;
    other.source = QStringLiteral("elevation drive");
    other.alarm.about = QStringLiteral("elevation");
    other.text = QStringLiteral("Of the other axis.");
    update.log.push_back(other);
    update.log.push_back(line);
    update.log.push_back(samples::logEntry(42, Severity::Advisory, QStringLiteral("operator"), QStringLiteral("go")));
    give(update);
    named<QLineEdit>("Filter by text")->setText(QStringLiteral("go"));  // hides it
    settle();
    QTest::mouseClick(named<ValueLabel>("Worst alarm"), Qt::LeftButton);
    EXPECT_EQ(panels().arrangement().panel, 5);
    EXPECT_TRUE(
        named<QPlainTextEdit>("Selected line")->toPlainText().contains(QStringLiteral("The line of the alarm")));
}

TEST_F(AlarmCardTest, TheCountOpensTheList)
{
    give(samples::update(samples::faulted()));
    auto* const count = named<QPushButton>("All alarms");
    EXPECT_EQ(count->text(), QStringLiteral("1 of 2"));
    QTest::mouseClick(count, Qt::LeftButton);
    EXPECT_EQ(panels().arrangement().panel, 5);
    EXPECT_TRUE(named<QTableView>("Alarms")->isVisible());
    give(samples::update(samples::cableEnding()));
    EXPECT_FALSE(count->isVisible()) << "one alone";
}

}  // namespace
}  // namespace boresight::ui
