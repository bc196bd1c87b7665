// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mqtt/broker.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

// What a broker sends without encryption, before libmosquitto reads it. libmosquitto keeps a packet of up to 256 MB in
// memory and reads as long as bytes come. So it may only read a packet that is not too large; a larger one is thrown
// away, a piece at each turn of the event loop, and the connection goes on. A packet is never waited for in the kernel:
// its buffer may be full of what was read before. Not for TLS, where only libmosquitto sees the bytes.
namespace boresight::mqtt {

class Inlet
{
public:
    static constexpr std::size_t kLargestPacket = kLargestMessage + 4096;  // bytes: with its topic
    static constexpr std::size_t kDroppedAtOnce = 64 * 1024;               // bytes

    // True: libmosquitto may read on in one packet, or find out that the connection is at its end. False: nothing more
    // to do until the socket is readable again. `socket` is a connected TCP socket, at first at the beginning of a
    // packet.
    [[nodiscard]] bool mayRead(int socket);

    // The size of a packet that is being thrown away, once for each.
    [[nodiscard]] std::optional<qint64> takeDropped();

private:
    [[nodiscard]] bool judge(int socket, std::span<const std::uint8_t> ahead);
    [[nodiscard]] bool drop(int socket);

    std::optional<std::uint64_t> m_end;  // of the packet that libmosquitto reads, in bytes of the connection
    std::size_t m_toDrop = 0;            // bytes of a packet that is too large
    std::optional<qint64> m_dropped;
};

// The length of the packet that begins with these bytes, its header included, as MQTT 3.1.1 has it in section 2.2.
// Empty while more of the header is needed. A header that is none has a length of 0: libmosquitto says what is wrong.
// Pure.
[[nodiscard]] std::optional<std::size_t> packetLength(std::span<const std::uint8_t> bytes);

// The other side has closed the connection, or it is broken.
[[nodiscard]] bool hungUp(int socket);

}  // namespace boresight::mqtt
