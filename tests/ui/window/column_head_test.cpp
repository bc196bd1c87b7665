// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/alarms/catalogue.h"
#include "tests/ui/sample_alarms.h"
#include "tests/ui/window_fixture.h"
#include "ui/window/axis_card.h"
#include "ui/window/panel_tabs.h"
#include "ui/window/sensor_readout.h"

namespace boresight::ui {
namespace {

class ColumnHeadTest : public WindowFixture
{
protected:
    // With a sensor, as the simulated mount has it.
    StationUpdate shown(StationStatus status)
    {
        status.sensor = {.source = QStringLiteral("serial /dev/ttyUSB0"), .open = true};
        return samples::update(status);
    }
    // Where the tabs begin while this is shown.
    int tabs(const StationStatus& status)
    {
        for (int i = 0; i < 3; ++i) {  // the card is as high as its text once it has its width
            give(shown(status));
            QCoreApplication::sendPostedEvents();
            QCoreApplication::processEvents();
        }
        auto* const panels = window.findChild<PanelTabs*>();
        return panels->mapTo(&window, QPoint()).y();
    }
};

constexpr int kLine = 18;  // px

// Story: an alarm came while the hand was on the pad, and the button under the pointer was another one.
// REQ-UI-975: At 1280×800 and above no alarm of the catalogue moves the tabs, the panel or its buttons, for the
// readouts of the axes make room. The longest of them move them by less than a line.
TEST_F(ColumnHeadTest, NoAlarmMovesTheTabs)
{
    for (const QSize size : {QSize(1280, 800), QSize(1920, 1080)}) {
        window.resize(size);
        const int before = tabs(samples::idle());
        QStringList longOnes;
        for (const AlarmEntry* const entry : alarmCatalogue()) {
            const int moved = tabs(samples::alarmed(*entry)) - before;
            if (moved != 0) {
                longOnes << QStringLiteral("%1 by %2").arg(QLatin1String(entry->id)).arg(moved);
            }
            EXPECT_GE(moved, 0) << entry->id << " " << size.width();
            EXPECT_LT(moved, kLine) << entry->id << " " << size.width();
            EXPECT_TRUE(window.findChild<AxisCard*>()->isVisible());
        }
        EXPECT_EQ(tabs(samples::idle()), before);
        EXPECT_LE(longOnes.size(), 3) << size.width() << " " << qPrintable(longOnes.join(u", "));
    }
}

}  // namespace
}  // namespace boresight::ui
