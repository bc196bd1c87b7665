// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/can_frame.h"
#include "core/base/result.h"

#include <linux/can.h>

#include <cstddef>
#include <optional>

// Frames in the form of the kernel, in both directions, and the meaning of its error frames. Pure. Works on kernels
// without AF_CAN.
namespace boresight::socketcan {

struct RawFrame
{
    canfd_frame frame{};
    std::size_t size = 0;  // number of bytes to write or read: CAN_MTU for a classic frame, CANFD_MTU for CAN-FD
};

[[nodiscard]] Result<RawFrame> toRaw(const CanFrame& frame);

// Empty for an error frame, a remote frame or a wrong size. The caller sets the arrival time.
[[nodiscard]] std::optional<CanFrame> fromRaw(const RawFrame& raw);

[[nodiscard]] bool isErrorFrame(const RawFrame& raw);

// The content of an error frame (linux/can/error.h). Several fields may be true at once.
struct ErrorReport
{
    bool busOff = false;
    bool restarted = false;
    bool errorPassive = false;
    bool errorActive = false;      // the controller works again, perhaps with a warning
    bool noAcknowledge = false;    // no board on the bus acknowledged our frame
    bool busError = false;         // a frame was damaged on the bus
    bool receiveOverflow = false;  // the controller lost frames

    bool operator==(const ErrorReport&) const = default;
};

[[nodiscard]] ErrorReport readErrorFrame(const RawFrame& raw);

}  // namespace boresight::socketcan
