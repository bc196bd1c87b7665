// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/pointing/axis_box.h"
#include "core/pointing/pointing_model.h"
#include "core/pointing/region.h"
#include "core/pointing/skyline.h"

#include <vector>

// Horizon and keep-outs are true directions. This class converts them into the axis angles that are forbidden. Offsets
// move them exactly. Tilt, collimation and non-perpendicularity bend their edges. Then boxes and a line above the
// horizon enclose them, so nothing forbidden is lost, and little more is forbidden (METHOD.md). Near the zenith a small
// lean turns the azimuth by much. So the whole cap of the zenith is forbidden if any forbidden part reaches into it.
// Pure values, any thread.
namespace boresight::pointing {

enum class Side
{
    Upright,
    OverTheTop
};

class AxisImage
{
public:
    explicit AxisImage(const PointingModel& model);

    // Boxes that contain a whole keep-out, upright and over the top, each on one turn. A keep-out that goes all round
    // gets boxes of a full turn or more.
    [[nodiscard]] std::vector<AxisBox> of(const KeepOut& keepOut) const;
    // The horizon as a line that the axes must stay above. Over the top they must stay below a line, which is the image
    // turned by 180° and with 180° - elevation.
    [[nodiscard]] std::vector<HorizonPoint> of(const Skyline& horizon, Side side) const;
    // The cap of the zenith, if the horizon reaches into it.
    [[nodiscard]] std::vector<AxisBox> capOf(const Skyline& horizon) const;

private:
    [[nodiscard]] AxisPosition place(const SkyPointing& beam, Side side) const;
    [[nodiscard]] std::vector<AxisBox> shifted(const TravelRange& azimuths, const TravelRange& elevations) const;
    [[nodiscard]] std::vector<AxisBox> enclosed(const TravelRange& azimuths, const TravelRange& elevations) const;
    [[nodiscard]] AxisBox enclosing(const TravelRange& azimuths, const TravelRange& elevations, Side side) const;
    [[nodiscard]] std::vector<TravelRange> columns(const TravelRange& azimuths) const;
    [[nodiscard]] std::vector<TravelRange> rows(const TravelRange& elevations) const;
    [[nodiscard]] AxisBox zenithCap(Angle from) const;
    [[nodiscard]] AxisBox nadirCap(Side side) const;
    [[nodiscard]] HorizonPoint lineAt(const HorizonPoint& truth, Side side) const;
    void trace(std::vector<HorizonPoint>& line, const HorizonPoint& from, const HorizonPoint& to, Side side,
               int depth) const;

    PointingModel m_model;
    Angle m_skew;
    TravelRange m_tame;  // the elevations between the two caps
};

}  // namespace boresight::pointing
