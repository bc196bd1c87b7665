// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/orientation/orientation.h"
#include "core/orientation/refusal.h"

#include <string>
#include <string_view>

// One sentence of the sensor's serial line, in its three forms: "$PATRK,…" (firmware since March 2026), "$PANT,TRK,…"
// with the temperature, and the oldest without. Pure.
//
//   $ head ts ,ms, az ,dd, el ,dd, revs ,revs, [ temp ,c, ] sys , gyro , acc , mag *HH
//
// HH is the XOR of all characters between '$' and '*'. More fields behind the last one are kept as text: a firmware
// that knows more still says what this one says.
namespace boresight::orientation {

// Whether it begins like one of ours; everything else on the line is somebody else's.
[[nodiscard]] bool isOurs(std::string_view sentence);

// `sentence` from its '$' on, without the line's end.
[[nodiscard]] Parsed<Orientation> parseSentence(std::string_view sentence, SteadyTime arrival);

// Of the two digits: lower case is not what the firmware writes, but means the same.
[[nodiscard]] bool hasLowerCaseChecksum(std::string_view sentence);

// "$…*HH" around a body; also for the simulated sensor.
[[nodiscard]] std::string withChecksum(std::string_view body);

}  // namespace boresight::orientation
