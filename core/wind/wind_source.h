// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"

#include <QString>

#include <cstdint>
#include <string>

// Where readings of the wind come from, by its name in the profile. Pure, any thread.
namespace boresight::wind {

enum class SourceKind
{
    None,
    Udp,   // whoever sends to host:port, an address of this computer
    Mqtt,  // a topic of the broker
    Page   // of a web server, again and again
};

struct SourceName
{
    SourceKind kind = SourceKind::None;
    QString place = {};  // host, topic or address of the page
    std::uint16_t port = 0;

    bool operator==(const SourceName&) const = default;
};

// "udp:4541", "udp:0.0.0.0:4541", "mqtt:shack/wind", "http://anemometer/wind". Without a host it is 127.0.0.1. Empty:
// none.
[[nodiscard]] Result<SourceName> parseSource(const std::string& text);

}  // namespace boresight::wind
