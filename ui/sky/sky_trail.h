// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"
#include "ui/sky/sky_projection.h"

#include <QPainterPath>
#include <QRect>

#include <deque>
#include <optional>
#include <vector>

class QPainter;

// The path of the mount during the last quarter of an hour. The last minute is strong and fades, the rest is a faint
// line. It is drawn only where the motion was observed: after silence or a new reference it starts again. Pixels of the
// widget.
namespace boresight::ui {

// A place where the beam was seen.
struct SeenPlace
{
    SkyPointing direction;
    UtcTime utc;
};

class SkyTrail
{
public:
    // The rectangle to be painted again. Empty if nothing has changed.
    QRect add(const SkyPointing& place, UtcTime utc);
    QRect age(UtcTime utc);
    // Another trail, up to this time. The oldest place is first.
    QRect replace(const std::vector<SeenPlace>& places, UtcTime utc);
    void setSky(const SkyProjection& sky);

    void paint(QPainter& painter) const;

    [[nodiscard]] std::size_t length() const { return m_places.size(); }
    [[nodiscard]] const QPainterPath& pixels() const { return m_pixels; }
    // 1 at the mount, decreasing within a minute to the value of the faint line.
    [[nodiscard]] double strength(UtcTime utc) const;

private:
    struct Place
    {
        SkyPointing direction;
        UtcTime utc;
        QPointF pixel;
        bool begins;  // starts a new segment
    };

    void append(const SkyPointing& direction, UtcTime utc);
    [[nodiscard]] std::deque<Place>::const_iterator lastMinute() const;
    void rebuild();

    SkyProjection m_sky;
    std::deque<Place> m_places;  // eldest first
    QPainterPath m_pixels;
    UtcTime m_now{};
    UtcTime m_painted{};  // the time of the last fading that was painted
};

}  // namespace boresight::ui
