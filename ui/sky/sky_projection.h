// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/units/sky.h"

#include <QPointF>
#include <QRectF>

// The place of a direction on the polar plot: north up, east right, zenith in the centre, horizon at the rim, radius
// linear in zenith distance. An elevation above 90° is drawn at its equal direction, one below the horizon on the rim.
// Pixels.
namespace boresight::ui {

struct SkyProjection
{
    QPointF zenith;
    double radius = 0.0;  // of the horizon

    [[nodiscard]] QPointF toPixel(const SkyPointing& direction) const;
    [[nodiscard]] SkyPointing toSky(QPointF pixel) const;  // outside the rim the result is on the horizon
    [[nodiscard]] bool contains(QPointF pixel) const;
    [[nodiscard]] bool contains(const QRectF& box) const;
    // The box, moved towards the zenith until the rim cuts nothing off.
    [[nodiscard]] QRectF inside(QRectF box) const;

    bool operator==(const SkyProjection&) const = default;
};

// The same direction with an elevation of at most 90°.
[[nodiscard]] SkyPointing unflipped(const SkyPointing& direction);

}  // namespace boresight::ui
