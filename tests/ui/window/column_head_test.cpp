// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/column_head.h"

#include "core/alarms/catalogue.h"
#include "tests/ui/sample_alarms.h"
#include "tests/ui/window_fixture.h"
#include "ui/window/alarm_card.h"
#include "ui/window/axis_card.h"
#include "ui/window/panel_tabs.h"
#include "ui/window/sensor_readout.h"

#include <algorithm>

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
    // px of the alarm card that one has to scroll to.
    int hidden()
    {
        const auto* const card = window.findChild<AlarmCard*>();
        return card->height() - card->parentWidget()->height();
    }
    // A button that one has to scroll to.
    bool hidesButtons()
    {
        const auto* const card = window.findChild<AlarmCard*>();
        const QWidget* const room = card->parentWidget();
        return std::ranges::any_of(card->findChildren<QPushButton*>(), [room](const QPushButton* button) {
            return button->isVisible() && !room->rect().contains(QRect(button->mapTo(room, QPoint()), button->size()));
        });
    }
    bool axesAreCut()
    {
        const auto* const head = window.findChild<ColumnHead*>();
        const auto cards = window.findChildren<AxisCard*>();
        return std::ranges::any_of(cards, [head](const AxisCard* card) {
            return !head->rect().contains(QRect(card->mapTo(head, QPoint()), card->size()));
        });
    }
};

constexpr int kLine = 18;  // px

// Story: an alarm came while the hand was on the pad, and the button under the pointer was another one.
// REQ-UI-975: No alarm of the catalogue moves the tabs, the panel or its buttons, in a window of any size: the readouts
// of the axes make room for it. All numbers and buttons stay in sight. What was done and what to do of a very long
// alarm scrolls by a few lines.
TEST_F(ColumnHeadTest, NoAlarmMovesTheTabs)
{
    for (const QSize size : {QSize(1024, 700), QSize(1280, 800), QSize(1920, 1080)}) {
        window.resize(size);
        const int before = tabs(samples::idle());
        int scrolled = 0;
        for (const AlarmEntry* const entry : alarmCatalogue()) {
            EXPECT_EQ(tabs(samples::alarmed(*entry)), before) << entry->id << " " << size.width();
            EXPECT_TRUE(window.findChild<AxisCard*>()->isVisible());
            EXPECT_FALSE(axesAreCut()) << entry->id << " " << size.width();
            EXPECT_FALSE(hidesButtons()) << entry->id << " " << size.width();
            scrolled += hidden() > 0 ? 1 : 0;
            EXPECT_LE(hidden(), 4 * kLine) << entry->id << " " << size.width();
        }
        EXPECT_EQ(tabs(samples::idle()), before);
        EXPECT_TRUE(scrolled <= 6 || size.width() < 1280) << scrolled;
    }
}

// REQ-UI-975
TEST_F(ColumnHeadTest, SeveralAlarmsAndALatchedStopMoveNothingEither)
{
    const int before = tabs(samples::idle());
    StationStatus status = samples::cableEnding();
    status.alarms.push_back(samples::alarmOf(alarmEntry("north.not-set"), 2));
    status.stopLatched = true;
    status.state = StationState::Stopped;
    EXPECT_EQ(tabs(status), before);
    EXPECT_TRUE(window.findChild<AlarmCard*>()->isVisible());
    EXPECT_FALSE(hidesButtons());
    EXPECT_EQ(tabs(samples::idle()), before);
}

}  // namespace
}  // namespace boresight::ui
