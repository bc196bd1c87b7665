// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/ui/picture_book.h"
#include "ui/charts/strip_chart.h"
#include "ui/charts/strip_charts.h"

#include <QAbstractButton>

// The charts over a long and a short time, with a gap.
namespace boresight::ui {
namespace {

using namespace std::chrono_literals;

class ChartsPictures : public PictureBook
{
protected:
    ChartsPictures() { openPanel('2'); }

    void pass(Seconds length)
    {
        StationUpdate update = samples::update(samples::idle());
        update.samples = samples::ticks(clock.now(), length.count());
        clock.advance(length);
        give(update);
    }

    void press(const char* button) { QTest::mouseClick(named<QAbstractButton>(button), Qt::LeftButton); }

    void readTheErrorAt(int column)
    {
        settle();
        StripChart& error = window.findChild<StripCharts*>()->strip(Strip::Error);
        QTest::mouseMove(&error, QPoint(error.canvas().left() + column, 60));
    }
};

// REQ-UI-15 (ChartsPictures.*)
TEST_P(ChartsPictures, AreTakenOfEverySpan)
{
    pass(1400s);
    clock.advance(20s);
    pass(420s);
    for (const auto& [scene, button] :
         {std::pair("charts-10s", "Show the last 10 s"), std::pair("charts-1min", "Show the last 1 min"),
          std::pair("charts-30min", "Show the last 30 min")}) {
        openPanel('2');  // a wide window had the charts beside the panels
        ASSERT_TRUE(window.findChild<StripCharts*>()->isVisible());
        press(button);
        readTheErrorAt(150);
        take(QLatin1String(scene));
    }
}

INSTANTIATE_TEST_SUITE_P(All, ChartsPictures, kThemes, editionName);

}  // namespace
}  // namespace boresight::ui
