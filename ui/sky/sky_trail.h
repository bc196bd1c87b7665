// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"
#include "ui/sky/sky_projection.h"

#include <QPainterPath>
#include <QRect>

#include <deque>
#include <optional>

class QPainter;

// Where the mount was in the last quarter of an hour. The last minute is strong and fades, the rest is a faint line. It
// is drawn only where the mount was seen to go: after silence or a new reference it begins again. Pixels are the
// widget's own.
namespace boresight::ui {

class SkyTrail
{
public:
    // The rectangle that must be painted again; empty: nothing has changed.
    QRect add(const SkyPointing& place, UtcTime utc);
    QRect age(UtcTime utc);
    void setSky(const SkyProjection& sky);

    void paint(QPainter& painter) const;

    [[nodiscard]] std::size_t length() const { return m_places.size(); }
    [[nodiscard]] const QPainterPath& pixels() const { return m_pixels; }
    // 1 at the mount, down to that of the faint line after a minute.
    [[nodiscard]] double strength(UtcTime utc) const;

private:
    struct Place
    {
        SkyPointing direction;
        UtcTime utc;
        QPointF pixel;
        bool begins;  // a new piece
    };

    void append(const SkyPointing& direction, UtcTime utc);
    [[nodiscard]] std::deque<Place>::const_iterator lastMinute() const;
    void rebuild();

    SkyProjection m_sky;
    std::deque<Place> m_places;  // eldest first
    QPainterPath m_pixels;
    UtcTime m_now{};
    UtcTime m_painted{};  // when the fading was last shown
};

}  // namespace boresight::ui
