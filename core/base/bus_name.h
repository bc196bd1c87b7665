// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"

#include <cstdint>
#include <string>
#include <string_view>

// The name of a bus as the user writes it, on the command line or in the profile: "simulated", "socketcan:can0",
// "fdcanusb:/dev/boresight/fdcanusb", "serial:/dev/ttyUSB0", "tcp:rotator.local:4001",
// "rotctld:10.0.0.7:4533", "hamlib:901:/dev/ttyUSB0".
namespace boresight {

enum class BusKind
{
    Simulated,
    SocketCan,
    Fdcanusb,
    Serial,  // a control box with a text protocol
    Tcp,
    Rotctld,  // a rotctld on a host
    Hamlib,   // a Hamlib model, driven by a rotctld that Boresight starts
};

struct BusName
{
    BusKind kind = BusKind::Simulated;
    std::string target;      // interface, path or host; empty for the simulated bus
    std::uint16_t port = 0;  // of the host
    int model = 0;           // of Hamlib

    bool operator==(const BusName&) const = default;
};

[[nodiscard]] Result<BusName> parseBusName(std::string_view text);
[[nodiscard]] std::string toString(const BusName& bus);

}  // namespace boresight
