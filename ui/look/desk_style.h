// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/look/wheel_guard.h"

#include <QProxyStyle>

class QTabBar;

// The look of every widget: flat buttons with rounded corners, thin edges, cards, number fields with two step buttons,
// rows and tabs large enough for a finger. It draws with the colours of the current theme, based on Qt's Fusion. Gui
// thread.
namespace boresight::ui {

// px beside the words of a tab, on both sides together. Applies from the next layout on.
constexpr int kTabSpace = 14;
void setTabSpace(QTabBar& tabs, int space);

class DeskStyle : public QProxyStyle
{
    Q_OBJECT

public:
    DeskStyle();

    // Once per program. Further calls do nothing.
    static void install();

    using QProxyStyle::polish;
    void polish(QWidget* widget) override;

    [[nodiscard]] int pixelMetric(PixelMetric metric, const QStyleOption* option, const QWidget* widget) const override;
    [[nodiscard]] int styleHint(StyleHint hint, const QStyleOption* option, const QWidget* widget,
                                QStyleHintReturn* data) const override;
    [[nodiscard]] QSize sizeFromContents(ContentsType type, const QStyleOption* option, const QSize& contents,
                                         const QWidget* widget) const override;
    [[nodiscard]] QRect subControlRect(ComplexControl control, const QStyleOptionComplex* option, SubControl part,
                                       const QWidget* widget) const override;
    [[nodiscard]] QRect subElementRect(SubElement element, const QStyleOption* option,
                                       const QWidget* widget) const override;

    void drawPrimitive(PrimitiveElement element, const QStyleOption* option, QPainter* painter,
                       const QWidget* widget) const override;
    void drawControl(ControlElement element, const QStyleOption* option, QPainter* painter,
                     const QWidget* widget) const override;
    void drawComplexControl(ComplexControl control, const QStyleOptionComplex* option, QPainter* painter,
                            const QWidget* widget) const override;

private:
    WheelGuard m_wheel;
};

}  // namespace boresight::ui
