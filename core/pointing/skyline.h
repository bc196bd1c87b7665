// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/pointing/region.h"

#include <cstddef>
#include <vector>

// The horizon of a Region, prepared for fast queries: straight lines between its points, closed through north. Without
// points there is no horizon. Azimuths are unwrapped and may be on any turn. Pure values, any thread.
namespace boresight::pointing {

class Skyline
{
public:
    // Points in any order. Among several points at one azimuth the highest counts.
    explicit Skyline(const std::vector<HorizonPoint>& points);

    [[nodiscard]] bool empty() const { return m_count == 0; }
    [[nodiscard]] Angle peak() const { return m_highest; }
    [[nodiscard]] Angle at(Angle azimuth) const;
    // The highest elevation of the line between two azimuths. Requires from <= to.
    [[nodiscard]] Angle highest(Angle from, Angle to) const;
    // How far the azimuth can go clockwise or anticlockwise before the line rises above `height`. At `from` the line
    // must not be above it. Ten turns if it never rises.
    [[nodiscard]] Angle clearClockwise(Angle from, Angle height) const;
    [[nodiscard]] Angle clearAnticlockwise(Angle from, Angle height) const;

    struct Line
    {
        HorizonPoint from;
        HorizonPoint to;  // its azimuth may exceed 360°
    };
    [[nodiscard]] std::size_t lineCount() const { return m_count; }
    [[nodiscard]] Line line(std::size_t index) const
    {
        return {m_points[m_count + index], m_points[m_count + index + 1]};
    }

private:
    [[nodiscard]] std::size_t firstAfter(Angle azimuth) const;
    [[nodiscard]] Angle between(std::size_t right, Angle azimuth) const;

    std::size_t m_count = 0;
    std::vector<HorizonPoint> m_points;  // on three turns, from -360° to 720°, so that every point has both neighbours
    Angle m_highest;
};

}  // namespace boresight::pointing
