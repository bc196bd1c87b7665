// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/units/sky.h"

#include <QRectF>

class QPainter;

// The travel of an axis as a horizontal bar: hatched beyond its ends, with a tick every 90° (every 30° for a short
// travel), labelled below as far as there is room. Pixels of the widget that paints.
namespace boresight::ui {

class TravelScale
{
public:
    static constexpr double kCap = 14.0;  // px of a hatched end, outside the box

    TravelScale(TravelRange travel, const QRectF& box) : m_travel(travel), m_box(box) {}

    [[nodiscard]] bool isEmpty() const { return m_travel.max <= m_travel.min; }  // no profile received yet
    [[nodiscard]] double pixel(Angle angle) const;
    void draw(QPainter& painter) const;

private:
    void drawTicks(QPainter& painter) const;

    TravelRange m_travel;
    QRectF m_box;
};

}  // namespace boresight::ui
