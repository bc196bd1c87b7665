// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/messages/adapter.h"
#include "tests/ui/window_fixture.h"
#include "ui/hold/jog_button.h"
#include "ui/window/panel_tabs.h"

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QHeaderView>
#include <QTabBar>
#include <QTableView>

#include <set>
#include <string>

namespace boresight::ui {
namespace {

using TouchSizesTest = WindowFixture;

TEST_F(TouchSizesTest, EveryControlHasANameAndATouchableSize)
{
    const auto expectUsable = [this] {
        settle();
        for (const QAbstractButton* const button : window.findChildren<QAbstractButton*>()) {
            if (button->isVisible() && button->inherits("QTabBar") == false &&
                !button->parentWidget()->inherits("QLineEdit") && !button->parentWidget()->inherits("QTableView")) {
                EXPECT_FALSE(button->accessibleName().isEmpty()) << button->text().toStdString();
                EXPECT_GE(button->height(), 44) << button->accessibleName().toStdString();
            }
        }
    };
    give(samples::update(samples::tracking(1)));
    for (const char panel : kPanels) {
        openPanel(panel);
        expectUsable();
    }
    give(samples::update(samples::asking(Axis::Azimuth, 7, 60_deg, false)));
    expectUsable();
    EXPECT_EQ(window.size(), QSize(1024, 700)) << "seven places do not fit";
}

// REQ-UI-1740: Tabs, and the rows of tables and lists that can be selected or edited, are 32 px high or more. The rows
// of tables that are only read may be lower.
TEST_F(TouchSizesTest, RowsAndTabsAreHighEnoughForAFinger)
{
    constexpr int kFinger = 32;  // px
    const std::set<QString> onlyRead{QStringLiteral("Readings of the drives"), QStringLiteral("Figures")};
    const auto expectHigh = [&](const std::string& where) {
        settle();
        for (const QTableView* const table : window.findChildren<QTableView*>()) {
            if (!onlyRead.contains(table->accessibleName())) {
                EXPECT_GE(table->verticalHeader()->defaultSectionSize(), kFinger)
                    << where << " " << table->accessibleName().toStdString();
            }
        }
        for (const QAbstractItemView* const list : window.findChildren<QAbstractItemView*>()) {
            const bool hasRow = list->isVisible() && list->model() != nullptr && list->model()->rowCount() > 0;
            if (hasRow && !list->inherits("QTableView") && !list->inherits("QHeaderView")) {
                EXPECT_GE(list->visualRect(list->model()->index(0, 0)).height(), kFinger)
                    << where << " " << list->accessibleName().toStdString();
            }
        }
        for (const QTabBar* const tabs : window.findChildren<QTabBar*>()) {
            EXPECT_TRUE(!tabs->isVisible() || tabs->tabRect(tabs->currentIndex()).height() >= kFinger)
                << where << " " << tabs->accessibleName().toStdString();
        }
    };
    give(samples::update(samples::tracking(1)));
    for (const char panel : kPanels) {
        openPanel(panel);
        expectHigh(std::string(1, panel));
    }
    QTest::keyClick(&window, Qt::Key_F3);
    Adapter adapter;
    adapter.bus = QStringLiteral("socketcan:can0");
    Q_EMIT window.host().adaptersFound({adapter});
    expectHigh("guide");
}

TEST_F(TouchSizesTest, ALargeScreenGivesThePanelsAThirdAndTheJogButtonsNoMoreThanAHandNeeds)
{
    window.resize(3840, 2160);
    openPanel('1');
    settle();
    const auto* const panels = window.findChild<PanelTabs*>();
    EXPECT_GT(panels->width(), window.width() / 4);
    EXPECT_LT(panels->width(), window.width() / 2);
    for (const JogButton* const button : window.findChildren<JogButton*>()) {
        if (button->isVisible()) {
            EXPECT_LE(button->height(), 200) << button->accessibleName().toStdString();
            EXPECT_LE(button->height(), button->width()) << button->accessibleName().toStdString();
        }
    }
}

}  // namespace
}  // namespace boresight::ui
