// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"

#include <QString>

#include <cstdint>
#include <string>

// The source of wind readings, by its name in the profile. Pure, any thread.
namespace boresight::wind {

enum class SourceKind
{
    None,
    Udp,   // UDP messages to host:port, an address of this computer
    Mqtt,  // a topic of the broker
    Page   // a page of a web server, read again and again
};

struct SourceName
{
    SourceKind kind = SourceKind::None;
    QString place = {};  // host, topic or address of the page
    std::uint16_t port = 0;

    bool operator==(const SourceName&) const = default;
};

// Reads "udp:4541", "udp:0.0.0.0:4541", "mqtt:shack/wind" or "http://anemometer/wind". Without a host it is 127.0.0.1.
// An empty text means no source.
[[nodiscard]] Result<SourceName> parseSource(const std::string& text);

}  // namespace boresight::wind
