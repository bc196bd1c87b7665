// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

// The place of the charts in a wide window. It does not count in the least width of the window: a wide window may
// become narrow at once, for example when it leaves full screen. The strip is hidden then.
namespace boresight::ui {

class ChartStrip : public QWidget
{
public:
    using QWidget::QWidget;

    [[nodiscard]] QSize minimumSizeHint() const override { return {0, QWidget::minimumSizeHint().height()}; }
};

}  // namespace boresight::ui
