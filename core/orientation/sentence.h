// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/orientation/orientation.h"
#include "core/orientation/refusal.h"

#include <string>
#include <string_view>

// One sentence of the sensor's serial line, in its three forms: "$PATRK,…" (firmware since March 2026), "$PANT,TRK,…"
// with the temperature, and the oldest form without. Pure.
//
//   $ head ts ,ms, az ,dd, el ,dd, revs ,revs, [ temp ,c, ] sys , gyro , acc , mag *HH
//
// HH is the XOR of all characters between '$' and '*'. Fields after the last one are kept as text, so that sentences of
// a newer firmware with more fields can still be read.
namespace boresight::orientation {

// True if the sentence begins like one of this sensor. Other sentences on the line belong to other devices.
[[nodiscard]] bool isOurs(std::string_view sentence);

// `sentence` begins with its '$' and has no line end.
[[nodiscard]] Parsed<Orientation> parseSentence(std::string_view sentence, SteadyTime arrival);

// Whether a checksum digit is in lower case. The firmware does not write lower case, but the value is the same.
[[nodiscard]] bool hasLowerCaseChecksum(std::string_view sentence);

// Makes "$…*HH" of a body. The simulated sensor uses it, too.
[[nodiscard]] std::string withChecksum(std::string_view body);

}  // namespace boresight::orientation
