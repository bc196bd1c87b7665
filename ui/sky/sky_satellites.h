// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/units/sky.h"
#include "ui/sky/sky_projection.h"

#include <QRegion>
#include <QString>

#include <vector>

class QPainter;

// Satellites that are up, besides the one that is tracked: a small ring with the name where the name hides no other.
// Pixels are the widget's own.
namespace boresight::ui {

struct SatellitePlace
{
    QString name;
    SkyPointing direction;

    bool operator==(const SatellitePlace&) const = default;
};

class SkySatellites
{
public:
    struct Mark
    {
        QPointF pixel;
        QString name;
        QRectF text;  // empty: it would lie over another name
    };

    // What must be painted again; empty: nothing has changed.
    QRegion show(const std::vector<SatellitePlace>& places);
    void setSky(const SkyProjection& sky);

    void paint(QPainter& painter) const;

    [[nodiscard]] const std::vector<Mark>& marks() const { return m_marks; }

private:
    void rebuild();
    [[nodiscard]] QRegion region() const;

    SkyProjection m_sky;
    std::vector<SatellitePlace> m_places;
    std::vector<Mark> m_marks;
};

}  // namespace boresight::ui
