// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/messages/station_status.h"
#include "ui/sky/plot_editor.h"
#include "ui/sky/plot_menu.h"
#include "ui/sky/sky_legend.h"
#include "ui/sky/sky_markers.h"
#include "ui/sky/sky_zoom.h"

#include <QWidget>

#include <memory>
#include <optional>

class QwtPolarGrid;
class QwtPolarPlot;

// The sky as the mount sees it. Apart from the strip charts this is the only user of Qwt. There are three layers. Qwt
// draws the ground (region of the profile in effect, grid, labels) into a picture, again only when size, theme, region
// or magnification change. SkyMarkers paints the moving parts on it. PlotEditor draws the limits being changed. A click
// picks a direction and moves nothing. While editing is on it picks none. A right click, or the menu key, opens the
// menu for this place.
// More than 15 members: the layers and parts that it composes.
namespace boresight::ui {

class LabelsItem;
class PlotTools;
class RegionItem;

class PolarPlot : public QWidget
{
    Q_OBJECT

public:
    PolarPlot(ProfileDraft& draft, RequestDesk& desk, QWidget* parent = nullptr);
    ~PolarPlot() override;

    void showStatus(const StationStatus& status);
    void setPicked(const std::optional<SkyPointing>& direction);
    // Of the pass that is selected in a list, and of its plan. Null: none. Drawn with the next status.
    void setChosenWay(const targets::SkyWay& way) { m_markers->paths().setChosenWay(way); }
    void setChosenBeam(const PlannedBeam& beam) { m_markers->paths().setChosenBeam(beam); }
    void setSatellites(const std::vector<SatellitePlace>& places);  // satellites that are up, without the tracked one
    void describe(const StationStatus& status);  // in words, for screen readers; once a second is enough
    void setEditing(bool on);
    void toggleZoom();
    void zoomBy(int steps);
    void paintPicture(QPainter& painter) const;  // in the size of the widget, without buttons and unapplied edits

    [[nodiscard]] PlotEditor& editor() { return *m_editor; }
    [[nodiscard]] PlotTools& tools() { return *m_tools; }
    [[nodiscard]] PlotMenu& menu() { return *m_menu; }
    [[nodiscard]] const SkyFrame& frame() const { return m_frame; }
    [[nodiscard]] const SkyMarkers& markers() const { return *m_markers; }
    [[nodiscard]] SkyMarkers& markers() { return *m_markers; }
    [[nodiscard]] const SkyZoom& zoom() const { return m_zoom; }
    // The pixel where Qwt puts a direction. A test compares it with SkyProjection.
    [[nodiscard]] QPointF qwtPixel(const SkyPointing& direction) const;

    [[nodiscard]] QSize minimumSizeHint() const override { return {320, 320}; }

Q_SIGNALS:
    void clicked(const boresight::SkyPointing& direction);
    void goHereWanted(const boresight::SkyPointing& direction);
    void editingChanged(bool on);

protected:
    void changeEvent(QEvent* event) override;
    void contextMenuEvent(QContextMenuEvent* event) override;
    void focusInEvent(QFocusEvent*) override { m_markers->setFocused(true); }
    void focusOutEvent(QFocusEvent*) override { m_markers->setFocused(false); }
    void resizeEvent(QResizeEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;

private:
    void setUpScales();
    void setUpTools();
    void setUpMenu();
    void setColours();
    void setGrid(const SkyGrid& grid);
    void showRegion(const StationStatus& status);
    void showCable(const StationStatus& status);
    void showMarkers(const StationStatus& status);
    void showLegend(const LegendParts& parts);
    void changeView();
    void drawGround();
    void paintSky(QPainter& painter) const;
    void paintGround(QPainter& painter) const;
    [[nodiscard]] QRectF square() const;
    [[nodiscard]] QRectF canvas() const;
    [[nodiscard]] SkyProjection wholeSky() const;
    [[nodiscard]] SkyProjection sky() const;
    [[nodiscard]] std::optional<CableRing> ring() const;

    std::unique_ptr<QwtPolarGrid> m_grid;
    std::unique_ptr<RegionItem> m_regionItem;
    std::unique_ptr<LabelsItem> m_labels;
    QwtPolarPlot* m_plot;
    SkyMarkers* m_markers;
    PlotEditor* m_editor;
    PlotTools* m_tools;
    PlotMenu* m_menu;
    SkyFrame m_frame;  // of the whole sky
    SkyZoom m_zoom;
    std::optional<pointing::Region> m_region;  // the region as drawn
    Travel m_travel;
    TravelRange m_cableTravel;  // as drawn in the ring
    Angle m_cableZero;
    bool m_wrapKnown = true;
    LegendParts m_legend;
    Angle m_beamWidth;
    SkyPointing m_focus{0_deg, 90_deg};  // the centre of the magnified part: the target, else the actual direction
    QString m_caption;                   // of a picture
    int m_wheel = 0;                     // wheel steps that are not yet a whole notch
};

}  // namespace boresight::ui
