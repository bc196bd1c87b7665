// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

// First byte of each subframe, used only by the reader and the writer. The block types carry the resolution in bits
// 3..2 and counts of 1 to 3 in bits 1..0 (0: the count follows as a varuint).
namespace boresight::moteus::type {

inline constexpr std::uint8_t kWrite = 0x00;
inline constexpr std::uint8_t kRead = 0x10;
inline constexpr std::uint8_t kReply = 0x20;
inline constexpr std::uint8_t kWriteError = 0x30;
inline constexpr std::uint8_t kReadError = 0x31;
inline constexpr std::uint8_t kTunnelToDevice = 0x40;
inline constexpr std::uint8_t kTunnelFromDevice = 0x41;
inline constexpr std::uint8_t kTunnelPoll = 0x42;
inline constexpr std::uint8_t kTunnelPacket = 0x43;
inline constexpr std::uint8_t kTunnelPollFlow = 0x44;
inline constexpr std::uint8_t kNop = 0x50;

inline constexpr std::uint32_t kLargestShortCount = 3;

}  // namespace boresight::moteus::type
