// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/ui/window_fixture.h"
#include "ui/charts/strip_chart.h"
#include "ui/charts/strip_charts.h"
#include "ui/charts/time_axis.h"
#include "ui/kit/choice_button.h"
#include "ui/sky/polar_plot.h"
#include "ui/window/panel_tabs.h"

#include <QComboBox>
#include <QPushButton>

#include <cmath>

// The charts in the window, by mouse and keys.
namespace boresight::ui {
namespace {

using namespace std::chrono_literals;

class ChartsTest : public WindowFixture
{
protected:
    ChartsTest()
    {
        openPanel('2');
        settle();
    }

    StripCharts& charts() { return *window.findChild<StripCharts*>(); }
    StripChart& strip(Strip which) { return charts().strip(which); }
    TimeAxis& time() { return *window.findChild<TimeAxis*>(); }

    // Adds the ticks of this time, and advances the clock by it.
    void pass(Seconds length)
    {
        StationUpdate update = samples::update(samples::idle());
        update.samples = samples::ticks(clock.now(), length.count());
        clock.advance(length);
        give(update);
    }

    // Adds ticks with these values, one at a time.
    void tick(double commanded, double actual, int count = 1)
    {
        StationUpdate update = samples::update(samples::idle());
        for (int i = 0; i < count; ++i) {
            TickSample sample{.time = clock.now()};
            sample.axes[0] = {.commanded = Angle::fromDegrees(commanded), .actual = Angle::fromDegrees(actual)};
            update.samples.push_back(sample);
            clock.advance(Seconds(0.02));
        }
        give(update);
    }

    void press(const char* button) { QTest::mouseClick(named<QAbstractButton>(button), Qt::LeftButton); }

    void pointAt(Strip which, int column)
    {
        QTest::mouseMove(&strip(which), QPoint(strip(which).canvas().left() + column, 60));
        settle();
    }

    const Trace& trace(Strip which, std::size_t number) { return strip(which).frame().traces.at(number); }

    static float greatest(const Trace& trace)
    {
        float found = -1e9F;
        for (const PeakColumn& column : trace.columns) {
            found = std::max(found, column.range.max);
        }
        return found;
    }

    static int runs(const Trace& trace)
    {
        return static_cast<int>(std::ranges::count(trace.columns, false, &PeakColumn::joined));
    }
};

TEST_F(ChartsTest, TheWindowButtonsChooseTheTime)
{
    pass(400s);
    const std::pair<const char*, std::int64_t> windows[] = {
        {"Show the last 10 s", 500}, {"Show the last 1 min", 3000}, {"Show the last 5 min", 15'000}};
    for (const auto& [button, bins] : windows) {
        press(button);
        const std::vector<PeakColumn>& columns = trace(Strip::Position, 1).columns;
        const int width = strip(Strip::Position).columns();
        EXPECT_GE(columns.back().column - columns.front().column, width - 3) << button;
        EXPECT_EQ(columns.back().column, (PeakGrid{bins, width}.columnOf(TelemetryStore::binOf(clock.now() - 20ms))))
            << button;
    }
    press("Show the last 30 min");
    const std::vector<PeakColumn>& columns = trace(Strip::Position, 1).columns;
    EXPECT_NEAR(static_cast<double>(columns.back().column - columns.front().column),
                strip(Strip::Position).columns() * 400.0 / 1800.0, 2.0);
}

// REQ-UI-17
TEST_F(ChartsTest, OneTicksPeakIsPaintedInEveryWindow)
{
    tick(20.0, 20.0, 4000);
    tick(20.0, 19.2);
    tick(20.0, 20.0, 300);
    for (const char* const button : {"Show the last 10 s", "Show the last 1 min", "Show the last 30 min"}) {
        press(button);
        StripChart& error = strip(Strip::Error);
        EXPECT_NEAR(greatest(trace(Strip::Error, 0)), 0.8F, 1e-4F) << button;
        EXPECT_GE(error.scale().upper(), 0.8);
        int peakColumn = 0;
        for (const PeakColumn& column : trace(Strip::Error, 0).columns) {
            if (column.range.max > 0.7F) {
                peakColumn = static_cast<int>(column.column - error.frame().firstColumn);
            }
        }
        const QImage picture = error.grab().toImage();
        const QColor ground = currentTheme().plotGround;
        const QPoint half = error.pixel(peakColumn, 0.4).toPoint();
        bool painted = false;
        for (int x = half.x() - 1; x <= std::min(half.x() + 1, picture.width() - 1); ++x) {
            const QColor found = picture.pixelColor(x, half.y());
            painted = painted || std::abs(found.lightness() - ground.lightness()) > 60;
        }
        EXPECT_TRUE(painted) << button;
    }
}

// REQ-UI-18: Paused charts stand still and keep collecting. Cursor and keys read time and values. In a wide window the
// charts are beside sky and panels and cover nothing.
TEST_F(ChartsTest, PauseHoldsThePictureAndCollectsOn)
{
    tick(10.0, 10.0, 500);
    press("Freeze the charts. Boresight still records the data (Space in the charts)");
    tick(10.0, 10.0, 10);  // at the moment of pausing: a column is less than 0.2 s
    const std::int64_t first = strip(Strip::Position).frame().firstColumn;
    const QImage before = strip(Strip::Position).grab().toImage();
    tick(10.0, 12.0, 500);
    EXPECT_EQ(strip(Strip::Position).frame().firstColumn, first);
    EXPECT_EQ(strip(Strip::Position).grab().toImage(), before);
    EXPECT_EQ(text("Remark on the charts"), QStringLiteral("PAUSED"));
    press("Freeze the charts. Boresight still records the data (Space in the charts)");
    EXPECT_GT(strip(Strip::Position).frame().firstColumn, first);
    EXPECT_FLOAT_EQ(greatest(trace(Strip::Position, 1)), 12.0F);
    EXPECT_EQ(text("Remark on the charts"), QString());
}

// REQ-UI-17
TEST_F(ChartsTest, SilenceIsAGapAndNeverALine)
{
    tick(10.0, 10.0, 500);
    clock.advance(5s);
    tick(80.0, 80.0, 500);
    EXPECT_EQ(runs(trace(Strip::Position, 1)), 2);
    StripChart& position = strip(Strip::Position);
    const int gap = position.columns() - static_cast<int>(12.5 / 60.0 * position.columns());
    const QImage picture = position.grab().toImage();
    for (double value = 12.0; value < 78.0; value += 1.0) {
        const QColor found = picture.pixelColor(position.pixel(gap, value).toPoint());
        EXPECT_TRUE(found == currentTheme().plotGround || found == currentTheme().grid) << value;
    }
}

// With a silent station the curve moves away from "now", and nothing is added.
TEST_F(ChartsTest, OldDataMoveAwayFromNow)
{
    tick(10.0, 10.0, 500);
    elapse(6s);
    const StripFrame& frame = strip(Strip::Position).frame();
    const auto behind = frame.firstColumn + frame.columns - 1 - frame.traces.at(1).columns.back().column;
    EXPECT_GE(behind, strip(Strip::Position).columns() / 10 - 1);
    EXPECT_TRUE(strip(Strip::Position).caption().endsWith(QStringLiteral("actual –")));
}

// REQ-UI-18
TEST_F(ChartsTest, TheCursorReadsTimeAndValuesOfAllStrips)
{
    tick(10.0, 9.5, 1500);
    tick(30.0, 29.0, 1500);
    EXPECT_EQ(strip(Strip::Position).caption(), QStringLiteral("Position°  commanded 30.00  actual 29.00"));
    const int width = strip(Strip::Position).columns();
    pointAt(Strip::Error, width / 4);
    EXPECT_EQ(strip(Strip::Position).caption(), QStringLiteral("Position°  commanded 10.00  actual 9.50"));
    EXPECT_EQ(strip(Strip::Error).caption(), QStringLiteral("Error°  commanded − actual 0.500"));
    ASSERT_TRUE(strip(Strip::Drive).frame().cursor.has_value());
    EXPECT_TRUE(time().cursorText().startsWith(QStringLiteral("−4"))) << time().cursorText().toStdString();
    EXPECT_TRUE(time().cursorText().endsWith(QStringLiteral("00:00:15Z"))) << time().cursorText().toStdString();
    pointAt(Strip::Error, -30);
    EXPECT_FALSE(strip(Strip::Drive).frame().cursor.has_value());
    EXPECT_EQ(time().cursorText(), QString());
}

TEST_F(ChartsTest, TheCursorShowsThePeaksThatItsColumnHolds)
{
    pass(1000s);
    press("Show the last 30 min");
    pointAt(Strip::Error, strip(Strip::Error).columns() - 40);
    EXPECT_TRUE(strip(Strip::Error).caption().contains(QStringLiteral("…")));
}

// REQ-UI-18
TEST_F(ChartsTest, KeysAloneMoveTheCursorAndPause)
{
    pass(60s);
    charts().setFocus(Qt::TabFocusReason);
    QTest::keyClick(&charts(), Qt::Key_Left);
    const int last = strip(Strip::Error).columns() - 1;
    EXPECT_EQ(strip(Strip::Error).frame().cursor, last - 1);
    QTest::keyClick(&charts(), Qt::Key_Left, Qt::ShiftModifier);
    EXPECT_EQ(strip(Strip::Error).frame().cursor, last - 11);
    QTest::keyClick(&charts(), Qt::Key_Home);
    EXPECT_EQ(strip(Strip::Error).frame().cursor, 0);
    QTest::keyClick(&charts(), Qt::Key_Space);
    EXPECT_EQ(text("Remark on the charts"), QStringLiteral("PAUSED"));
    EXPECT_TRUE(requests.empty());
}

TEST_F(ChartsTest, AxisAndQuantityAreChosen)
{
    pass(60s);
    EXPECT_GT(greatest(trace(Strip::Position, 1)), 280.0F);
    press("Charts of the elevation");
    EXPECT_LT(greatest(trace(Strip::Position, 1)), 91.0F);
    auto* const box = named<QComboBox>("Quantity of the drive");
    const std::pair<Qt::Key, const char*> steps[] = {
        {Qt::Key_Down, "q current A"}, {Qt::Key_Down, "Voltage V"}, {Qt::Key_Down, "Temperature °C"}};
    for (const auto& [key, caption] : steps) {
        QTest::keyClick(box, key);
        EXPECT_TRUE(strip(Strip::Drive).caption().startsWith(QString::fromUtf8(caption)))
            << strip(Strip::Drive).caption().toStdString();
    }
    EXPECT_TRUE(strip(Strip::Drive).caption().contains(QStringLiteral("motor –")));
    EXPECT_NEAR(greatest(trace(Strip::Drive, 1)), 38.0F, 5.0F);
}

TEST_F(ChartsTest, ALevelThatMattersIsDrawnWhereItFits)
{
    StationStatus status = samples::idle();
    auto profile = std::make_shared<profile::Profile>();
    profile->mount.beamWidth = 5_deg;
    status.profile = profile;
    tick(10.0, 9.97, 100);
    StripChart& error = strip(Strip::Error);
    give(samples::update(status));
    const auto drawn = [&](double level) {
        const QPoint at = error.pixel(0, level).toPoint();
        const QImage picture = error.grab().toImage();
        for (int y = at.y() - 1; y <= at.y() + 1; ++y) {
            if (picture.rect().contains(at.x(), y) && picture.pixelColor(at.x(), y) == currentTheme().warning) {
                return true;
            }
        }
        return false;
    };
    EXPECT_TRUE(drawn(0.05));  // a hundredth of the beam width
    EXPECT_LT(error.scale().upper(), 0.5);
    tick(10.0, 9.3);
    give(samples::update(status));
    EXPECT_TRUE(drawn(0.5));  // a tenth
}

TEST_F(ChartsTest, AnUnknownTurnIsSaid)
{
    give(samples::update(samples::asking(Axis::Azimuth, 3, 180_deg, true)));
    openPanel('2');
    EXPECT_TRUE(text("Remark on the charts").startsWith(QStringLiteral("Wrap unknown")));
    EXPECT_EQ(named<ValueLabel>("Remark on the charts")->symbol(), Symbol::Warning);
    press("Charts of the elevation");
    EXPECT_EQ(text("Remark on the charts"), QString());
}

// REQ-UI-18
TEST_F(ChartsTest, AWideWindowHasThemBesideThePanelsAndTheSkyStays)
{
    pass(60s);
    auto* const sky = window.findChild<PolarPlot*>();
    window.resize(1920, 1080);
    settle();
    EXPECT_TRUE(sky->isVisible());
    EXPECT_TRUE(charts().isVisible());
    const auto place = [this](const QWidget& widget) {
        return QRect(widget.mapTo(&window, QPoint(0, 0)), widget.size());
    };
    EXPECT_FALSE(place(charts()).intersects(place(*sky)));
    EXPECT_FALSE(place(charts()).intersects(place(*window.findChild<PanelTabs*>())));
    window.resize(1280, 800);
    settle();
    EXPECT_FALSE(charts().isVisible());
    openPanel('2');
    EXPECT_TRUE(charts().isVisible());
    EXPECT_TRUE(sky->isVisible());
}

TEST_F(ChartsTest, AreDescribedInWords)
{
    tick(10.0, 9.5, 500);
    clock.advance(1s);
    tick(12.0, 11.5, 500);
    EXPECT_EQ(charts().accessibleDescription(),
              QStringLiteral("azimuth, last 1 min. Position: commanded 12.00°, range 10.00…12.00°; actual "
                             "11.50°, range 9.50…11.50°. Error: commanded − actual 0.500°, range 0.500°. "
                             "Torque: no data."));
}

// REQ-UI-1651: A mount without drives that report values has no chart of torque, current, voltage or temperature.
TEST_F(ChartsTest, AMountWithoutDrivesHasNoChartOfThem)
{
    EXPECT_TRUE(strip(Strip::Drive).isVisible());
    StationStatus status = samples::idle();
    status.drives.reset();
    clock.advance(1s);
    give(samples::update(status));
    EXPECT_FALSE(strip(Strip::Drive).isVisible());
    EXPECT_FALSE(named<QComboBox>("Quantity of the drive")->isVisible());
    EXPECT_TRUE(strip(Strip::Error).isVisible());
    EXPECT_FALSE(charts().accessibleDescription().contains(QStringLiteral("Torque")));
    give(samples::update(samples::idle()));
    EXPECT_TRUE(strip(Strip::Drive).isVisible());
}

}  // namespace
}  // namespace boresight::ui
