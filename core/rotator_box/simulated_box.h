// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"

#include <string>
#include <string_view>

// A simulated rotator at the far end of a line: bytes in, bytes out. Time is passed in.
namespace boresight {

class SimulatedBox
{
public:
    virtual ~SimulatedBox() = default;

    virtual void take(std::string_view bytes, SteadyTime now) = 0;
    // The bytes that it has sent by now.
    [[nodiscard]] virtual std::string answers(SteadyTime now) = 0;
};

}  // namespace boresight
