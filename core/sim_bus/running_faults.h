// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"
#include "core/base/result.h"
#include "core/units/sky.h"

#include <QString>

#include <functional>
#include <string_view>

// Shows faults on the simulated mount of a running program, as a person asks for them. Station thread only.
namespace boresight {

struct SimulatedMount;

// Ends every fault that was asked for.
inline constexpr std::string_view kEndFaults = "end";

// `text` is a fault as core/sim/injection_option.h reads it, for example "wind az:30Nm@5+3", or kEndFaults. START
// counts from now. `axes` are the axes that the simulated mount turns. Returns what begins, in words.
[[nodiscard]] Result<QString> showFault(SimulatedMount& mount, const Clock& clock, AxisSet axes, std::string_view text);

// The same for the mount of one station.
using ShowFault = std::function<Result<QString>(std::string_view text)>;

// What a real mount answers.
[[nodiscard]] tl::unexpected<Error> noFaultOfARealMount();

}  // namespace boresight
