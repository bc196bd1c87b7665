// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"

#include <string>
#include <tuple>

// A balloon or a rocket that reports its position. Plain values.
namespace boresight::profile {

enum class PositionSource
{
    None,
    Udp,  // datagrams that arrive at host:port, an address of this computer
    Mqtt  // a topic of the broker
};

struct PositionSettings
{
    PositionSource source = PositionSource::None;
    std::string host = "127.0.0.1";
    int port = 55673;  // the port to which radiosonde_auto_rx sends
    std::string topic = "position";
    std::string name;  // call sign of the balloon or rocket; empty: any
    Seconds stale{30.0};
    double fastest = 2000.0;  // m/s

    [[nodiscard]] bool reads(const std::string& ofBroker) const
    {
        return source == PositionSource::Mqtt && ofBroker == topic;
    }
    bool operator==(const PositionSettings&) const = default;
    [[nodiscard]] bool comesFromWhere(const PositionSettings& other) const
    {
        return std::tie(source, host, port, topic) == std::tie(other.source, other.host, other.port, other.topic);
    }
};

}  // namespace boresight::profile
