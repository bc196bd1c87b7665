// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"
#include "ui/sky/cable_ring.h"
#include "ui/sky/sky_frame.h"
#include "ui/sky/sky_paths.h"
#include "ui/sky/sky_satellites.h"
#include "ui/sky/sky_trail.h"

#include <QPainterPath>
#include <QPixmap>
#include <QRegion>
#include <QWidget>

#include <optional>
#include <vector>

// The moving parts of the polar plot: the trail, the way ahead, coming paths, the cable, Sun and Moon, and the markers.
// They are painted on a finished picture of the ground. A new status repaints only the few hundred pixels that a marker
// leaves and enters. Pixels of the widget.
namespace boresight::ui {

struct MarkerData
{
    std::optional<SkyPointing> actual;
    std::optional<SkyPointing> commanded;
    std::optional<SkyPointing> target;
    std::optional<SkyPointing> sensor;    // the direction of the beam by the independent sensor
    std::optional<SkyPointing> picked;    // clicked by the operator
    std::optional<SkyPointing> expected;  // the expected direction: during a slew the commanded one
    std::vector<SkyPointing> way;         // from the commanded place to the target, as the mount will go
    std::optional<Axis> missing;          // this angle of the mount is unknown: the beam is somewhere on a line
    QString targetLabel;
    Angle beamWidth;
    bool live = false;       // the actual direction is measured now; otherwise it is the last known one
    bool offTarget = false;  // an unplanned error above half a beam width

    bool operator==(const MarkerData&) const = default;
};

class SkyMarkers : public QWidget
{
    Q_OBJECT

public:
    explicit SkyMarkers(QWidget* parent = nullptr);

    // The ring of the cable is drawn only while the whole sky is shown. `names` are the boxes of the names on the
    // ground.
    void setGround(const QPixmap& ground, const SkyProjection& projection, const std::optional<CableRing>& ring = {},
                   const std::vector<QRectF>& names = {});
    void setMarkers(const MarkerData& markers, UtcTime utc);
    void setCable(const CableState& cable);
    void setBodies(const std::vector<BodyPlace>& bodies);
    void showPaths(const StationStatus& status);
    void setSatellites(const std::vector<SatellitePlace>& places);  // satellites that are up, without the tracked one
    void setTrail(const std::vector<SeenPlace>& places, UtcTime utc);  // in place of the present one
    void setPicked(const std::optional<SkyPointing>& direction);
    void setFocused(bool on);             // the plot has the keyboard: its rim shows this
    void paint(QPainter& painter) const;  // everything but the ground, also for a picture of the plot

    [[nodiscard]] QRect targetLabelBox() const;  // empty without a target or its text
    [[nodiscard]] const MarkerData& markers() const { return m_markers; }
    [[nodiscard]] const SkyProjection& projection() const { return m_projection; }
    [[nodiscard]] const SkyTrail& trail() const { return m_trail; }
    [[nodiscard]] const CableState& cable() const { return m_cable; }
    [[nodiscard]] const std::vector<BodyPlace>& bodies() const { return m_bodies; }
    [[nodiscard]] const QPainterPath& wayPixels() const { return m_wayPixels; }
    [[nodiscard]] SkyPaths& paths() { return m_paths; }
    [[nodiscard]] const SkyPaths& paths() const { return m_paths; }
    [[nodiscard]] const SkyPath& tracked() const { return m_paths.tracked(); }
    [[nodiscard]] const SkyPath& chosen() const { return m_paths.chosen(); }
    [[nodiscard]] const SkySatellites& satellites() const { return m_satellites; }
    [[nodiscard]] const QPixmap& ground() const { return m_ground; }

Q_SIGNALS:
    void clicked(const boresight::SkyPointing& direction);

protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;

private:
    void rebuildWay();
    [[nodiscard]] QRectF markerBox(const SkyPointing& direction, double size) const;
    [[nodiscard]] double beamRadius() const;
    [[nodiscard]] QPainterPath beamPixels() const;
    [[nodiscard]] bool covers(const QRect& box) const;
    [[nodiscard]] bool coversName(const QRect& box) const;
    [[nodiscard]] QRegion occupied() const;
    void drawWay(QPainter& painter) const;
    void drawActual(QPainter& painter) const;
    void drawTarget(QPainter& painter) const;

    QPixmap m_ground;
    SkyProjection m_projection;
    MarkerData m_markers;
    bool m_focused = false;
    SkyTrail m_trail;
    std::optional<CableRing> m_ring;
    std::vector<QRectF> m_names;
    CableState m_cable;
    std::vector<BodyPlace> m_bodies;
    SkySatellites m_satellites;
    QPainterPath m_wayPixels;
    SkyPaths m_paths;
};

}  // namespace boresight::ui
