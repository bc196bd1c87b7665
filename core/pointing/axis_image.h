// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/pointing/axis_box.h"
#include "core/pointing/pointing_model.h"
#include "core/pointing/region.h"
#include "core/pointing/skyline.h"

#include <vector>

// Horizon and keep-outs are true directions; here they become what the axes have to stay out of. Offsets move them
// exactly. What leans or is not square bends their edges: then they are enclosed, by boxes and by a line above, so that
// nothing true is lost, and hardly more is forbidden than is true (METHOD.md). Near the zenith, where a small lean
// turns the azimuth by much, a cap is taken as a whole when anything forbidden reaches into it. Pure values, any
// thread.
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

    // Boxes that hold all of a keep-out, upright and over the top, on one turn each; those that go all round are a full
    // turn wide or more.
    [[nodiscard]] std::vector<AxisBox> of(const KeepOut& keepOut) const;
    // The horizon as a line that the axes stay above. Over the top they stay below one: it is given as its image,
    // turned by 180° and with 180° - elevation.
    [[nodiscard]] std::vector<HorizonPoint> of(const Skyline& horizon, Side side) const;
    // The cap of the zenith that goes with a horizon which reaches into it.
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
    TravelRange m_tame;  // the elevations between the caps
};

}  // namespace boresight::pointing
