// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/sky/sky_projection.h"

#include <QRectF>
#include <QSizeF>

#include <vector>

class QPainter;

// What surrounds the disc of the sky in its square: ticks on the rim, the room of the cable ring, letters and degrees.
// It also knows which part of a corner of the square stays free of all of them. Pixels are the widget's own.
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

    // Room around the disc in a square of this side. The disc is nine tenths of it.
    [[nodiscard]] static double margin(double side);

    [[nodiscard]] const SkyProjection& sky() const { return m_sky; }
    // The room of the ring: from the centre of its innermost track to that of its outermost.
    [[nodiscard]] double innerTrack() const { return m_sky.radius + 0.28 * m_margin; }
    [[nodiscard]] double outerTrack() const { return m_sky.radius + 0.5 * m_margin; }
    [[nodiscard]] double widestTrack() const { return 0.13 * m_margin; }

    // True where neither the disc nor its ring or labels are.
    [[nodiscard]] bool isFree(const QRectF& box) const;
    // How wide a free box in this corner may be that reaches from `from` to `to` pixels away from the horizontal side.
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
