// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tuning/tuning_panel.h"

#include "tests/ui/drives/drives_fixture.h"
#include "ui/tuning/figures_model.h"
#include "ui/tuning/gains_model.h"
#include "ui/tuning/response_chart.h"

#include <QDoubleSpinBox>
#include <QToolButton>

#include <cmath>

namespace boresight::ui {
namespace {

DriveGains sampleGains(double damping)
{
    DriveGains gains{.read = true, .onTrial = damping != 10053.1, .text = QStringLiteral("the gains were read")};
    const double values[] = {201062.0, 1608500.0, damping, 60.0, 18.0, 400.0};
    for (const double value : values) {
        gains.lines.push_back({.key = QStringLiteral("servo.sample"),
                               .unit = QStringLiteral("Nm"),
                               .value = value,
                               .first = value,
                               .stored = value,
                               .least = value / 4.0,
                               .most = value * 4.0,
                               .bounds = QStringLiteral("A quarter to four times the stored value.")});
    }
    gains.lines[2].first = gains.lines[2].stored = 10053.1;
    gains.lines[5].needsOff = true;
    return gains;
}

TuningResult sampleResult(TuningRun run, bool asFound, double error)
{
    TuningResult result{.run = run,
                        .when = UtcTime(std::chrono::seconds(asFound ? 1000 : 2000)),
                        .asFound = asFound,
                        .good = true,
                        .verdict = {QStringLiteral("Overshoot 0.3 %: small.")}};
    for (int i = 0; i < 200; ++i) {
        result.samples.push_back({.time = Seconds(0.02 * i),
                                  .actual = Angle::fromDegrees(error * std::sin(0.1 * i)),
                                  .torque = 5.0 * std::cos(0.1 * i)});
    }
    if (run == TuningRun::Step) {
        result.step = response::StepFigures{.size = 2_deg,
                                            .overshoot = error,
                                            .settling = Seconds(0.1),
                                            .error = {.rms = 0.005_deg, .peak = Angle::fromDegrees(error)},
                                            .torque = response::TorqueFigures{.rms = 3.0, .peak = 12.0}};
    } else if (run == TuningRun::Ramp) {
        result.ramp = response::RampFigures{.rate = 0.5_deg_s};
    } else {
        result.sweep = {{.hertz = 0.3, .amplitude = 0.25_deg, .gain = 1.0, .phase = -2_deg}};
    }
    return result;
}

class TuningPanelTest : public DrivesTest
{
protected:
    void show(const std::vector<TuningResult>& results = {}, bool read = true, double damping = 10053.1)
    {
        StationStatus status = samples::idle();
        TuningStatus tuning{.results = results};
        for (auto& plans : tuning.plans) {
            plans.fill({.text = QStringLiteral("Moves the azimuth by 2.00° from 30.0° and back, in 8 s.")});
        }
        status.tuning = std::make_shared<const TuningStatus>(tuning);
        status.drives->azimuth.gains = read ? sampleGains(damping) : DriveGains{};
        give(samples::update(status));
    }

    [[nodiscard]] std::vector<request::StartTuning> started() const
    {
        std::vector<request::StartTuning> found;
        for (const auto& one : asked<TuningRequest>()) {
            if (const auto* const start = std::get_if<request::StartTuning>(&one)) {
                found.push_back(*start);
            }
        }
        return found;
    }

    void press(const char* choice)
    {
        for (QToolButton* const button : window.findChildren<QToolButton*>()) {
            if (button->isVisible() && button->text() == QString::fromUtf8(choice)) {
                QTest::mouseClick(button, Qt::LeftButton);
                return;
            }
        }
        ADD_FAILURE() << "no button " << choice;
    }
};

// REQ-UI-930: The first tuning of an axis leads from press to press: gains, step, ramp, swings, and ends with a
// verdict. Each run is a press of its own, which asks first and says where it moves.
TEST_F(TuningPanelTest, TheFirstTuningLeadsFromPressToPress)
{
    open<TuningPanel>();
    show({}, false);
    EXPECT_TRUE(says(window, "First tuning, 1 of 5"));
    click("Read gains");
    ASSERT_EQ(asked<request::ReadGains>().size(), 1U);
    give(samples::acceptance(samples::idle(), requests.back().id));
    std::vector<TuningResult> results;
    int step = 2;
    for (const TuningRun run : {TuningRun::Step, TuningRun::Ramp, TuningRun::Sweep}) {
        show(results);
        EXPECT_TRUE(says(window, qPrintable(QStringLiteral("First tuning, %1 of 5").arg(step))));
        results.push_back(sampleResult(run, true, 0.01));
        ++step;
    }
    show(results);
    EXPECT_TRUE(says(window, "First tuning, 5 of 5: the azimuth is well tuned"));
    results.back().good = false;
    show(results);
    EXPECT_TRUE(says(window, "change a gain as \"Swings\" advises"));
    EXPECT_TRUE(started().empty()) << "nothing begins by itself";
}

// REQ-UI-930
TEST_F(TuningPanelTest, ARunAsksFirstAndSaysWhereItMoves)
{
    open<TuningPanel>();
    show();
    press("Ramp");
    QTest::mouseClick(findNamed<QPushButton>(window, "Measure …"), Qt::LeftButton);
    EXPECT_TRUE(questionText().contains(QStringLiteral("Moves the azimuth by 2.00° from 30.0°")));
    EXPECT_TRUE(started().empty());
    QTest::mouseClick(act("Move the axis"), Qt::LeftButton);
    ASSERT_EQ(started().size(), 1U);
    EXPECT_EQ(started().back().axis, Axis::Azimuth);
}

// REQ-UI-931: The figures and curves of a run before and after a change of the gains stand side by side.
TEST_F(TuningPanelTest, BeforeAndAfterStandSideBySide)
{
    open<TuningPanel>();
    show({sampleResult(TuningRun::Step, true, 0.01), sampleResult(TuningRun::Step, false, 0.03)});
    const auto& model = *window.findChild<FiguresModel*>();
    const auto cell = [&](int row, FiguresModel::Column column) {
        return model.index(row, column).data().toString().toStdString();
    };
    ASSERT_EQ(model.rowCount(), 7);
    EXPECT_EQ(cell(0, FiguresModel::Name), "Overshoot");
    EXPECT_EQ(cell(0, FiguresModel::Before), "1.0 %");
    EXPECT_EQ(cell(0, FiguresModel::After), "3.0 %");
    auto& chart = *window.findChild<ResponseChart*>();
    EXPECT_DOUBLE_EQ(chart.highest(), 0.05);
    press("Torque");
    EXPECT_DOUBLE_EQ(chart.highest(), 5.0);
    EXPECT_TRUE(chart.accessibleDescription().contains(QStringLiteral("Torque")));
}

// REQ-UI-932: A gain is changed from the table within its bounds; what is on trial says so; storing asks first and
// lists what changes.
TEST_F(TuningPanelTest, AGainIsChangedAndStored)
{
    open<TuningPanel>();
    show();
    press("Gains");
    auto& table = *named<QTableView>("Gains");
    table.setCurrentIndex(window.findChild<GainsModel*>()->index(2, 0));
    auto* const value = named<QDoubleSpinBox>("New value of the selected gain");
    EXPECT_DOUBLE_EQ(value->value(), 10053.1);
    value->setValue(99999.0);
    EXPECT_NEAR(value->value(), 40212.4, 0.001) << "no more than the bounds";
    value->setValue(12000.0);
    click("Write");
    ASSERT_EQ(asked<request::SetGain>().size(), 1U);
    EXPECT_EQ(asked<request::SetGain>().back().gain, Gain::Damping);
    EXPECT_DOUBLE_EQ(asked<request::SetGain>().back().value, 12000.0);

    show({}, true, 12000.0);
    EXPECT_TRUE(says(window, "On trial, not stored"));
    click("Store …");
    EXPECT_TRUE(questionText().contains(QStringLiteral("servo.sample: 10053.1 → 12000")));
    EXPECT_TRUE(asked<request::StoreGains>().empty());
    QTest::mouseClick(act("Store"), Qt::LeftButton);
    EXPECT_EQ(asked<request::StoreGains>().size(), 1U);
}

}  // namespace
}  // namespace boresight::ui
