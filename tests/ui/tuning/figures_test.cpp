// SPDX-License-Identifier: GPL-3.0-or-later
// The figures and the curves of a run, tested separately.
#include "tests/ui/tuning/tuning_fixture.h"
#include "ui/kit/theme.h"
#include "ui/tuning/figures_model.h"
#include "ui/tuning/response_chart.h"

#include <algorithm>

namespace boresight::ui {
namespace {

// Story: the first frequency of one run gave no result, and 0.3 Hz was compared with 0.6 Hz.
// REQ-TUNING-33: Figures before and after are paired by their names.
TEST(FiguresModelTest, PairsByName)
{
    TuningResult before = sampleResult(TuningRun::Sweep, true);
    TuningResult after = sampleResult(TuningRun::Sweep, false);
    before.sweep = {{.hertz = 0.3, .gain = 1.0}, {.hertz = 0.6, .gain = 0.9}};
    after.sweep = {{.hertz = 0.6, .gain = 0.8}, {.hertz = 1.2, .gain = 0.7}};
    FiguresModel model;
    model.show({.before = &before, .after = &after});
    const auto cell = [&](int row, FiguresModel::Column column) {
        return model.index(row, column).data().toString().left(6).toStdString();
    };
    ASSERT_EQ(model.rowCount(), 3);
    EXPECT_EQ(cell(0, FiguresModel::Before), "1.00×,");
    EXPECT_EQ(cell(0, FiguresModel::After), "---");
    EXPECT_EQ(cell(1, FiguresModel::Before), "0.90×,");
    EXPECT_EQ(cell(1, FiguresModel::After), "0.80×,");
    EXPECT_EQ(cell(2, FiguresModel::Before), "---");
    EXPECT_EQ(cell(2, FiguresModel::After), "0.70×,");
}

// REQ-TUNING-34: The selection in the table of figures stays when only values change.
TEST(FiguresModelTest, RowsStay)
{
    const TuningResult before = sampleResult(TuningRun::Step, true);
    const TuningResult after = sampleResult(TuningRun::Step, false);
    FiguresModel model;
    model.show({.before = &before});
    const QPersistentModelIndex selected = model.index(2, 0);
    model.show({.before = &before, .after = &after});
    EXPECT_TRUE(selected.isValid());
    EXPECT_NE(model.index(0, FiguresModel::After).data().toString(), QStringLiteral("---"));
}

// Story: a torque that was not reported was drawn as 0 Nm.
// REQ-TUNING-35: Where a drive reports no torque, the curve has a gap.
TEST(ResponseChartTest, HasAGapWhereNothingIsReported)
{
    TuningResult result = sampleResult(TuningRun::Step, false);
    for (std::size_t i = 0; i < result.samples.size(); ++i) {
        result.samples[i].torque = i < 70 || i >= 130 ? std::optional(3.0) : std::nullopt;
    }
    ResponseChart chart;
    chart.resize(400, 200);
    chart.choose(ResponseChart::Quantity::Torque);
    chart.show({.after = &result});
    EXPECT_DOUBLE_EQ(chart.highest(), 5.0);
    const QImage image = chart.grab().toImage();
    const QColor curve = currentTheme().accent;
    std::vector<bool> drawn(static_cast<std::size_t>(image.width()));
    for (int x = 0; x < image.width(); ++x) {
        for (int y = 40; y < image.height(); ++y) {  // below the legend
            const QColor one = image.pixelColor(x, y);
            const int off = std::abs(one.red() - curve.red()) + std::abs(one.green() - curve.green()) +
                            std::abs(one.blue() - curve.blue());
            drawn[static_cast<std::size_t>(x)] = drawn[static_cast<std::size_t>(x)] || off < 90;
        }
    }
    const auto first = std::ranges::find(drawn, true) - drawn.begin();
    const auto last = drawn.rend() - std::find(drawn.rbegin(), drawn.rend(), true) - 1;
    ASSERT_GT(last - first, 200) << "the curve is seen";
    const auto width = last - first;
    for (auto x = first + 2 * width / 5; x < first + 3 * width / 5; ++x) {
        EXPECT_FALSE(drawn[static_cast<std::size_t>(x)]) << "at " << x;
    }
}

}  // namespace
}  // namespace boresight::ui
