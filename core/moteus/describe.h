// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/can_frame.h"
#include "core/moteus/codec.h"
#include "core/moteus/subframes.h"

#include <string>

// Frames in words, for logs and for `boresightctl decode`: sender and receiver, then one line for every register,
// error, tunnel packet and run of padding. Never fails: unreadable parts are reported as unreadable. Pure.
namespace boresight::moteus {

// Several lines, each with LF at its end. The first is "request from 0 to drive 1, wants a reply" or "reply of drive 1
// to 0".
[[nodiscard]] std::string describe(const CanFrame& frame);

// "position 0.25 rev (f32)", "mode 10 position (i8)", "velocity limit unset (i16)".
[[nodiscard]] std::string describe(const RegisterValue& item);

// In the form of the maker: 8-4-4-4-12 digits in the order of the bytes. The lowest byte of a word comes first.
[[nodiscard]] std::string uuidText(const Uuid& uuid);

// "1.2.3" for 0x010203 in register 0x101. "?" if the reply does not contain the register.
[[nodiscard]] std::string firmwareText(const Reply& reply);

}  // namespace boresight::moteus
