// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"
#include "core/control/control_parts.h"
#include "core/motion/first_moves.h"

// Keeps free motions slow and short until a person has confirmed in which direction the axes turn. Checks a motion
// before it starts and while it runs. Station thread only.
namespace boresight {

class FirstMovesGuard
{
public:
    [[nodiscard]] Result<> admits(const ControlParts& of, const AxisRates& rates);
    // The motion that runs would stop outside the permitted small range.
    [[nodiscard]] bool exceeded(const ControlParts& of) const;
    // How far beside its set-point an axis may stand. Empty before the directions are confirmed, because it would leave
    // the permitted small range.
    [[nodiscard]] static std::optional<Motion::Band> band(const profile::Profile& profile,
                                                          const pointing::Antenna& antenna);
    // The permitted small range begins where the mount stands at this call.
    void beginAnew() { m_moves = {}; }

private:
    FirstMoves m_moves;
};

}  // namespace boresight
