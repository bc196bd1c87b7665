// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

// The report of the kernel about a network interface over rtnetlink, as far as it concerns a CAN bus: builds the bytes
// of the query and reads the bytes of the answer (linux/rtnetlink.h, linux/can/netlink.h; all in the byte order of this
// machine). Pure. Works on kernels without AF_CAN. Values that are not reported stay empty: a virtual interface has no
// bit timing.
namespace boresight::socketcan {

enum class ControllerState  // CAN_STATE_…
{
    Active,
    Warning,
    Passive,
    BusOff,
    Stopped,
    Sleeping,
};

struct PhaseTiming
{
    std::uint32_t bitRate = 0;  // bit/s; 0: not set
    double samplePoint = 0.0;   // 0…1; 0: not reported

    bool operator==(const PhaseTiming&) const = default;
};

struct ErrorCounters
{
    std::uint16_t transmit = 0;
    std::uint16_t receive = 0;

    bool operator==(const ErrorCounters&) const = default;
};

struct InterfaceReport
{
    int index = 0;
    std::string name;
    bool up = false;
    std::string kind;  // "can" for every adapter, "vcan" and "vxcan" for virtual ones
    std::optional<PhaseTiming> nominal;
    std::optional<PhaseTiming> data;
    std::optional<bool> flexibleData;  // CAN-FD is on
    std::optional<ControllerState> controller;
    std::optional<ErrorCounters> errors;

    bool operator==(const InterfaceReport&) const = default;
};

// RTM_GETLINK for one interface.
[[nodiscard]] std::vector<std::uint8_t> interfaceQuestion(int index, std::uint32_t sequence);

// Reads one RTM_NEWLINK message. A refusal by the kernel, or a cut or contradictory message, is an error.
[[nodiscard]] Result<InterfaceReport> readInterfaceAnswer(std::span<const std::uint8_t> message);

}  // namespace boresight::socketcan
