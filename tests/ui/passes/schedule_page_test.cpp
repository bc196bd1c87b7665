// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/passes/schedule_page.h"

#include "tests/ui/window_fixture.h"
#include "ui/kit/command_button.h"
#include "ui/kit/format.h"
#include "ui/passes/schedule_table.h"

#include <QComboBox>
#include <QSpinBox>
#include <QTabWidget>
#include <QTableView>

namespace boresight::ui {
namespace {

using schedule::WatchedPass;

class SchedulePageTest : public WindowFixture
{
protected:
    SchedulePageTest()
    {
        openPanel('T');
        named<QTabWidget>("Passes of satellites")->setCurrentIndex(1);
    }

    static WatchedPass passOf(const char* name, int number, UtcTime aos, std::chrono::minutes length)
    {
        passes::Pass pass;
        pass.aos.utc = aos;
        pass.los.utc = aos + length;
        pass.clear = {{.from = aos, .to = aos + length}};
        pass.tca.direction.elevation = 38_deg;
        return {.number = number, .name = QString::fromLatin1(name), .pass = pass};
    }
    // One pass that is over, one to come, one left out, one that is hidden.
    static StationStatus withPlan()
    {
        using std::chrono::minutes;
        StationStatus status = samples::idle();
        status.permissions = Permissions::all();
        profile::Profile profile = *status.profile;
        profile.schedule.watch = {{.number = 25544, .priority = 1}, {.number = 33591, .priority = 2}};
        status.profile = std::make_shared<const profile::Profile>(profile);
        ScheduleStatus schedule;
        const WatchedPass next = passOf("ISS", 25544, status.utc + minutes(12), minutes(10));
        schedule.plan.chosen = {passOf("NOAA 19", 33591, status.utc - minutes(30), minutes(10)), next};
        schedule.plan.conflicts = {{.leftOut = passOf("NOAA 19", 33591, status.utc + minutes(15), minutes(10)),
                                    .chosen = next,
                                    .reason = schedule::Reason::Priority}};
        schedule.plan.hidden = {passOf("NOAA 15", 25338, status.utc + minutes(60), minutes(10))};
        schedule.report.passes = {{.number = 33591,
                                   .name = QStringLiteral("NOAA 19"),
                                   .aos = status.utc - minutes(30),
                                   .los = status.utc - minutes(20),
                                   .tracked = Seconds(600.0),
                                   .within1dB = Seconds(590.0),
                                   .within3dB = Seconds(600.0),
                                   .rmsError = 0.03_deg,
                                   .peakError = 0.2_deg,
                                   .end = schedule::PassEnd::Set,
                                   .why = {}}};
        status.schedule = std::make_shared<const ScheduleStatus>(schedule);
        return status;
    }
    void show(const StationStatus& status) { give(samples::update(status)); }
    QTableView& table() { return *named<QTableView>("Schedule of passes"); }
    std::string cell(int row, ScheduleTable::Column column, int role = Qt::DisplayRole)
    {
        return table().model()->index(row, column).data(role).toString().toStdString();
    }
};

// REQ-SCHEDULE-950: The page Schedule shows the night in the order of time: past passes with the quality of their
// tracking, coming passes, and passes left out with the reason. It says whether the schedule is armed.
TEST_F(SchedulePageTest, ShowsTheNightInTheOrderOfTime)
{
    show(withPlan());
    ASSERT_EQ(table().model()->rowCount(), 4);
    EXPECT_EQ(cell(0, ScheduleTable::What), "tracked, error 0.03° rms");
    EXPECT_EQ(cell(0, ScheduleTable::What, Qt::ToolTipRole),
              "tracked, error 0.03° rms\nMeasured: 600 s\nWithin 1 dB: 590 s\nWithin 3 dB: 600 s\nError: 0.03° rms\n"
              "Largest error: 0.20°");
    EXPECT_EQ(cell(1, ScheduleTable::Satellite), "ISS");
    EXPECT_EQ(cell(1, ScheduleTable::What), "in 12 min");
    EXPECT_EQ(cell(2, ScheduleTable::What), "left out, ISS is more important");
    EXPECT_EQ(cell(3, ScheduleTable::What), "left out, the limits hide it");
    const QString state = text("State of the schedule");
    EXPECT_TRUE(state.startsWith(QStringLiteral("Off. Nothing moves by itself. Next: ISS at"))) << state.toStdString();
    EXPECT_TRUE(state.endsWith(QStringLiteral("1 of 1 passes tracked to the end."))) << state.toStdString();
}

// REQ-SCHEDULE-955: A pass that is tracked in part has a row for the whole, with the reason, and one for the part.
TEST_F(SchedulePageTest, ShowsThePartOfAPassThatIsTracked)
{
    StationStatus status = withPlan();
    ScheduleStatus schedule = *status.schedule;
    WatchedPass rest = schedule.plan.conflicts.front().leftOut;
    rest.rest = passes::Stretch{.from = schedule.plan.chosen.back().ends(), .to = rest.ends()};
    rest.pass.clear = {*rest.rest};
    schedule.plan.chosen.push_back(rest);
    schedule.plan.conflicts.front().rests = {*rest.rest};
    status.schedule = std::make_shared<const ScheduleStatus>(schedule);
    show(status);
    ASSERT_EQ(table().model()->rowCount(), 5);
    EXPECT_EQ(cell(2, ScheduleTable::What), "tracked in part, ISS is more important");
    EXPECT_EQ(cell(3, ScheduleTable::What), "in 22 min, part of the pass");
    EXPECT_EQ(cell(3, ScheduleTable::Begins), clockText(rest.begins()).toStdString());
}

// Story: the reason why a pass is left out ended in "…" at 1280 × 800.
// REQ-SCHEDULE-950
TEST_F(SchedulePageTest, AReasonTakesAsManyLinesAsItNeeds)
{
    window.resize(1024, 700);
    show(withPlan());
    settle();
    const QAbstractItemModel& model = *table().model();
    const int width = table().columnWidth(ScheduleTable::What);
    bool anyWraps = false;
    for (int row = 0; row < model.rowCount(); ++row) {
        const QString what = model.index(row, ScheduleTable::What).data().toString();
        const QRect needed = table().fontMetrics().boundingRect(0, 0, width - 8, 1000, Qt::TextWordWrap, what);
        anyWraps |= needed.height() > table().fontMetrics().lineSpacing();
        EXPECT_GE(table().rowHeight(row), needed.height()) << what.toStdString();
        EXPECT_GE(table().rowHeight(row), kRowHeight);
    }
    EXPECT_TRUE(anyWraps);
}

// REQ-SCHEDULE-950
TEST_F(SchedulePageTest, SaysWhatToDoWhileNothingIsWatched)
{
    StationStatus status = samples::idle();
    show(status);
    EXPECT_EQ(text("State of the schedule"),
              QStringLiteral("Off. Nothing moves by itself. No satellite is watched. Add one on the page Coming."));
    profile::Profile profile = *status.profile;
    profile.schedule.watch = {{.number = 25544}};
    status.profile = std::make_shared<const profile::Profile>(profile);
    show(status);
    EXPECT_EQ(text("State of the schedule"), QStringLiteral("Off. Nothing moves by itself. No pass within a day."));
}

// REQ-SCHEDULE-954: Rehearse and Stop rehearsal are one button. The progress, the result, or the reason of a failure is
// above the table. In the table each pass has the part of its time within 3 dB from the rehearsal, with the seconds in
// the tooltip. Each warning has a row.
TEST_F(SchedulePageTest, RehearsesTheNight)
{
    StationStatus status = withPlan();
    show(status);
    auto* const rehearse = named<CommandButton>("Rehearse");
    QTest::mouseClick(rehearse, Qt::LeftButton);
    ASSERT_EQ(asked<request::Rehearse>().size(), 1U);
    EXPECT_TRUE(asked<request::Rehearse>().back().on);

    status.rehearsal.progress = 0.4;
    show(status);
    EXPECT_EQ(text("Rehearsal"), QStringLiteral("Rehearsing: 40 %"));
    QTest::mouseClick(rehearse, Qt::LeftButton);
    ASSERT_EQ(asked<request::Rehearse>().size(), 2U);
    EXPECT_FALSE(asked<request::Rehearse>().back().on);

    RehearsedNight night;
    night.plan = status.schedule->plan;
    night.report.passes = {{.number = 25544,
                            .aos = status.utc + std::chrono::minutes(12),
                            .tracked = Seconds(600.0),
                            .within3dB = Seconds(588.0),
                            .end = schedule::PassEnd::Set}};
    night.leastAzimuth = -40_deg;
    night.mostAzimuth = 310_deg;
    night.remarks = {{.utc = status.utc + std::chrono::minutes(14), .text = QStringLiteral("The Sun is near.")}};
    status.rehearsal = {.progress = {}, .problem = {}, .night = std::make_shared<const RehearsedNight>(night)};
    show(status);
    EXPECT_EQ(text("Rehearsal"),
              QStringLiteral("Rehearsal: 1 of 2 passes are tracked to the end. The azimuth axis is used from -40° to "
                             "310°. Warnings in the table: 1."));
    ASSERT_EQ(table().model()->rowCount(), 5);
    EXPECT_EQ(cell(1, ScheduleTable::What), "in 12 min, rehearsed: 98 %");
    EXPECT_EQ(cell(1, ScheduleTable::What, Qt::ToolTipRole), "Rehearsed: within 3 dB for 588 of 600 s");
    EXPECT_EQ(cell(2, ScheduleTable::What), "rehearsed: The Sun is near.");

    status.rehearsal = {.progress = {}, .problem = QStringLiteral("STOP is latched."), .night = {}};
    show(status);
    EXPECT_EQ(text("Rehearsal"), QStringLiteral("STOP is latched."));
}

// REQ-SCHEDULE-951: Arm and Disarm are one button. Arm is blocked with the reason of the station. Disarm is never
// blocked.
TEST_F(SchedulePageTest, ArmsAndDisarms)
{
    StationStatus status = withPlan();
    show(status);
    auto* const arm = named<CommandButton>("Arm schedule");
    QTest::mouseClick(arm, Qt::LeftButton);
    ASSERT_EQ(asked<ScheduleRequest>().size(), 1U);
    EXPECT_TRUE(std::holds_alternative<request::ArmSchedule>(asked<ScheduleRequest>().back()));

    ScheduleStatus armed = *status.schedule;
    armed.armed = true;
    status.schedule = std::make_shared<const ScheduleStatus>(armed);
    status.permissions.refuse(Action::ArmSchedule, QStringLiteral("STOP is latched."));
    show(status);
    EXPECT_TRUE(text("State of the schedule").startsWith(QStringLiteral("Armed. The mount moves by itself")));
    EXPECT_TRUE(arm->isEnabled());
    QTest::mouseClick(arm, Qt::LeftButton);
    ASSERT_EQ(asked<ScheduleRequest>().size(), 2U);
    EXPECT_TRUE(std::holds_alternative<request::DisarmSchedule>(asked<ScheduleRequest>().back()));

    armed.armed = false;
    armed.why = QStringLiteral("STOP of operator");
    status.schedule = std::make_shared<const ScheduleStatus>(armed);
    show(status);
    EXPECT_FALSE(arm->isEnabled());
    EXPECT_TRUE(text("State of the schedule").contains(QStringLiteral("STOP of operator.")));
}

// REQ-SCHEDULE-952: The priority and lowest elevation of a watched satellite are set in the profile, and the satellite
// can be removed.
TEST_F(SchedulePageTest, ChangesAndRemovesAWatchedSatellite)
{
    show(withPlan());
    named<QComboBox>("Watched satellite")->setCurrentIndex(1);
    auto* const priority = named<QSpinBox>("Priority of the satellite");
    EXPECT_EQ(priority->value(), 2);
    priority->setValue(5);
    show(withPlan());
    EXPECT_EQ(priority->value(), 5) << "typed, and not set yet";
    QTest::mouseClick(named<CommandButton>("Set"), Qt::LeftButton);
    ASSERT_EQ(asked<request::ApplyProfile>().size(), 1U);
    EXPECT_EQ(asked<request::ApplyProfile>().back().profile.schedule.watch[1].priority, 5);
}

TEST_F(SchedulePageTest, WithoutASatelliteItSaysWhereToAddOne)
{
    show(samples::idle());
    EXPECT_FALSE(named<CommandButton>("Set")->isEnabled());
    EXPECT_FALSE(named<QComboBox>("Watched satellite")->isEnabled());
}

}  // namespace
}  // namespace boresight::ui
