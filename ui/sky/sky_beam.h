// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"
#include "ui/sky/planned_beam.h"
#include "ui/sky/sky_projection.h"

#include <QPainterPath>
#include <QPen>
#include <QRect>

#include <cstddef>

class QPainter;

// The planned beam beside the path of the target, where both are apart: a ramp, an unwrap, a way around a keep-out, a
// wait. Only the part that is still to come. Pixels of the widget.
namespace boresight::ui {

class SkyBeam
{
public:
    // The rectangle to be painted again. Empty if nothing has changed.
    QRect show(const PlannedBeam& beam, UtcTime utc);
    void setSky(const SkyProjection& sky);

    void paint(QPainter& painter) const;
    // Of the line, also for the legend.
    [[nodiscard]] static QPen pen();

    [[nodiscard]] const QPainterPath& line() const { return m_line; }

private:
    void rebuild();
    [[nodiscard]] QRect box() const;

    SkyProjection m_sky;
    PlannedBeam m_beam;
    std::size_t m_first = 0;  // index of the first moment that is still to come
    QPainterPath m_line;
};

}  // namespace boresight::ui
