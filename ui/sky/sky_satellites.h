// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/units/sky.h"
#include "ui/sky/sky_projection.h"

#include <QRegion>
#include <QString>

#include <vector>

class QPainter;

// Satellites that are up, without the tracked one: a small ring, with the name if it hides no other name. Pixels of the
// widget.
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
        QRectF text;  // empty if it would cover another name
    };

    // The region to be painted again. Empty if nothing has changed.
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
