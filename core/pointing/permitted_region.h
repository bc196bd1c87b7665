// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/pointing/axis_box.h"
#include "core/pointing/pointing_model.h"
#include "core/pointing/region.h"
#include "core/pointing/skyline.h"
#include "core/units/sky.h"

#include <QString>

#include <vector>

// Where the axes may be: a Region and the travel of both axes, laid out in mechanical angles for quick answers, for
// every turn of the azimuth and for elevations above 90°, where the beam looks to azimuth + 180°, 180° - elevation.
// Horizon and keep-outs are true directions: a pointing model computes where the axes meet them (axis_image.h). Edges
// are permitted where one can move along them (slits.h); rounding of 1e-9° is forgiven. Pure values, any thread.
namespace boresight::pointing {

class PermittedRegion
{
public:
    PermittedRegion(const Region& region, const TravelRange& azimuthTravel, const TravelRange& elevationTravel,
                    const PointingModel& pointing = {});

    // What travel and limits of operation leave of the axes; min > max if they have nothing in common.
    [[nodiscard]] const AxisBox& ranges() const { return m_ranges; }
    [[nodiscard]] bool permits(const AxisPosition& place) const { return permits(AxisBox::at(place)); }
    [[nodiscard]] bool permits(const AxisBox& box) const;  // all of it
    // Why a place is not permitted, in words: `315.0° / 10.0° lies in keep-out "mast"`. Else empty.
    [[nodiscard]] QString reason(const AxisPosition& place) const;
    // The keep-out, the horizon or the limit that a place is not permitted for: `the keep-out "mast"`. Else empty.
    [[nodiscard]] QString obstacle(const AxisPosition& place) const;

    // How far a permitted box can be widened along one axis, the other as it is.
    [[nodiscard]] TravelRange azimuthsAround(const AxisBox& box) const;
    [[nodiscard]] TravelRange elevationsAround(const AxisBox& box) const;

    // What the beam looks at; the turn and the side of the zenith are those of the axes.
    [[nodiscard]] SkyPointing beamAt(const AxisPosition& place) const { return m_pointing.toSky(place); }

    [[nodiscard]] bool hasHorizon() const { return !m_horizon.empty(); }
    // The horizon as the axes meet it, and its image over the top, turned by 180° and with 180° - elevation.
    [[nodiscard]] const Skyline& horizon() const { return m_upright; }
    [[nodiscard]] const Skyline& overTheTop() const { return m_overTheTop; }
    // The horizon under these azimuths; its image over the top, which a beam that looks backwards has to stay below.
    [[nodiscard]] Angle floor(const TravelRange& azimuths) const;
    [[nodiscard]] Angle ceiling(const TravelRange& azimuths) const;
    // The keep-outs as the axes see them, one for each turn and side of the zenith that can be reached.
    [[nodiscard]] const std::vector<AxisBox>& keepOuts() const { return m_boxes; }

private:
    void layOut(const AxisBox& box, std::size_t index);
    void add(AxisBox box, std::size_t index);
    void closeSlits();
    void dropCovered();
    [[nodiscard]] const KeepOut* keepOutAt(const AxisPosition& place) const;
    [[nodiscard]] QString trueReason(const AxisPosition& place) const;

    PointingModel m_pointing;
    AxisBox m_ranges;
    Skyline m_horizon;  // true
    Skyline m_upright;  // as the axes meet it
    Skyline m_overTheTop;
    std::vector<KeepOut> m_keepOuts;
    std::vector<AxisBox> m_boxes;
    std::vector<std::size_t> m_owner;  // of each box, into m_keepOuts; beyond its end: the horizon
};

}  // namespace boresight::pointing
