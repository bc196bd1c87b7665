// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/can_frame.h"

#include <cstdint>
#include <span>

// Sender and receiver of a frame: the layout of the CAN identifier. Bits 28..16 prefix, bit 15 "reply wanted", bits
// 14..8 source, bits 6..0 destination. Pure values, any thread.
namespace boresight::moteus {

inline constexpr std::uint8_t kBroadcastId = 0x7f;  // every drive accepts it
inline constexpr std::uint8_t kHostId = 0;          // our source id, the same as that of the maker's clients
inline constexpr std::uint16_t kMaxPrefix = 0x1fff;

struct Arbitration
{
    std::uint16_t prefix = 0;
    bool replyWanted = false;
    std::uint8_t source = kHostId;
    std::uint8_t destination = 1;

    bool operator==(const Arbitration&) const = default;
};

// Bits beyond the width of a field (13, 7, 7 bits) are dropped.
[[nodiscard]] std::uint32_t toCanId(const Arbitration& arbitration);
[[nodiscard]] Arbitration fromCanId(std::uint32_t id);

// A drive accepts a frame if the low eight bits are its own id or the broadcast id, and the prefix matches.
[[nodiscard]] bool isAddressedTo(std::uint32_t id, std::uint8_t device, std::uint16_t prefix);

// The frame for the bus: extended if the identifier needs it, padded with NOP (0x50) to a legal length. payload.size()
// <= 64.
[[nodiscard]] CanFrame makeFrame(const Arbitration& arbitration, std::span<const std::uint8_t> payload);

}  // namespace boresight::moteus
