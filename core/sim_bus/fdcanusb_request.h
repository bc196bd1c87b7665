// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/can_frame.h"

#include <string>
#include <string_view>
#include <tl/expected.hpp>

// The line protocol of an fdcanusb adapter on the side of the adapter: lines to frames, and frames to lines. Pure. The
// lines are without line end and checksum.
namespace boresight::sim {

// Reads "can send 8001 11000f BF" and the forms with `std` and `ext`. Like the adapter, pads the data with zeros to a
// legal length. The error is the text of the adapter after "ERR ".
[[nodiscard]] tl::expected<CanFrame, std::string> parseSendRequest(std::string_view line);

// "rcv 0100 21000A E B F r x-1". The flags are always there, because a client of the maker crashes without them.
[[nodiscard]] std::string receivedLine(const CanFrame& frame);

}  // namespace boresight::sim
