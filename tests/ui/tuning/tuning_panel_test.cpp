// SPDX-License-Identifier: GPL-3.0-or-later
// The runs of the tuning panel, and the first tuning.
#include "ui/tuning/tuning_panel.h"

#include "tests/ui/tuning/tuning_fixture.h"
#include "ui/tuning/figures_model.h"
#include "ui/tuning/response_chart.h"

#include <gmock/gmock.h>

namespace boresight::ui {
namespace {

using ::testing::HasSubstr;

constexpr std::array kFirstRuns{TuningRun::Step, TuningRun::Ramp, TuningRun::Sweep};

std::vector<TuningResult> firstResults(bool asFound)
{
    std::vector<TuningResult> results;
    for (const TuningRun run : kFirstRuns) {
        results.push_back(sampleResult(run, asFound));
    }
    return results;
}

class TuningPanelTest : public TuningFixture
{
protected:
    TuningPanelTest() { open<TuningPanel>(); }
};

// REQ-UI-930: The first tuning of an axis leads from press to press: gains, step, ramp, sweep, and ends with a verdict.
// Each run needs a separate press, which asks first and says where it moves.
TEST_F(TuningPanelTest, TheFirstTuningLeadsFromPressToPress)
{
    gains() = {};
    show();
    EXPECT_THAT(first(), HasSubstr("First tuning, 1 of 5"));
    click("Read gains");
    ASSERT_EQ(asked<request::ReadGains>().size(), 1U);
    give(samples::acceptance(samples::idle(), requests.back().id));
    gains() = sampleGains();
    std::vector<TuningResult> results;
    for (const TuningRun run : kFirstRuns) {
        show(results);
        EXPECT_THAT(first(), HasSubstr("First tuning, " + std::to_string(results.size() + 2) + " of 5"));
        click("Next …");
        EXPECT_TRUE(questionText().contains(QStringLiteral("Moves the azimuth by 2.00°")));
        EXPECT_TRUE(started().empty()) << "nothing begins before the question is answered";
        click("Cancel");
        results.push_back(sampleResult(run, true));
    }
    show(results);
    EXPECT_THAT(first(), HasSubstr("First tuning, 5 of 5: the azimuth is well tuned"));
    results.back().good = false;
    show(results);
    EXPECT_THAT(first(), HasSubstr("change a gain as \"Swings\" advises"));
    EXPECT_TRUE(started().empty()) << "nothing begins by itself";
}

// REQ-UI-930
TEST_F(TuningPanelTest, ARunAsksFirstAndSaysWhereItMoves)
{
    show();
    press("Ramp");
    click("Measure …");
    EXPECT_TRUE(questionText().contains(QStringLiteral("Moves the azimuth by 2.00° from 30.0°")));
    EXPECT_TRUE(started().empty());
    QTest::mouseClick(act("Move the axis"), Qt::LeftButton);
    ASSERT_EQ(started().size(), 1U);
    EXPECT_EQ(started().back().axis, Axis::Azimuth);
    EXPECT_EQ(started().back().run, TuningRun::Ramp);
}

// Story: after Write the panel still said "well tuned", about gains that were not in effect any more.
// REQ-TUNING-23: A result of the first tuning counts only for the gains with which it was measured. With other gains in
// effect the run must be repeated.
TEST_F(TuningPanelTest, ResultsCountForTheGainsInForce)
{
    show(firstResults(true));
    ASSERT_THAT(first(), HasSubstr("well tuned"));
    gains() = sampleGains(kOtherDamping);
    show();
    EXPECT_THAT(first(), HasSubstr("First tuning, 2 of 5: measure the run \"Step\""));
    auto results = firstResults(true);
    results.push_back(sampleResult(TuningRun::Step, false));
    show(results);
    EXPECT_THAT(first(), HasSubstr("First tuning, 3 of 5"));
    gains() = sampleGains(kFoundDamping * (1.0 + 5e-6));  // restored, as the drive prints it
    show();
    EXPECT_THAT(first(), HasSubstr("well tuned"));
    gains().lines.back().value.reset();
    show();
    EXPECT_THAT(first(), HasSubstr("2 of 5")) << "not known to be the same";
}

// REQ-TUNING-24: The verdict shown for a run is the one that counts in the first tuning.
TEST_F(TuningPanelTest, OneVerdictIsShownAndCounts)
{
    auto results = firstResults(true);
    results.push_back(sampleResult(TuningRun::Step, false, 0.30));
    results.back().good = false;
    show(results);
    EXPECT_THAT(first(), HasSubstr("well tuned"));
    EXPECT_THAT(state(), HasSubstr("Overshoot 1 %"));
    gains() = sampleGains(kOtherDamping);
    show();
    EXPECT_THAT(state(), HasSubstr("Overshoot 30 %"));
    gains() = {};
    show();
    EXPECT_THAT(state(), HasSubstr("Overshoot 30 %")) << "the newest, while the gains are not read";
    press("Ramp");
    gains() = sampleGains(kOtherDamping);
    show();
    EXPECT_THAT(state(), HasSubstr("Moves the azimuth")) << "to be measured with these gains";
}

// Story: after one run was ended by STOP, every kind of run of both axes was shown as ended by STOP.
// REQ-TUNING-25: The reason why a run ended without a result is shown only at this run of this axis.
TEST_F(TuningPanelTest, AFailedRunIsShownAtItsOwnPlace)
{
    tuning.outcome = {.axis = Axis::Azimuth,
                      .run = TuningRun::Ramp,
                      .text = QStringLiteral("STOP ended the run. There is no result."),
                      .failed = true};
    tuning.plans[0][static_cast<std::size_t>(TuningRun::Backlash)].obstacle = QStringLiteral("There is no room.");
    show({sampleResult(TuningRun::Step, true)});
    EXPECT_THAT(state(), HasSubstr("Overshoot 1 %"));
    press("Ramp");
    EXPECT_THAT(state(), HasSubstr("STOP ended the run"));
    press("Backlash");
    EXPECT_EQ(state(), "There is no room.");
    press("Ramp");
    press("Elevation");
    EXPECT_THAT(state(), HasSubstr("Moves the"));
}

// Story: during a run a press on another kind of run did nothing.
// REQ-TUNING-26: A run is shown when it begins, and can be ended from its page. The figures of other runs can be viewed
// meanwhile.
TEST_F(TuningPanelTest, OtherFiguresCanBeSeenDuringARun)
{
    show({sampleResult(TuningRun::Step, true)});
    tuning.running = TuningRun::Ramp;
    tuning.done = 0.25;
    show();
    EXPECT_TRUE(choice("Ramp").isChecked());
    EXPECT_THAT(state(), HasSubstr("Ramp of the azimuth: 25 % done"));
    press("Step");
    tuning.done = 0.5;
    show();
    EXPECT_TRUE(choice("Step").isChecked());
    EXPECT_EQ(window.findChild<FiguresModel*>()->rowCount(), 7);
    EXPECT_THAT(state(), HasSubstr("Ramp of the azimuth: 50 % done"));
    click("End run");
    const auto all = asked<TuningRequest>();
    ASSERT_EQ(all.size(), 1U);
    EXPECT_TRUE(std::holds_alternative<request::EndTuning>(all.front())) << "without a question";
    tuning.running.reset();
    show();
    EXPECT_TRUE(choice("Step").isChecked());
    EXPECT_TRUE(named<CommandButton>("Measure …")->isEnabled());
}

// REQ-TUNING-27: The panel changes to the other axis if the drive of the shown axis is missing.
TEST_F(TuningPanelTest, AMissingAxisIsLeft)
{
    for (const bool azimuth : {false, true}) {
        status.drives->azimuth.present = status.drives->elevation.present = true;
        show();
        press(azimuth ? "Azimuth" : "Elevation");
        (azimuth ? status.drives->azimuth : status.drives->elevation).present = false;
        show();
        EXPECT_FALSE(choice(azimuth ? "Azimuth" : "Elevation").isEnabled());
        EXPECT_TRUE(choice(azimuth ? "Elevation" : "Azimuth").isChecked());
        click("Measure …");
        QTest::mouseClick(act("Move the axis"), Qt::LeftButton);
        ASSERT_FALSE(started().empty());
        EXPECT_EQ(started().back().axis, azimuth ? Axis::Elevation : Axis::Azimuth);
        give(samples::acceptance(status, requests.back().id));
    }
}

// REQ-UI-931: The figures and curves of a run before and after a change of the gains are side by side.
TEST_F(TuningPanelTest, BeforeAndAfterStandSideBySide)
{
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

}  // namespace
}  // namespace boresight::ui
