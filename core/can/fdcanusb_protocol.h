// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/can_frame.h"
#include "core/base/result.h"

#include <string>
#include <string_view>
#include <variant>

// The text protocol of the mjbots fdcanusb and mjcanfd-usb-1x adapters, the client's side: frames to lines, lines to
// answers. Pure. Lines are without their end and, on the way out, without a checksum (core/can/line_checksum.h).
namespace boresight::fdcanusb {

// "can send 8001 11000f BF". The payload is padded with 0x50 (a moteus NOP): left to itself the adapter pads with
// zeros, and a zero opens a write subframe. An empty payload becomes one 0x50, since the adapter refuses no data.
// Refused: more than 29 identifier bits, a classic frame of more than 8 bytes.
[[nodiscard]] Result<std::string> sendLine(const CanFrame& frame);

inline constexpr std::string_view kBusOnLine = "can on";
inline constexpr std::string_view kBusOffLine = "can off";
inline constexpr std::string_view kBusStatusLine = "can status";

// What a line from the adapter means.
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
struct RemoteFrame  // received, but of no use: moteus neither sends nor answers them
{};
struct Unreadable  // not of this protocol, damaged, or the checksum is wrong or missing
{};
using Answer = std::variant<CanFrame, Accepted, Refusal, BusStatus, RemoteFrame, Unreadable>;

enum class ChecksumRule
{
    VerifyIfPresent,
    Require,
};

// The arrival time of a frame is left to the caller.
[[nodiscard]] Answer parseAnswer(std::string_view line, ChecksumRule rule = ChecksumRule::VerifyIfPresent);

}  // namespace boresight::fdcanusb
