// SPDX-License-Identifier: GPL-3.0-or-later
//
// charts_load [--seconds N]
//
// Processor time of the charts. The whole window at 1280×800, with half an hour of 50 Hz data of both axes, is updated
// 20 times a second as by a station, for N seconds (10) in each case: with the charts hidden, and in their panel over
// 10 s and over 30 min. The difference to the first case is the cost of the charts, which must stay below 15 % of one
// core. Needs a display, or QT_QPA_PLATFORM=offscreen.
//
// REQ-UI-19 (tests/bench/charts_load.cpp): At 1280×800, drawing 30 min of 50 Hz data 20 times a second costs less than
// 15 % of a core.

#include "core/base/clock.h"
#include "core/base/numbers.h"
#include "tests/ui/sample_status.h"
#include "ui/charts/strip_charts.h"
#include "ui/window/main_window.h"

#include <QAbstractButton>
#include <QApplication>
#include <QElapsedTimer>
#include <QTest>
#include <QTimer>

#include <cstdio>
#include <ctime>
#include <string_view>

namespace {

using namespace boresight;

constexpr std::chrono::minutes kHistory{30};
constexpr double kLimit = 15.0;  // percent of one core

double processorSeconds()
{
    return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

// The window, with statuses as from a station.
class Desk
{
public:
    Desk() : m_window(m_clock, {}), m_sampled(m_clock.now() - kHistory)
    {
        m_window.resize(1280, 800);
        QObject::connect(&m_timer, &QTimer::timeout, &m_window, [this] { update(); });
        m_timer.start(50);
        m_window.show();
    }

    void press(const char* name)
    {
        for (QAbstractButton* const button : m_window.findChildren<QAbstractButton*>()) {
            if (button->accessibleName() == QLatin1String(name)) {
                button->click();
            }
        }
    }

    void openPanel(Qt::Key key) { QTest::keyClick(&m_window, key, Qt::ControlModifier); }

    // In percent of one core.
    static double measure(int seconds)
    {
        QTest::qWait(500);
        const double begin = processorSeconds();
        QElapsedTimer time;
        time.start();
        QTest::qWait(seconds * 1000);
        return 100.0 * (processorSeconds() - begin) / (static_cast<double>(time.elapsed()) * 1e-3);
    }

private:
    void update()
    {
        StationUpdate update = samples::update(samples::tracking(100.0));
        update.samples = samples::ticks(m_sampled, Seconds(m_clock.now() - m_sampled).count());
        if (!update.samples.empty()) {
            m_sampled = update.samples.back().time + std::chrono::milliseconds(20);
        }
        m_window.showUpdate(update);
    }

    SystemClock m_clock;
    ui::MainWindow m_window;
    SteadyTime m_sampled;
    QTimer m_timer;
};

}  // namespace

int main(int argc, char* argv[])
{
    QApplication app(argc, argv);
    QApplication::setStyle(QStringLiteral("Fusion"));
    int seconds = 10;
    if (argc == 3 && std::string_view(argv[1]) == "--seconds") {
        seconds = static_cast<int>(parseInteger(argv[2]).value_or(seconds));
    }
    Desk desk;
    desk.openPanel(Qt::Key_1);
    QTest::qWait(500);
    const double without = Desk::measure(seconds);
    std::printf("%-40s %5.1f %% of a core\n", "window without charts", without);
    double worst = 0.0;
    const auto report = [&](const char* what) {
        const double cost = Desk::measure(seconds) - without;
        worst = std::max(worst, cost);
        std::printf("%-40s %+5.1f %%\n", what, cost);
    };
    desk.openPanel(Qt::Key_2);
    desk.press("Show the last 10 s");
    report("charts in their panel, 10 s");
    desk.press("Show the last 30 min");
    report("charts in their panel, 30 min");
    std::printf("%s %.0f %%\n", worst < kLimit ? "below" : "ABOVE", kLimit);
    return worst < kLimit ? 0 : 1;
}
