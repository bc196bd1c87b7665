// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/can_frame.h"
#include "core/moteus/codec.h"
#include "core/moteus/subframes.h"

#include <string>

// Frames in words, for people reading logs and `boresightctl decode`: who speaks to whom, then one line for every
// register, error, tunnel packet and run of padding. Never fails: what cannot be read is said to be so. Pure.
namespace boresight::moteus {

// Several lines, each ended by LF. The first: "request from 0 to drive 1, wants a reply" or "reply of drive 1 to 0".
[[nodiscard]] std::string describe(const CanFrame& frame);

// "position 0.25 rev (f32)", "mode 10 position (i8)", "velocity limit unset (i16)".
[[nodiscard]] std::string describe(const RegisterValue& item);

// As the maker writes them: 8-4-4-4-12 digits in the order of the bytes; a word has its lowest byte first.
[[nodiscard]] std::string uuidText(const Uuid& uuid);

// "1.2.3" for 0x010203 in register 0x101; "?" if the reply does not have it.
[[nodiscard]] std::string firmwareText(const Reply& reply);

}  // namespace boresight::moteus
