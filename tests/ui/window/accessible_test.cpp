// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/ui/step_button_of.h"
#include "tests/ui/window_fixture.h"
#include "ui/guide/guide_page.h"
#include "ui/sky/polar_plot.h"
#include "ui/window/guide_room.h"
#include "ui/window/help_page.h"

#include <QAccessible>
#include <QApplication>
#include <QComboBox>
#include <QImage>
#include <QSet>
#include <QWindow>

// What a screen reader announces and what the keyboard reaches: on each panel, in each step of the guide, on the help
// page.
namespace boresight::ui {
namespace {

std::string nameOf(const QWidget& widget)
{
    return std::string(widget.metaObject()->className()) + " \"" + widget.accessibleName().toStdString() + "\"";
}

// A part of one of Qt's own controls, which has the name for it.
bool isPart(const QWidget& widget)
{
    return widget.focusProxy() != nullptr || qobject_cast<const QComboBox*>(widget.parentWidget()) != nullptr ||
           widget.objectName().startsWith(QLatin1String("qt_"));
}

bool takesFocus(const QWidget& widget)
{
    return (widget.focusPolicy() & Qt::TabFocus) != 0 && widget.isVisible() && widget.isEnabled();
}

class AccessibleTest : public WindowFixture
{
protected:
    // Everything that the window can show, one after the other.
    template <class Check>
    void everywhere(Check check)
    {
        give(samples::update(samples::bounded()));
        for (const char panel : std::string(kPanels)) {
            SCOPED_TRACE(std::string("panel ") + panel);
            openPanel(panel);
            settle();
            check(window);
        }
        give(samples::update(samples::asking(Axis::Azimuth, 3, 180_deg, true)));
        {
            SCOPED_TRACE("panel 9");
            settle();
            check(window);
        }
        give(samples::update(samples::freshMount()));
        QTest::keyClick(&window, Qt::Key_F3);
        for (const GuideStep step : kGuideSteps) {
            SCOPED_TRACE(name(step).toStdString());
            QTest::mouseClick(&stepButtonOf(window, step), Qt::LeftButton);
            settle();
            check(window);
        }
        QTest::keyClick(&window, Qt::Key_F3);
    }

    static QWidget* tab(QWidget& top, Qt::Key key = Qt::Key_Tab)
    {
        QTest::keyClick(top.windowHandle(), key);
        return QApplication::focusWidget();
    }

    // The widgets in the order of Tab, from the control that has the focus. Ends when it comes round, or after too
    // many.
    static QList<QWidget*> tabRound(QWidget& top)
    {
        QList<QWidget*> round;
        for (QWidget* now = tab(top); now != nullptr && !round.contains(now) && round.size() < 200; now = tab(top)) {
            round << now;
        }
        return round;
    }
};

// REQ-UI-37 (AccessibleTest.*): A screen reader gets the name and role of each control and the value of each readout.
// Tab reaches all controls from top to bottom, and can leave each of them. The focus is visible in every theme.
TEST_F(AccessibleTest, EveryControlHasANameAndARole)
{
    everywhere([](QWidget& top) {
        for (QWidget* const widget : top.findChildren<QWidget*>()) {
            if (!takesFocus(*widget) || isPart(*widget)) {
                continue;
            }
            QAccessibleInterface* const told = QAccessible::queryAccessibleInterface(widget);
            ASSERT_NE(told, nullptr) << nameOf(*widget);
            EXPECT_FALSE(told->text(QAccessible::Name).trimmed().isEmpty()) << nameOf(*widget);
            EXPECT_NE(told->role(), QAccessible::NoRole) << nameOf(*widget);
            EXPECT_NE(told->role(), QAccessible::Client) << nameOf(*widget);
        }
    });
}

TEST_F(AccessibleTest, EveryReadoutTellsItsValue)
{
    everywhere([](QWidget& top) {
        for (ValueLabel* const label : top.findChildren<ValueLabel*>()) {
            QAccessibleInterface* const told = QAccessible::queryAccessibleInterface(label);
            ASSERT_NE(told, nullptr);
            EXPECT_EQ(told->role(), QAccessible::StaticText);
            EXPECT_FALSE(told->text(QAccessible::Name).isEmpty()) << label->text().toStdString();
            EXPECT_EQ(told->text(QAccessible::Value), label->text());
            EXPECT_TRUE(label->text().isEmpty() || told->text(QAccessible::Description) == label->text());
        }
    });
}

TEST_F(AccessibleTest, ThePlotIsToldInNumbers)
{
    give(samples::update(samples::tracking(330)));
    QAccessibleInterface* const plot = QAccessible::queryAccessibleInterface(window.findChild<PolarPlot*>());
    EXPECT_EQ(plot->role(), QAccessible::Chart);
    EXPECT_FALSE(plot->text(QAccessible::Name).isEmpty());
    elapse(Seconds(1.0));
    const QString words = plot->text(QAccessible::Description);
    const StationStatus status = samples::tracking(330);
    for (const auto& direction : {status.actual, status.target}) {
        const QString azimuth = QString::number(direction->azimuth.degrees(), 'f', 1);
        EXPECT_TRUE(words.contains(azimuth)) << azimuth.toStdString() << " in " << words.toStdString();
    }
}

TEST_F(AccessibleTest, TabReachesEveryControlAndIsNeverCaught)
{
    everywhere([](QWidget& top) {
        const QList<QWidget*> round = tabRound(top);
        ASSERT_LT(round.size(), 200) << "it does not come round";
        for (QWidget* const widget : top.findChildren<QWidget*>()) {
            // One of several exclusive choices counts for all, because the arrow keys reach the others.
            const auto* const choice = qobject_cast<QAbstractButton*>(widget);
            const bool byArrows = choice != nullptr && choice->group() != nullptr && !choice->isChecked();
            if (takesFocus(*widget) && !isPart(*widget) && widget->window() == &top && !byArrows) {
                EXPECT_TRUE(round.contains(widget)) << nameOf(*widget) << " is not reached";
            }
        }
        QWidget* const last = QApplication::focusWidget();
        tab(top);
        EXPECT_EQ(tab(top, Qt::Key_Backtab), last) << "and back";
    });
}

// Within the panel from top to bottom. A control beside the previous one may be slightly higher.
TEST_F(AccessibleTest, TabGoesFromAboveToBelow)
{
    everywhere([](QWidget& top) {
        const QList<QWidget*> round = tabRound(top);
        const auto place = [&](QWidget* widget) { return QRect(widget->mapTo(&top, QPoint()), widget->size()); };
        const auto isInPanel = [&](QWidget* widget) { return place(widget).left() > top.width() / 2; };
        int upwards = 0;
        std::string where;
        for (qsizetype i = 1; i < round.size(); ++i) {
            const bool both = isInPanel(round[i - 1]) && isInPanel(round[i]);
            // The control is completely above the previous one, not beside it in another column.
            if (both && place(round[i]).bottom() < place(round[i - 1]).top()) {
                ++upwards;
                where += nameOf(*round[i - 1]) + " -> " + nameOf(*round[i]) + "; ";
            }
        }
        EXPECT_LE(upwards, 4)
            << where;  // to the next column, to the places, and from the last control by the Guide to STOP
    });
}

class FocusIsSeen : public AccessibleTest, public ::testing::WithParamInterface<ThemeKind>
{
protected:
    static int differentPixels(const QImage& a, const QImage& b)
    {
        int different = 0;
        for (int y = 0; y < a.height(); ++y) {
            for (int x = 0; x < a.width(); ++x) {
                different += a.pixel(x, y) != b.pixel(x, y) ? 1 : 0;
            }
        }
        return different;
    }
    // With its surroundings, where a frame may be drawn.
    static QImage picture(QWidget& top, QWidget& widget)
    {
        return top.grab(QRect(widget.mapTo(&top, QPoint()), widget.size()).adjusted(-3, -3, 3, 3)).toImage();
    }
};

// REQ-UI-37 (FocusIsSeen.*)
TEST_P(FocusIsSeen, OnEveryControl)
{
    applyTheme(GetParam());
    everywhere([](QWidget& top) {
        QList<QWidget*> round = tabRound(top);
        for (QWidget* const widget : round) {
            if (!widget->isVisible()) {
                continue;
            }
            top.setFocus();
            widget->setFocus(Qt::TabFocusReason);
            const QImage with = picture(top, *widget);
            widget->clearFocus();
            const QImage without = picture(top, *widget);
            EXPECT_GE(differentPixels(with, without), 8) << nameOf(*widget);
        }
    });
    applyTheme(ThemeKind::Day);
}

// REQ-UI-1590: A control of a scrolling panel scrolls into view when it receives the focus, also without Tab.
TEST_F(AccessibleTest, AControlWithTheFocusComesIntoSight)
{
    auto* const room = window.findChild<GuideRoom*>();
    room->setMaximumHeight(200);  // px: each panel scrolls
    openPanel('9');
    settle();
    int judged = 0;
    for (QWidget* const widget : tabRound(window)) {
        if (room->isAncestorOf(widget)) {
            window.setFocus();
            widget->setFocus(Qt::OtherFocusReason);
            EXPECT_FALSE(widget->visibleRegion().isEmpty()) << nameOf(*widget);
            ++judged;
        }
    }
    EXPECT_GT(judged, 3);
}

INSTANTIATE_TEST_SUITE_P(All, FocusIsSeen, ::testing::Values(ThemeKind::Day, ThemeKind::Night, ThemeKind::Red));

}  // namespace
}  // namespace boresight::ui
