// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/station/station_status.h"
#include "ui/sky_markers.h"

#include <QWidget>

#include <memory>
#include <optional>

class QwtPolarGrid;
class QwtPolarPlot;

// The sky as the mount sees it, and the only place beside the strip charts that touches Qwt. Qwt draws what stands
// still (ground, limits, grid, labels) into a picture, again only when size, theme or travel change; SkyMarkers paints
// what moves over it. A click picks a direction; it moves nothing.
namespace boresight::ui {

class LabelsItem;
class SectorsItem;

class PolarPlot : public QWidget
{
    Q_OBJECT

public:
    explicit PolarPlot(Angle beamWidth, QWidget* parent = nullptr);
    ~PolarPlot() override;

    void showStatus(const StationStatus& status);
    void setPicked(const std::optional<SkyPointing>& direction);
    void describe(const StationStatus& status);  // in words, for screen readers; once a second is enough

    [[nodiscard]] const SkyMarkers& markers() const { return *m_markers; }
    // Where Qwt itself puts a direction: the test holds it against SkyProjection.
    [[nodiscard]] QPointF qwtPixel(const SkyPointing& direction) const;

    [[nodiscard]] QSize minimumSizeHint() const override { return {320, 320}; }

Q_SIGNALS:
    void clicked(const boresight::SkyPointing& direction);

protected:
    void changeEvent(QEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    void setUpScales();
    void setColours();
    void drawGround();
    [[nodiscard]] QRectF square() const;

    std::unique_ptr<QwtPolarGrid> m_grid;
    std::unique_ptr<SectorsItem> m_sectors;
    std::unique_ptr<LabelsItem> m_labels;
    QwtPolarPlot* m_plot;
    SkyMarkers* m_markers;
    TravelRange m_azimuthTravel;
    TravelRange m_elevationTravel;
    Angle m_beamWidth;
};

}  // namespace boresight::ui
