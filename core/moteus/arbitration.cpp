// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/moteus/arbitration.h"

#include "core/moteus/subframe_types.h"

#include <algorithm>

namespace boresight::moteus {
namespace {

constexpr std::uint32_t kReplyBit = 0x8000;

}  // namespace

std::uint32_t toCanId(const Arbitration& arbitration)
{
    return (std::uint32_t{arbitration.prefix} & kMaxPrefix) << 16 | (arbitration.replyWanted ? kReplyBit : 0) |
           (std::uint32_t{arbitration.source} & 0x7f) << 8 | (std::uint32_t{arbitration.destination} & 0x7f);
}

Arbitration fromCanId(std::uint32_t id)
{
    return {.prefix = static_cast<std::uint16_t>(id >> 16 & kMaxPrefix),
            .replyWanted = (id & kReplyBit) != 0,
            .source = static_cast<std::uint8_t>(id >> 8 & 0x7f),
            .destination = static_cast<std::uint8_t>(id & 0x7f)};
}

bool isAddressedTo(std::uint32_t id, std::uint8_t device, std::uint16_t prefix)
{
    const std::uint32_t target = id & 0xff;
    return (target == device || target == kBroadcastId) && (id >> 16 & kMaxPrefix) == prefix;
}

CanFrame makeFrame(const Arbitration& arbitration, std::span<const std::uint8_t> payload)
{
    CanFrame frame;
    frame.id = toCanId(arbitration);
    frame.extended = frame.id > kMaxStandardId;
    frame.setPayload(payload);
    const std::size_t padded = legalCanLength(frame.size);
    std::fill(frame.data.begin() + frame.size, frame.data.begin() + padded, type::kNop);
    frame.size = static_cast<std::uint8_t>(padded);
    return frame;
}

}  // namespace boresight::moteus
