// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/ui/sample_calibration.h"
#include "tests/ui/step_button_of.h"
#include "tests/ui/window_fixture.h"
#include "ui/kit/language.h"
#include "ui/sky/polar_plot.h"
#include "ui/window/guide_room.h"

#include <string>

// The size of the sky's disc: nothing may change it.
namespace boresight::ui {
namespace {

struct Room
{
    QSize window;
    double leastDisc;  // px
};

constexpr Room kRooms[] = {{{1024, 700}, 440.0}, {{1280, 800}, 590.0}};

double discOf(const MainWindow& window)
{
    return 2.0 * window.findChild<PolarPlot*>()->frame().sky().radius;
}

StationStatus waitingForWrap()
{
    return samples::asking(Axis::Azimuth, 3, 180_deg, true);
}

struct State
{
    const char* name;
    StationStatus (*make)();
};

constexpr State kStates[] = {{"idle", samples::idle},
                             {"fault", samples::faulted},
                             {"stopped", samples::stopped},
                             {"clients", samples::fighting},
                             {"disconnected", samples::disconnected},
                             {"factory drives", samples::factoryDrives},
                             {"proof", samples::proving},
                             {"limits", samples::bounded},
                             {"question", waitingForWrap},
                             {"sensor", samples::heard},
                             {"proposal", samples::sixPoints}};

struct InThisLanguage : public ::testing::WithParamInterface<const char*>
{
    Translation translation{QLatin1String(GetParam())};  // before the window
};

class SkyRoomTest : public InThisLanguage, public WindowFixture
{
protected:
    // The contents of the column are not wider than the column, which scrolls only vertically.
    void expectRoomBeside(const std::string& where)
    {
        settle();
        const auto* const column = window.findChild<GuideRoom*>();
        EXPECT_LE(column->minimumSizeHint().width(), column->parentWidget()->width()) << where;
    }
};

// REQ-UI-1497: The disc of the sky is at least 590 px wide in a window of 1280×800 and 440 px in one of 1024×700. No
// panel, no step of the guide and no state changes it.
TEST_P(SkyRoomTest, TheDiscKeepsItsSizeWithEveryPanelAndAlarm)
{
    for (const auto& [size, least] : kRooms) {
        window.resize(size);
        settle();
        const double disc = discOf(window);
        EXPECT_GE(disc, least) << size.width();
        for (const State& state : kStates) {
            give(samples::update(state.make()));
            for (const char panel : kPanels) {
                openPanel(panel);
                const std::string where = std::string(state.name) + ", panel " + panel;
                expectRoomBeside(where);
                EXPECT_EQ(discOf(window), disc) << where << ", " << size.width();
            }
        }
        EXPECT_EQ(window.size(), size);
    }
}

TEST_P(SkyRoomTest, TheDiscKeepsItsSizeBesideTheGuide)
{
    settle();
    const double disc = discOf(window);
    QTest::keyClick(&window, Qt::Key_F3);
    for (const GuideStep step : kGuideSteps) {
        give(samples::update(samples::freshMount()));
        QTest::mouseClick(&stepButtonOf(window, step), Qt::LeftButton);
        expectRoomBeside(title(step).toStdString());
        EXPECT_EQ(discOf(window), disc) << title(step).toStdString();
    }
}

INSTANTIATE_TEST_SUITE_P(All, SkyRoomTest, ::testing::Values("en", "pt"));

// REQ-UI-1498: The disc has the same size in every language.
TEST(SkyInLanguages, TheDiscIsTheSame)
{
    for (const auto& [size, least] : kRooms) {
        std::vector<double> discs;
        for (const char* const language : {"en", "pt"}) {
            const Translation translation{QLatin1String(language)};
            const fakes::ManualClock clock;
            MainWindow window(clock, {});
            window.resize(size);
            window.QWidget::show();
            settle();
            discs.push_back(discOf(window));
        }
        EXPECT_EQ(discs.front(), discs.back()) << size.width();
    }
}

}  // namespace
}  // namespace boresight::ui
