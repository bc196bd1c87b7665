// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/sky/sky_projection.h"

#include <QLineF>

#include <algorithm>
#include <cmath>

namespace boresight::ui {

QPointF SkyProjection::toPixel(const SkyPointing& direction) const
{
    const SkyPointing place = unflipped(direction);
    const double distance = std::clamp((90_deg - place.elevation) / 90_deg, 0.0, 1.0) * radius;
    const double azimuth = place.azimuth.radians();
    return zenith + QPointF(distance * std::sin(azimuth), -distance * std::cos(azimuth));
}

SkyPointing SkyProjection::toSky(QPointF pixel) const
{
    const QPointF offset = pixel - zenith;
    const double distance = radius > 0.0 ? std::min(std::hypot(offset.x(), offset.y()) / radius, 1.0) : 0.0;
    return {.azimuth = Angle::fromRadians(std::atan2(offset.x(), -offset.y())).wrapped360(),
            .elevation = 90_deg * (1.0 - distance)};
}

bool SkyProjection::contains(QPointF pixel) const
{
    const QPointF offset = pixel - zenith;
    return std::hypot(offset.x(), offset.y()) <= radius;
}

bool SkyProjection::contains(const QRectF& box) const
{
    return contains(box.topLeft()) && contains(box.topRight()) && contains(box.bottomLeft()) &&
           contains(box.bottomRight());
}

QRectF SkyProjection::inside(QRectF box) const
{
    const QLineF way(box.center(), zenith);
    for (double moved = 0.0; moved < way.length() && !contains(box); moved += 1.0) {
        box.moveCenter(way.pointAt(moved / way.length()));
    }
    return box;
}

SkyPointing unflipped(const SkyPointing& direction)
{
    if (direction.elevation <= 90_deg) {
        return direction;
    }
    return {.azimuth = (direction.azimuth + 180_deg).wrapped360(), .elevation = 180_deg - direction.elevation};
}

}  // namespace boresight::ui
