// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mqtt/broker.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

// The guard of an unencrypted connection in front of libmosquitto. libmosquitto keeps a packet of up to 256 MB in
// memory, and reads as long as bytes come. So it may only read a packet that is not too large. A larger packet is
// dropped, one piece at each turn of the event loop, and the connection continues. A packet is never collected in the
// buffer of the kernel, because data that was read before may fill that buffer. Not for TLS, where only libmosquitto
// sees the bytes.
namespace boresight::mqtt {

class Inlet
{
public:
    static constexpr std::size_t kLargestPacket = kLargestMessage + 4096;  // bytes, with the topic
    static constexpr std::size_t kDroppedAtOnce = 64 * 1024;               // bytes

    // True: libmosquitto may read on within one packet, or detect the end of the connection. False: wait until the
    // socket is readable again. `socket` is a connected TCP socket, at first at the beginning of a packet.
    [[nodiscard]] bool mayRead(int socket);

    // The size of a packet that is being dropped. Returned once per packet.
    [[nodiscard]] std::optional<qint64> takeDropped();

private:
    [[nodiscard]] bool judge(int socket, std::span<const std::uint8_t> ahead);
    [[nodiscard]] bool drop(int socket);

    std::optional<std::uint64_t> m_end;  // end of the packet that libmosquitto reads, in bytes of the connection
    std::size_t m_toDrop = 0;            // bytes of a too large packet that remain to be dropped
    std::optional<qint64> m_dropped;
};

// The length of the packet that begins with these bytes, with its header (MQTT 3.1.1, section 2.2). Empty while more
// bytes of the header are needed. 0 if the header is invalid: libmosquitto then reports the error. Pure.
[[nodiscard]] std::optional<std::size_t> packetLength(std::span<const std::uint8_t> bytes);

// The other side has closed the connection, or the connection is broken.
[[nodiscard]] bool hungUp(int socket);

}  // namespace boresight::mqtt
