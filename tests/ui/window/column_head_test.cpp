// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/alarms/catalogue.h"
#include "tests/ui/sample_alarms.h"
#include "tests/ui/window_fixture.h"
#include "ui/kit/language.h"
#include "ui/window/axis_card.h"
#include "ui/window/panel_tabs.h"
#include "ui/window/sensor_readout.h"

namespace boresight::ui {
namespace {

class ColumnHeadTest : public WindowFixture
{
protected:
    // Where the tabs begin while this is shown.
    int tabs(const StationStatus& status)
    {
        for (int i = 0; i < 3; ++i) {  // the card is as high as its text once it has its width
            give(samples::update(status));
            QCoreApplication::sendPostedEvents();
            QCoreApplication::processEvents();
        }
        auto* const panels = window.findChild<PanelTabs*>();
        return panels->mapTo(&window, QPoint()).y();
    }
    // Each alarm of the catalogue comes and goes. Expects that it moves the tabs by less than a line; returns which
    // move them at all.
    QStringList movers(const SensorStatus& sensor)
    {
        const auto with = [&sensor](StationStatus status) {
            status.sensor = sensor;
            return status;
        };
        const int before = tabs(with(samples::idle()));
        QStringList found;
        for (const AlarmEntry* const entry : alarmCatalogue()) {
            const int moved = tabs(with(samples::alarmed(*entry))) - before;
            if (moved != 0) {
                found << QStringLiteral("%1 by %2").arg(QLatin1String(entry->id)).arg(moved);
            }
            EXPECT_GE(moved, 0) << entry->id;
            EXPECT_LT(moved, kLine) << entry->id;
            EXPECT_TRUE(window.findChild<AxisCard*>()->isVisible());
        }
        EXPECT_EQ(tabs(with(samples::idle())), before);
        return found;
    }

    static constexpr int kLine = 18;  // px
    const SensorStatus withSensor{.source = QStringLiteral("serial /dev/ttyUSB0"), .open = true};
};

struct Portuguese
{
    Translation translation{QStringLiteral("pt")};
};

// The texts are longer, and the window is made in the language.
class PortugueseColumnHeadTest : private Portuguese, public ColumnHeadTest
{};

// Story: an alarm came while the hand was on the pad, and the button under the pointer was another one.
// REQ-UI-975: At 1280×800 and above no alarm of the catalogue moves the tabs, the panel or its buttons, for the
// readouts of the axes make room. The longest of them move them by less than a line.
TEST_F(ColumnHeadTest, NoAlarmMovesTheTabs)
{
    for (const QSize size : {QSize(1280, 800), QSize(1920, 1080)}) {
        window.resize(size);
        const QStringList found = movers(withSensor);
        EXPECT_LE(found.size(), 3) << size.width() << " " << qPrintable(found.join(u", "));
    }
}

// Story: at 1024×700 each alarm of the catalogue moved the tabs by 14 to 65 px.
// REQ-UI-1461: At 1024×700 no alarm of the catalogue moves the tabs of a mount with a sensor. The card has smaller
// letters and margins there, and the last line of the log stands below the sky, whose disc keeps its size.
TEST_F(ColumnHeadTest, NoAlarmMovesTheTabsOfASmallWindow)
{
    window.resize(1024, 700);
    EXPECT_EQ(movers(withSensor).join(u", ").toStdString(), "");
}

TEST_F(PortugueseColumnHeadTest, NoAlarmMovesTheTabsOfASmallWindow)
{
    window.resize(1024, 700);
    EXPECT_EQ(movers(withSensor).join(u", ").toStdString(), "");
}

// REQ-UI-1462: The last line of the log follows the size of the window: below the sky of a low one, else at the end of
// the right column.
TEST_F(ColumnHeadTest, TheLastLineOfTheLogStandsWhereThereIsRoom)
{
    const auto left = [this](QSize size) {
        window.resize(size);
        QCoreApplication::processEvents();
        return named<ValueLabel>("Last line of the log")->mapTo(&window, QPoint()).x();
    };
    EXPECT_LT(left({1024, 700}), 20);
    EXPECT_GT(left({1280, 800}), 600);
    EXPECT_LT(left({1024, 700}), 20);
}

}  // namespace
}  // namespace boresight::ui
