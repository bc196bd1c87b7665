// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/ui/window_fixture.h"
#include "ui/kit/choice_button.h"
#include "ui/kit/command_button.h"
#include "ui/log/alarm_model.h"
#include "ui/log/log_panel.h"

#include <QCheckBox>
#include <QPlainTextEdit>
#include <QTableView>

namespace boresight::ui {
namespace {

class AlarmsTest : public WindowFixture
{
protected:
    AlarmsTest()
    {
        openPanel('5');
        QTest::mouseClick(named<ChoiceButton>(kChoice), Qt::LeftButton);
        EXPECT_TRUE(table().isVisible());
    }
    void show(const StationStatus& status) { give(samples::update(status)); }
    // The status when the cause of the first alarm disappears, and when the alarm is acknowledged.
    static StationStatus over(StationStatus status)
    {
        status.alarms.front().active = false;
        return status;
    }
    static StationStatus acknowledged(StationStatus status)
    {
        status.alarms.front().acknowledged = true;
        return status;
    }
    static StationStatus without(StationStatus status)
    {
        status.alarms.erase(status.alarms.begin());
        return status;
    }
    QTableView& table() { return *named<QTableView>("Alarms"); }
    QString cell(int row, int column) { return table().model()->index(row, column).data().toString(); }
    QString state(int row)
    {
        return cell(row, AlarmModel::State) + QLatin1Char(' ') + cell(row, AlarmModel::Acknowledged);
    }
    int rows() { return table().model()->rowCount(); }
    QString reading() { return table().parentWidget()->findChild<QPlainTextEdit*>()->toPlainText(); }
    void clickRow(int row)
    {
        const QRect place = table().visualRect(table().model()->index(row, AlarmModel::What));
        QTest::mouseClick(table().viewport(), Qt::LeftButton, {}, place.center());
    }
    CommandButton& acknowledge() { return *named<CommandButton>("Acknowledge the selected alarm"); }

    static constexpr const char* kChoice = "Active alarms, and all alarms since the start of the window";
};

// REQ-UI-28: Every alarm is shown completely (what happened, what Boresight did, what to do) until its end, and is kept
// for the session, also across a new station. One or all can be acknowledged. A new alarm sounds once unless the sound
// is off.
TEST_F(AlarmsTest, SaysWhatHappenedWhatWasDoneAndWhatToDo)
{
    show(samples::faulted());
    ASSERT_EQ(rows(), 2);
    EXPECT_EQ(cell(0, AlarmModel::Time), QStringLiteral("17:05:52"));
    EXPECT_TRUE(cell(0, AlarmModel::What).startsWith(QStringLiteral("■ The azimuth drive reports fault 38")));
    EXPECT_TRUE(cell(1, AlarmModel::What).startsWith(QStringLiteral("▲ ")));
    EXPECT_EQ(
        reading(),
        QStringLiteral("2026-11-21 17:05:52.000Z, active, not acknowledged\n"
                       "■ The azimuth drive reports fault 38: The board (75 °C by default) or the motor is too hot.\n"
                       "Boresight: The drive switched its output off. An axis without a fault holds if its drive can.\n"
                       "To do: Likely cause: Too much torque for too long, or too little cooling. Let it cool "
                       "down. Lower the torque or improve the cooling. Then press Re-arm."))
        << "the worst is read without a click";
    clickRow(1);
    EXPECT_TRUE(reading().contains(QStringLiteral("Boresight: The drive gives less than Boresight commands.")));
}

// REQ-UI-28
TEST_F(AlarmsTest, AcknowledgesTheSelectedOne)
{
    show(samples::faulted());
    clickRow(1);
    QTest::mouseClick(&acknowledge(), Qt::LeftButton);
    ASSERT_EQ(asked<request::AcknowledgeAlarm>().size(), 1u);
    EXPECT_EQ(asked<request::AcknowledgeAlarm>().front().alarmId, 2u);
    give(samples::acceptance(acknowledged(samples::faulted()), requests.back().id));
    clickRow(1);
    table().setFocus();
    QTest::keyClick(&table(), Qt::Key_Home, Qt::ControlModifier);
    EXPECT_EQ(state(0), QStringLiteral("active yes"));
    EXPECT_FALSE(acknowledge().isEnabled());
    EXPECT_TRUE(acknowledge().toolTip().contains(QStringLiteral("This alarm is acknowledged.")));
    QTest::keyClick(&table(), Qt::Key_Down);
    ASSERT_TRUE(acknowledge().isEnabled());
    acknowledge().setFocus();
    QTest::keyClick(&acknowledge(), Qt::Key_Space);
    EXPECT_EQ(asked<request::AcknowledgeAlarm>().size(), 2u);
}

// REQ-UI-28
TEST_F(AlarmsTest, AcknowledgesAllByButtonAndKey)
{
    EXPECT_FALSE(named<CommandButton>("Acknowledge all")->isEnabled());
    show(samples::faulted());
    QTest::mouseClick(named<CommandButton>("Acknowledge all"), Qt::LeftButton);
    EXPECT_EQ(asked<request::AcknowledgeAlarms>().size(), 1u);
    QTest::keyClick(&table(), Qt::Key_F8);
    EXPECT_EQ(asked<request::AcknowledgeAlarms>().size(), 2u);
}

// REQ-UI-28
TEST_F(AlarmsTest, FollowsAnAlarmToItsEndAndKeepsIt)
{
    const StationStatus both = samples::faulted();
    show(both);
    show(acknowledged(both));
    EXPECT_EQ(state(0), QStringLiteral("active yes"));
    StationStatus later = without(both);
    later.utc += std::chrono::seconds(60);
    show(later);
    ASSERT_EQ(rows(), 2);
    EXPECT_TRUE(cell(0, AlarmModel::What).startsWith(QStringLiteral("▲"))) << "what lasts stands first";
    EXPECT_EQ(state(1), QStringLiteral("over yes"));
    show(over(later));
    EXPECT_EQ(state(0), QStringLiteral("over no")) << "it waits for its acknowledgement";
    show(without(later));
    EXPECT_EQ(rows(), 2);
    EXPECT_EQ(state(0), QStringLiteral("over yes")) << "only that takes it from the station's list";
    EXPECT_EQ(named<ChoiceButton>(kChoice)->text(), QStringLiteral("Alarms"));
}

// Story: a new station counts its alarms, like its lines, from 1 again.
// REQ-UI-28
TEST_F(AlarmsTest, TakesTheAlarmsOfANewStationForNewOnes)
{
    StationStatus first = samples::faulted();
    first.tick = 5000;
    show(first);
    StationStatus second = without(samples::faulted());
    second.tick = 3;
    second.alarms.front().id = 1;
    second.alarms.front().since += std::chrono::seconds(60);
    openPanel('5');  // with Ctrl: the selection is complete whatever key is pressed
    show(second);
    ASSERT_EQ(rows(), 3);
    EXPECT_EQ(table().selectionModel()->selectedRows().size(), 1);
    EXPECT_EQ(state(0), QStringLiteral("active no"));
    EXPECT_EQ(cell(0, AlarmModel::Time), QStringLiteral("17:06:52"));
    EXPECT_EQ(state(1), QStringLiteral("over no")) << "nobody has acknowledged it";
    EXPECT_EQ(state(2), QStringLiteral("over no"));
    EXPECT_TRUE(reading().startsWith(QStringLiteral("2026-11-21 17:06:52"))) << "not about one that is over";
}

// REQ-UI-28
TEST_F(AlarmsTest, SoundsOnceForEachNewAlarmUnlessSilenceIsChosen)
{
    QSignalSpy beeps(window.findChild<LogPanel*>(), &LogPanel::beepWanted);
    QSignalSpy settings(&window, &MainWindow::alarmSoundChanged);
    StationStatus one = samples::faulted();
    one.alarms.pop_back();
    show(one);
    show(one);
    EXPECT_EQ(beeps.count(), 1);
    show(samples::faulted());
    EXPECT_EQ(beeps.count(), 2);
    show(samples::idle());
    StationStatus remark = samples::disconnected();
    for (Alarm& alarm : remark.alarms) {
        alarm.severity = Severity::Advisory;
    }
    show(remark);
    EXPECT_EQ(beeps.count(), 2) << "a remark is silent";
    auto* const sound = named<QCheckBox>("Sound at a new alarm");
    EXPECT_TRUE(sound->isChecked()) << "silence is a setting, not a default";
    sound->setFocus();
    QTest::keyClick(sound, Qt::Key_Space);
    ASSERT_EQ(settings.count(), 1);
    EXPECT_FALSE(settings.front().front().toBool());
    show(samples::idle());
    show(samples::faulted());
    EXPECT_EQ(beeps.count(), 2);
}

TEST_F(AlarmsTest, ListsASilentStationOnce)
{
    show(samples::idle());
    elapse(Seconds(3.0));
    ASSERT_EQ(rows(), 1);
    elapse(Seconds(1.0));
    EXPECT_EQ(rows(), 1);
    EXPECT_TRUE(cell(0, AlarmModel::What).contains(QStringLiteral("4.0 s")));
    show(samples::idle());
    EXPECT_EQ(state(0), QStringLiteral("over yes"));
}

TEST_F(AlarmsTest, SaysOnItsButtonHowManyWait)
{
    show(samples::faulted());
    EXPECT_EQ(named<ChoiceButton>(kChoice)->text(), QStringLiteral("■ Alarms (2)"));
    show(acknowledged(samples::faulted()));
    EXPECT_EQ(named<ChoiceButton>(kChoice)->text(), QStringLiteral("▲ Alarms (1)"));
}

// REQ-UI-1703: The end of an alarm has the clock of the computer of the station, as its beginning, also while the
// station uses the old time.
TEST_F(AlarmsTest, TheEndHasTheClockOfTheComputer)
{
    StationStatus status = samples::faulted();
    status.utc = UtcTime(std::chrono::sys_days{std::chrono::year{2026} / 11 / 21}) + std::chrono::hours(17);
    status.clock.ahead = Seconds(90.0);
    show(status);
    show(over(status));
    clickRow(0);
    EXPECT_TRUE(reading().contains(QStringLiteral(" to 17:01:30, over"))) << reading().toStdString();
}

}  // namespace
}  // namespace boresight::ui
