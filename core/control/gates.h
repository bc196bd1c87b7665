// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"
#include "core/control/control_parts.h"
#include "core/messages/station_status.h"

// May it move now, whatever moves it? Each gate gives the reason in words. Reads the parts of the control and changes
// nothing. Station thread only.
namespace boresight {

class Gates
{
public:
    explicit Gates(const ControlParts& parts) : m_of(parts) {}

    // Whether this source has the control, as far as the operator and the other clients are concerned.
    [[nodiscard]] Result<> mayCommand(const Source& source) const;
    [[nodiscard]] Result<> mayMove(const Source& source) const;   // armed, and no proof is running
    [[nodiscard]] Result<> mayPoint(const Source& source) const;  // anywhere
    [[nodiscard]] Result<> mayJog(const AxisRates& rates, const Source& source) const;  // or is jogged slowly
    [[nodiscard]] Result<> axesPlaced() const;  // each on a wrap that is known, and not far outside its travel
    // While the clock is doubted: from where the Sun can be only the operator's slow jog leads out.
    [[nodiscard]] Result<> mayLeaveSunBand(const AxisRates& rates, const Source& source) const;
    [[nodiscard]] bool isInSunBand(const AxisPosition& place) const;
    [[nodiscard]] Result<> drivesRest() const;  // for what is done to the drives themselves
    [[nodiscard]] Result<> mayGiveControl() const;
    // Whether other terms of the pointing model would leave the motion what it is.
    [[nodiscard]] Result<> mayChangePointing() const;

    // Outside its travel by more than the drives' own bounds allow: 1 above, -1 below; 0 inside, or nobody knows.
    [[nodiscard]] int farOutside(Axis axis) const;

private:
    [[nodiscard]] Result<> mayJogSlowly(const AxisRates& rates) const;
    [[nodiscard]] Result<> insideTravel() const;

    ControlParts m_of;
};

}  // namespace boresight
