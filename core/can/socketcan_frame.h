// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/can_frame.h"
#include "core/base/result.h"

#include <linux/can.h>

#include <cstddef>
#include <optional>

// The kernel's form of a frame, both ways, and the meaning of its error frames. Pure; works on kernels without AF_CAN.
namespace boresight::socketcan {

struct RawFrame
{
    canfd_frame frame{};
    std::size_t size = 0;  // CAN_MTU for a classic frame, CANFD_MTU for CAN-FD: what is written or was read
};

[[nodiscard]] Result<RawFrame> toRaw(const CanFrame& frame);

// Nothing for an error frame, a remote frame or a size that neither kind has. The arrival time is left to the caller.
[[nodiscard]] std::optional<CanFrame> fromRaw(const RawFrame& raw);

[[nodiscard]] bool isErrorFrame(const RawFrame& raw);

// The content of an error frame (linux/can/error.h). Several may be true at once.
struct ErrorReport
{
    bool busOff = false;
    bool restarted = false;
    bool errorPassive = false;
    bool errorActive = false;      // the controller is well again, or only warns
    bool noAcknowledge = false;    // nobody on the bus acknowledged our frame
    bool busError = false;         // a frame was damaged on the wire
    bool receiveOverflow = false;  // the controller lost frames

    bool operator==(const ErrorReport&) const = default;
};

[[nodiscard]] ErrorReport readErrorFrame(const RawFrame& raw);

}  // namespace boresight::socketcan
