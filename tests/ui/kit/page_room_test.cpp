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

    QTabWidget tabs;
    tabs.addTab(new TallPage(100), QStringLiteral("low"));
    tabs.addTab(new TallPage(400), QStringLiteral("high"));
    const int both = tabs.minimumSizeHint().height();
    keepHeightOfShownPage(tabs);
    EXPECT_EQ(both - tabs.minimumSizeHint().height(), 300);
}

}  // namespace
}  // namespace boresight::ui
