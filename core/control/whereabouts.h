// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"
#include "core/control/control_parts.h"

#include <optional>

// Where the axes and the beam are, and where they go. Reads the parts of the control and changes nothing. Station
// thread only.
namespace boresight {

class Whereabouts
{
public:
    explicit Whereabouts(const ControlParts& parts) : m_of(parts) {}

    // The measured axis angles. An error when they are unknown or older than 1 s.
    [[nodiscard]] Result<AxisPosition> measured() const;
    // Where the beam of the antenna in use points. Empty when that is unknown or older than 1 s.
    [[nodiscard]] std::optional<SkyPointing> direction() const;
    // The same with other terms of the pointing model.
    [[nodiscard]] std::optional<SkyPointing> directionBy(const pointing::PointingTerms& terms) const;
    // The trim that is added to the targets of the client that is followed.
    [[nodiscard]] std::optional<AxisPosition> trimInUse() const;
    // The axis angles for the last point of the stream: the point itself, or the nearest permitted place.
    [[nodiscard]] std::optional<AxisPosition> streamGoal() const;
    // Where the axes go, without the trim. If they go nowhere: where they stop or stand.
    [[nodiscard]] AxisPosition untrimmedGoal() const;
    // The end of the azimuth where the mount waits, because its target is limited or the operator chose to hold there.
    // Empty: it does not wait at an end.
    [[nodiscard]] std::optional<Angle> cableEnd() const;

private:
    ControlParts m_of;
};

}  // namespace boresight
