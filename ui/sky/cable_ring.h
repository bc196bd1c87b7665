// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/messages/station_status.h"
#include "ui/sky/sky_frame.h"

#include <QPainterPath>
#include <QRegion>

#include <optional>

class QPainter;

// The azimuth cable as a ring around the sky. A travel of more than 360° is drawn as a spiral, so each angle of the
// axis has its own place. The track, its ends and the zones before them stand still. The used part from 0°, where the
// cable is not wound, and the dot of the axis move. Angles are axis angles. Each is drawn at the azimuth where the beam
// then points, so the dot is beside the beam when north is set. Pixels of the widget.
namespace boresight::ui {

struct CableState
{
    TravelRange travel;                // min = max: the mount has no azimuth cable
    Angle zero;                        // the true azimuth where the axis shows 0°
    std::optional<Angle> actual;       // empty: the mount is silent, or the wrap is unknown
    std::optional<Angle> destination;  // of a slew
    bool wrapKnown = true;
    bool late = false;

    [[nodiscard]] bool isThere() const { return travel.min < travel.max; }
    bool operator==(const CableState&) const = default;
};

[[nodiscard]] CableState cableOf(const StationStatus& status);

inline constexpr Angle kCableWarning = Angle::fromDegrees(30.0);  // before each end

class CableRing
{
public:
    CableRing() = default;
    CableRing(const SkyFrame& frame, const TravelRange& travel, Angle zero = {});

    [[nodiscard]] bool isSpiral() const { return m_travel.max - m_travel.min > Angle::fromTurns(1.0); }
    [[nodiscard]] double width() const { return m_width; }  // of the track, px
    [[nodiscard]] QPointF pixel(Angle angle) const;

    void paintTrack(QPainter& painter, bool wrapKnown) const;  // on the ground
    void paintCable(QPainter& painter, const CableState& cable) const;
    // The region to be painted again after the axis has moved.
    [[nodiscard]] QRegion changed(const CableState& before, const CableState& after) const;

private:
    [[nodiscard]] double radius(Angle angle) const;
    [[nodiscard]] QPointF outwards(Angle angle) const;  // a vector of length 1
    [[nodiscard]] QPainterPath arc(Angle from, Angle to) const;
    [[nodiscard]] QRectF dotBox(Angle angle) const;
    void hatch(QPainter& painter, Angle from, Angle to) const;
    void paintEnds(QPainter& painter) const;

    SkyFrame m_frame;
    TravelRange m_travel;
    Angle m_zero;
    double m_width = 0.0;
};

}  // namespace boresight::ui
