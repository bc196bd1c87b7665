// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"
#include "core/control/control_parts.h"
#include "core/motion/first_moves.h"

// Keeps free motions slow and short until a person has confirmed which way the axes turn. Admits a motion before it
// starts, and judges it while it runs. Station thread only.
namespace boresight {

class FirstMovesGuard
{
public:
    [[nodiscard]] Result<> admits(const ControlParts& of, const AxisRates& rates);
    // The free motion that runs would stop beyond the small way.
    [[nodiscard]] bool exceeded(const ControlParts& of) const;
    // The small way begins where the mount stands now.
    void beginAnew() { m_moves = {}; }

private:
    FirstMoves m_moves;
};

}  // namespace boresight
