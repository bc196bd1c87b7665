// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"

#include <QRectF>

class QPainter;

namespace boresight::ui {

// The time axis of a pass below its picture: the first and the last moment to the second, between them round times with
// lines, as many as there is room for. UTC.
struct PassTimeAxis
{
    UtcTime first{};
    UtcTime last{};
    QRectF canvas;      // of the picture
    double room = 0.0;  // px from the left edge of the widget in which times may stand

    [[nodiscard]] double pixelOf(UtcTime utc) const;
    // With the pen of the grid, and the font of the painter.
    void paint(QPainter& painter) const;
};

}  // namespace boresight::ui
