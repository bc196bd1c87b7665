// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/pointing/region.h"

#include <cstddef>
#include <vector>

// The horizon of a Region, laid out for quick answers: straight lines between its points, closed through north. Without
// points it is nowhere in the way. Azimuths are unwrapped; any turn may be asked about. Pure values, any thread.
namespace boresight::pointing {

class Skyline
{
public:
    // Points in any order; of several at one azimuth the highest counts.
    explicit Skyline(const std::vector<HorizonPoint>& points);

    [[nodiscard]] bool empty() const { return m_count == 0; }
    [[nodiscard]] Angle peak() const { return m_highest; }
    [[nodiscard]] Angle at(Angle azimuth) const;
    // The highest elevation of the line between two azimuths, from <= to.
    [[nodiscard]] Angle highest(Angle from, Angle to) const;
    // How far one can go clockwise, or anticlockwise, before the line rises above a height that it is not above at
    // `from`; ten turns if it never does.
    [[nodiscard]] Angle clearClockwise(Angle from, Angle height) const;
    [[nodiscard]] Angle clearAnticlockwise(Angle from, Angle height) const;

    struct Line
    {
        HorizonPoint from;
        HorizonPoint to;  // its azimuth may be beyond 360°
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
    std::vector<HorizonPoint> m_points;  // three turns of them, from -360° to 720°, so that both neighbours are there
    Angle m_highest;
};

}  // namespace boresight::pointing
