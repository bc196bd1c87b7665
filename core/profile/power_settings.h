// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

// The line by which a receiver reports the power that it receives. Plain values.
namespace boresight::profile {

enum class PowerSource
{
    None,
    Udp,  // datagrams that arrive at host:port, an address of this computer
    Tcp   // the program that listens at host:port
};

struct PowerSettings
{
    PowerSource source = PowerSource::None;
    std::string host = "127.0.0.1";
    int port = 4540;

    bool operator==(const PowerSettings&) const = default;
};

}  // namespace boresight::profile
