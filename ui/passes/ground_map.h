// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/passes/ground_track.h"

#include <QPainterPath>
#include <QPixmap>
#include <QWidget>

#include <optional>

// The map of the Earth with the track of the selected satellite: during its pass and for one more orbit. It also shows
// the present place of the satellite, and the circle of all places that see it now. Passive. Gui thread.
namespace boresight::ui {

class GroundMap : public QWidget
{
    Q_OBJECT

public:
    explicit GroundMap(QWidget* parent = nullptr);

    void show(const GroundTrack& track);
    void setSite(const std::optional<Site>& site);
    void setPlace(const std::optional<Site>& below);  // the present place below the satellite

    [[nodiscard]] QPointF pixelOf(const Site& place) const;
    [[nodiscard]] QPainterPath lineOf(const std::vector<Site>& places) const;  // interrupted where it leaves the map
    [[nodiscard]] const std::optional<Site>& place() const { return m_place; }

    [[nodiscard]] QSize minimumSizeHint() const override { return {200, 80}; }

protected:
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    [[nodiscard]] QRectF map() const;
    void drawGround();

    GroundTrack m_track;
    std::optional<Site> m_site;
    std::optional<Site> m_place;
    QPixmap m_ground;  // picture of land and grid; empty: not drawn yet
};

}  // namespace boresight::ui
