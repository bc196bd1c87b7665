// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"

#include <string>
#include <string_view>

// The name of a bus as the user writes it, on the command line or in the profile: "simulated", "socketcan:can0",
// "fdcanusb:/dev/boresight/fdcanusb".
namespace boresight {

enum class BusKind
{
    Simulated,
    SocketCan,
    Fdcanusb,
};

struct BusName
{
    BusKind kind = BusKind::Simulated;
    std::string target;  // interface or path; empty for the simulated bus

    bool operator==(const BusName&) const = default;
};

[[nodiscard]] Result<BusName> parseBusName(std::string_view text);
[[nodiscard]] std::string toString(const BusName& bus);

}  // namespace boresight
