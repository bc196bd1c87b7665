// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/can_frame.h"
#include "core/base/result.h"

#include <string>
#include <string_view>
#include <variant>

// The text protocol of the mjbots fdcanusb and mjcanfd-usb-1x adapters on the side of the client: frames to lines,
// lines to answers. Pure. Lines are without line end. Lines to the adapter are without checksum
// (core/can/line_checksum.h).
namespace boresight::fdcanusb {

// "can send 8001 11000f BF". The payload is padded with 0x50 (a moteus NOP). The adapter itself would pad with zeros,
// and a zero begins a write subframe. An empty payload becomes one 0x50, because the adapter refuses an empty one.
// Refused: an identifier of more than 29 bits, and a classic frame of more than 8 bytes.
[[nodiscard]] Result<std::string> sendLine(const CanFrame& frame);

inline constexpr std::string_view kBusOnLine = "can on";
inline constexpr std::string_view kBusOffLine = "can off";
inline constexpr std::string_view kBusStatusLine = "can status";

// The meaning of a line from the adapter.
struct Accepted  // "OK": the command is queued, not delivered
{};
struct Refusal  // "ERR …"
{
    std::string text;
    [[nodiscard]] bool notOnBus() const { return text.starts_with("not in BusOn"); }
};
struct BusStatus  // "lec=… dlec=… err=… warn=… busoff=…", the answer to "can status"
{
    bool busOff = false;
    bool errorPassive = false;
};
struct RemoteFrame  // received, but not used: moteus neither sends nor answers remote frames
{};
struct Unreadable  // not of this protocol, damaged, or the checksum is wrong or missing
{};
using Answer = std::variant<CanFrame, Accepted, Refusal, BusStatus, RemoteFrame, Unreadable>;

enum class ChecksumRule
{
    VerifyIfPresent,
    Require,
};

// The caller sets the arrival time of a frame.
[[nodiscard]] Answer parseAnswer(std::string_view line, ChecksumRule rule = ChecksumRule::VerifyIfPresent);

}  // namespace boresight::fdcanusb
