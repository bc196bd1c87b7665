// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/look/desk_style.h"

#include <QApplication>
#include <QComboBox>
#include <QScrollArea>
#include <QScrollBar>
#include <QSlider>
#include <QSpinBox>
#include <QTabBar>
#include <QTest>
#include <QVBoxLayout>
#include <QWheelEvent>

#include <gtest/gtest.h>

namespace boresight::ui {
namespace {

// A page that is higher than its window, with controls that the wheel could change.
struct Page
{
    Page()
    {
        DeskStyle::install();
        auto* const content = new QWidget;
        auto* const column = new QVBoxLayout(content);
        number = new QSpinBox(content);
        choice = new QComboBox(content);
        slider = new QSlider(Qt::Horizontal, content);
        choice->addItems({QStringLiteral("first"), QStringLiteral("second"), QStringLiteral("third")});
        number->setValue(50);
        choice->setCurrentIndex(1);
        slider->setValue(50);
        tabs = new QTabBar(content);
        tabs->setFocusPolicy(Qt::StrongFocus);
        tabs->addTab(QStringLiteral("Mount"));
        tabs->addTab(QStringLiteral("North"));
        tabs->setCurrentIndex(1);
        for (QWidget* const one : std::initializer_list<QWidget*>{number, choice, slider, tabs}) {
            column->addWidget(one);
        }
        column->addSpacing(2000);
        area.setWidget(content);
        area.setWidgetResizable(true);
        area.resize(300, 300);
        area.show();
        area.activateWindow();
        EXPECT_TRUE(QTest::qWaitForWindowActive(&area));
        area.setFocus();
    }

    void roll(QWidget& over) const
    {
        const QPointF place = over.rect().center();
        QWheelEvent event(place, over.mapToGlobal(place), {}, QPoint(0, -120), Qt::NoButton, Qt::NoModifier,
                          Qt::NoScrollPhase, false);
        QSpontaneKeyEvent::setSpontaneous(&event);  // as from a mouse: Qt passes only such an event on to the page
        qApp->notify(&over, &event);
    }

    QScrollArea area;
    QSpinBox* number;
    QComboBox* choice;
    QSlider* slider;
    QTabBar* tabs;
};

// Story: an operator scrolled the page of the compass swing and changed its "Stops" from sweep to 7 unnoticed.
// REQ-UI-995: The wheel scrolls the page and changes no number, choice or slider under the pointer. It changes only the
// control that has the keyboard.
TEST(WheelGuardTest, AWheelThatScrollsThePageChangesNothing)
{
    Page page;
    int before = page.area.verticalScrollBar()->value();
    for (QWidget* const over : std::initializer_list<QWidget*>{page.number, page.choice, page.slider}) {
        page.roll(*over);
        EXPECT_FALSE(over->hasFocus());
        EXPECT_GT(page.area.verticalScrollBar()->value(), before) << over->metaObject()->className();
        before = page.area.verticalScrollBar()->value();
    }
    EXPECT_EQ(page.number->value(), 50);
    EXPECT_EQ(page.choice->currentIndex(), 1);
    EXPECT_EQ(page.slider->value(), 50);
    page.number->setFocus();
    page.roll(*page.number);
    EXPECT_EQ(page.number->value(), 49);
}

// Story: an operator scrolled the page North up to its top and opened the page Mount, because the tabs came under the
// pointer.
// REQ-UI-1573: The wheel never changes the tab, not even while the tabs have the keyboard.
TEST(WheelGuardTest, AWheelThatScrollsThePageChangesNoTab)
{
    Page page;
    int before = page.area.verticalScrollBar()->value();
    for (const bool focused : {false, true}) {
        if (focused) {
            page.tabs->setFocus();
        }
        page.roll(*page.tabs);
        EXPECT_EQ(page.tabs->currentIndex(), 1) << focused;
        EXPECT_GT(page.area.verticalScrollBar()->value(), before) << focused;
        before = page.area.verticalScrollBar()->value();
    }
}

}  // namespace
}  // namespace boresight::ui
