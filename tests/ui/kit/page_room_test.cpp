// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/kit/page_room.h"

#include <QStackedWidget>
#include <QTabWidget>

#include <gtest/gtest.h>

namespace boresight::ui {
namespace {

class TallPage : public QWidget
{
public:
    explicit TallPage(int height) : m_height(height) {}
    [[nodiscard]] QSize minimumSizeHint() const override { return {m_height, m_height}; }
    [[nodiscard]] QSize sizeHint() const override { return minimumSizeHint(); }

private:
    int m_height;
};

// Story: below an alarm the guide scrolled at 1280x800, because of the height of a tab behind it.
// REQ-UI-955: A hidden page affects the width and not the height.
TEST(PageRoom, OnlyTheShownPageAsksForHeight)
{
    QStackedWidget pages;
    pages.addWidget(new TallPage(100));
    pages.addWidget(new TallPage(400));
    keepHeightOfShownPage(pages);
    EXPECT_EQ(pages.minimumSizeHint(), QSize(400, 100));
    pages.setCurrentIndex(1);
    EXPECT_EQ(pages.minimumSizeHint().height(), 400);
}

// REQ-UI-1776: A page behind a tab scrolls by itself, needs no height, and is found by its tab.
TEST(PageRoom, AScrollingPageNeedsNoHeight)
{
    QTabWidget tabs;
    auto* const low = new TallPage(100);
    auto* const high = new TallPage(400);
    EXPECT_EQ(addScrollingPage(tabs, *low, QStringLiteral("low")), 0);
    EXPECT_EQ(addScrollingPage(tabs, *high, QStringLiteral("high")), 1);
    EXPECT_LT(tabs.minimumSizeHint().height(), 150);
    EXPECT_GE(tabs.minimumSizeHint().width(), 400);
    EXPECT_EQ(tabOf(tabs, *high), 1);
    EXPECT_EQ(tabOf(tabs, tabs), -1);
    tabs.setCurrentIndex(1);
    EXPECT_EQ(shownPage(tabs), high);
}

}  // namespace
}  // namespace boresight::ui
