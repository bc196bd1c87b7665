// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/pointing/axis_box.h"
#include "core/pointing/pointing_model.h"
#include "core/pointing/region.h"
#include "core/pointing/skyline.h"
#include "core/units/sky.h"

#include <QString>

#include <vector>

// Where the axes may be: a Region and the travel of both axes in mechanical angles, prepared for fast queries. It
// covers every turn of the azimuth and elevations above 90°, where the beam points to azimuth + 180°, 180° - elevation.
// Horizon and keep-outs are true directions, which axis_image.h converts to axis angles, and xy_image.h to X and Y,
// which have no turns and no second side. Edges are permitted where the axes can move along them (slits.h). Rounding of
// 1e-9° is tolerated. Pure values, any thread.
namespace boresight::pointing {

class PermittedRegion
{
public:
    PermittedRegion(const Region& region, const TravelRange& azimuthTravel, const TravelRange& elevationTravel,
                    const PointingModel& pointing = {});

    // The ranges that travel and soft limits leave to the axes. min > max if travel and limits do not overlap.
    [[nodiscard]] const AxisBox& ranges() const { return m_ranges; }
    [[nodiscard]] bool permits(const AxisPosition& place) const { return permits(AxisBox::at(place)); }
    [[nodiscard]] bool permits(const AxisBox& box) const;  // the whole box
    // Why a place is not permitted, for example `315.0° / 10.0° lies in keep-out "mast"`. Empty if it is permitted.
    [[nodiscard]] QString reason(const AxisPosition& place) const;
    // The keep-out, horizon or limit that forbids a place, for example `the keep-out "mast"`. Empty if it is permitted.
    [[nodiscard]] QString obstacle(const AxisPosition& place) const;

    // How far a permitted box can be widened along one axis without a change of the other.
    [[nodiscard]] TravelRange azimuthsAround(const AxisBox& box) const;
    [[nodiscard]] TravelRange elevationsAround(const AxisBox& box) const;

    // The direction of the beam. Keeps the turn and the side of the zenith of the axes.
    [[nodiscard]] SkyPointing beamAt(const AxisPosition& place) const { return m_pointing.toSky(place); }

    // False for X and Y, where boxes stand for the horizon.
    [[nodiscard]] bool hasHorizonLine() const { return !m_upright.empty(); }
    // The horizon in axis angles, and its image over the top, turned by 180° and with 180° - elevation.
    [[nodiscard]] const Skyline& horizon() const { return m_upright; }
    [[nodiscard]] const Skyline& overTheTop() const { return m_overTheTop; }
    // floor(): the highest horizon at these azimuths. ceiling(): the elevation below which a beam over the top must
    // stay.
    [[nodiscard]] Angle floor(const TravelRange& azimuths) const;
    [[nodiscard]] Angle ceiling(const TravelRange& azimuths) const;
    // The keep-outs in axis angles, one for each reachable turn and side of the zenith. For X and Y also the horizon.
    [[nodiscard]] const std::vector<AxisBox>& keepOuts() const { return m_boxes; }

private:
    void layOutAzimuthElevation();
    void layOutXY();
    void layOut(const AxisBox& box, std::size_t index);
    void add(AxisBox box, std::size_t index);
    void closeSlits();
    void dropCovered();
    [[nodiscard]] const KeepOut* keepOutAt(const AxisPosition& place) const;
    [[nodiscard]] QString trueReason(const AxisPosition& place) const;

    PointingModel m_pointing;
    AxisBox m_ranges;
    Skyline m_horizon;  // true
    Skyline m_upright;  // in axis angles
    Skyline m_overTheTop;
    std::vector<KeepOut> m_keepOuts;
    std::vector<AxisBox> m_boxes;
    std::vector<std::size_t> m_owner;  // of each box: index into m_keepOuts; an index beyond its end: the horizon
};

}  // namespace boresight::pointing
