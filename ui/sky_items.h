// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/sky_limits.h"

#include <qwt_polar_item.h>

// What stands still in the polar plot, as Qwt items: the sectors out of reach and the labels. Included by
// polar_plot.cpp only, so that Qwt stays in one place.
namespace boresight::ui {

class SectorsItem final : public QwtPolarItem
{
public:
    void setSectors(std::vector<SkySector> sectors);

    void draw(QPainter* painter, const QwtScaleMap& azimuthMap, const QwtScaleMap& radialMap, const QPointF& pole,
              double radius, const QRectF& canvasRect) const override;

private:
    std::vector<SkySector> m_sectors;
};

// Azimuths around the rim (letters for the cardinal points), elevations beside the north line.
class LabelsItem final : public QwtPolarItem
{
public:
    void draw(QPainter* painter, const QwtScaleMap& azimuthMap, const QwtScaleMap& radialMap, const QPointF& pole,
              double radius, const QRectF& canvasRect) const override;
    [[nodiscard]] int marginHint() const override;
};

// What the markers mean, for a corner outside the circle (Qwt clips its items to the circle).
void drawLegend(QPainter& painter, QPointF corner);

}  // namespace boresight::ui
