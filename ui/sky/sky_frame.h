// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/sky/sky_projection.h"

#include <QRectF>
#include <QSizeF>

#include <vector>

class QPainter;

// The surroundings of the disc of the sky in its square: ticks on the rim, the room of the cable ring, letters and
// degrees. It also knows the free part of each corner of the square. Pixels of the widget.
namespace boresight::ui {

enum class SkyCorner
{
    UpperLeft,
    UpperRight,
    LowerLeft,
    LowerRight
};

class SkyFrame
{
public:
    SkyFrame() = default;
    SkyFrame(const QRectF& view, const SkyProjection& sky);

    // The margin around the disc in a square with this side. The disc takes nine tenths of the side.
    [[nodiscard]] static double margin(double side);

    [[nodiscard]] const SkyProjection& sky() const { return m_sky; }
    // The room for the ring: from the centre of its innermost track to that of its outermost.
    [[nodiscard]] double innerTrack() const { return m_sky.radius + 0.28 * m_margin; }
    [[nodiscard]] double outerTrack() const { return m_sky.radius + 0.5 * m_margin; }
    [[nodiscard]] double widestTrack() const { return 0.13 * m_margin; }

    // True if the box overlaps neither the disc nor its ring or labels.
    [[nodiscard]] bool isFree(const QRectF& box) const;
    // The largest width of a free box in this corner that reaches from `from` to `to` pixels from the horizontal side.
    [[nodiscard]] double freeWidth(SkyCorner corner, double from, double to) const;

    void paint(QPainter& painter) const;

private:
    struct Label
    {
        QRectF box;
        int degrees;
    };
    [[nodiscard]] QRectF labelBox(int degrees) const;
    void paintTicks(QPainter& painter) const;

    QRectF m_view;
    SkyProjection m_sky;
    double m_margin = 0.0;
    std::vector<Label> m_labels;
};

}  // namespace boresight::ui
