// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/pointing/region.h"
#include "ui/sky/sky_limits.h"
#include "ui/sky/sky_zoom.h"

#include <qwt_polar_item.h>

// The parts of the polar plot that stand still, as Qwt items: areas that are out of reach, limits, keep-outs and the
// labels. Only polar_plot.cpp includes this file, so that Qwt stays in one place.
namespace boresight::ui {

class RegionItem final : public QwtPolarItem
{
public:
    void setRegion(const pointing::Region& region, const Travel& travel);
    void setView(const QRectF& view) { m_view = view; }  // the visible part of the canvas

    void draw(QPainter* painter, const QwtScaleMap& azimuthMap, const QwtScaleMap& radialMap, const QPointF& pole,
              double radius, const QRectF& canvasRect) const override;
    // The boxes of the names of the sectors, in pixels.
    [[nodiscard]] std::vector<QRectF> nameBoxes(const SkyProjection& sky) const;

private:
    void drawSectors(QPainter& painter, const SkyProjection& sky, SectorKind kind) const;
    void drawHorizon(QPainter& painter, const SkyProjection& sky) const;
    [[nodiscard]] QRectF nameBox(const SkySector& sector, const SkyProjection& sky) const;

    std::vector<SkySector> m_sectors;
    std::vector<pointing::HorizonPoint> m_horizon;
    QRectF m_view;
};

// For the whole sky: elevations beside the north line. (SkyFrame draws the azimuths.) For a magnified part: both, along
// the lines through the middle of the view.
class LabelsItem final : public QwtPolarItem
{
public:
    void setGrid(const SkyGrid& grid) { m_grid = grid; }
    void setView(const QRectF& view, bool magnified);

    void draw(QPainter* painter, const QwtScaleMap& azimuthMap, const QwtScaleMap& radialMap, const QPointF& pole,
              double radius, const QRectF& canvasRect) const override;
    [[nodiscard]] int marginHint() const override;

private:
    void drawInside(QPainter& painter, const SkyProjection& sky) const;

    SkyGrid m_grid;
    QRectF m_view;
    bool m_magnified = false;
};

// Shows that this is only a part of the sky, and its scale: a frame, and a box `above` pixels above the lower left
// corner.
void drawZoomMark(QPainter& painter, const QRectF& view, double above, const SkyProjection& sky, double magnification);

}  // namespace boresight::ui
