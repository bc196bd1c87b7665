// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"
#include "ui/sky/sky_projection.h"

#include <QPainterPath>
#include <QPixmap>
#include <QRegion>
#include <QWidget>

#include <deque>
#include <optional>
#include <vector>

// What moves in the polar plot: the past path (the last quarter of an hour), the way ahead and the markers, painted
// over a ready-made picture of what stands still. A new status repaints only the few hundred pixels a marker leaves and
// enters. Pixels are the widget's own.
namespace boresight::ui {

struct MarkerData
{
    std::optional<SkyPointing> actual;
    std::optional<SkyPointing> commanded;
    std::optional<SkyPointing> target;
    std::optional<SkyPointing> sensor;  // where the independent sensor says that the beam points
    std::optional<SkyPointing> picked;  // clicked by the operator
    std::vector<SkyPointing> way;       // from the commanded place to the target, around what is forbidden
    std::optional<Axis> missing;        // nobody knows this angle of the mount: the beam is somewhere on a line
    QString targetLabel;
    Angle beamWidth;
    bool live = false;       // the actual place is measured now; else it is where the mount was last seen
    bool offTarget = false;  // error above half a beam width

    bool operator==(const MarkerData&) const = default;
};

class SkyMarkers : public QWidget
{
    Q_OBJECT

public:
    explicit SkyMarkers(QWidget* parent = nullptr);

    void setGround(const QPixmap& ground, const SkyProjection& projection);
    void setMarkers(const MarkerData& markers, UtcTime utc);
    void setPicked(const std::optional<SkyPointing>& direction);
    void paint(QPainter& painter) const;  // all but the ground, also for a picture of the plot

    [[nodiscard]] QRect targetLabelBox() const;  // empty without a target or its text
    [[nodiscard]] const MarkerData& markers() const { return m_markers; }
    [[nodiscard]] const SkyProjection& projection() const { return m_projection; }
    [[nodiscard]] std::size_t pathLength() const { return m_path.size(); }
    [[nodiscard]] const QPainterPath& pathPixels() const { return m_pathPixels; }
    [[nodiscard]] const QPainterPath& wayPixels() const { return m_wayPixels; }
    [[nodiscard]] const QPixmap& ground() const { return m_ground; }

Q_SIGNALS:
    void clicked(const boresight::SkyPointing& direction);

protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;

private:
    struct PastPlace
    {
        SkyPointing place;
        UtcTime utc;
    };

    void extendPath(UtcTime utc);
    void forgetOldPath(UtcTime utc);
    void addToPath(const SkyPointing& place);
    void rebuildPath();
    void rebuildWay();
    [[nodiscard]] QRectF markerBox(const SkyPointing& direction, double size) const;
    [[nodiscard]] double beamRadius() const;
    [[nodiscard]] QPainterPath beamPixels() const;
    [[nodiscard]] bool covers(const QRect& box) const;
    [[nodiscard]] QRegion occupied() const;
    void drawActual(QPainter& painter) const;
    void drawTarget(QPainter& painter) const;

    QPixmap m_ground;
    SkyProjection m_projection;
    MarkerData m_markers;
    std::deque<PastPlace> m_path;  // eldest first
    std::optional<SkyPointing> m_pathEnd;
    QPainterPath m_pathPixels;  // the same, for the present projection
    QPainterPath m_wayPixels;
};

}  // namespace boresight::ui
