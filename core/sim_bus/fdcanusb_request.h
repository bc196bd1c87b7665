// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/can_frame.h"

#include <string>
#include <string_view>
#include <tl/expected.hpp>

// The line protocol of an fdcanusb adapter, the device's side: lines to frames and frames to lines. Pure; lines
// without their end and without a checksum.
namespace boresight::sim {

// "can send 8001 11000f BF" and its forms `std` and `ext`. Data are padded with zeros to a legal length, as the adapter
// does. The error is the adapter's own text behind "ERR ".
[[nodiscard]] tl::expected<CanFrame, std::string> parseSendRequest(std::string_view line);

// "rcv 0100 21000A E B F r x-1", always with the flags: a client of the maker's crashes on a bare identifier.
[[nodiscard]] std::string receivedLine(const CanFrame& frame);

}  // namespace boresight::sim
