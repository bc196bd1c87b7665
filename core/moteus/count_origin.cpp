// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/moteus/count_origin.h"

#include <bit>
#include <cmath>
#include <cstddef>

namespace boresight::moteus {
namespace {

// The record ends with these fields (firmware 2024-06 to 2026-04, fw/motor_position.h, in this order): epoch u8,
// relative position valid u8 and ever valid u8, relative position i64 and f32, its modulo i64, position i64 and f32,
// home state (one byte), velocity f32, electrical angle valid u8, electrical angle f32. The encoder fields before them
// differ between firmwares, so the record is read from its end. Firmware from November 2023 on has no "ever valid", and
// its epoch is one byte later. Therefore three bytes from here are compared as one number.
constexpr std::size_t kTail = 45;
constexpr std::size_t kBeginning = 0;
constexpr std::size_t kValid = 2;
constexpr std::size_t kRelativeCount = 3;
constexpr std::size_t kRelative = 11;
constexpr std::size_t kCount = 23;
constexpr std::size_t kPosition = 31;
constexpr std::size_t kHomeState = 35;
constexpr std::uint64_t kMostHomeState = 2;

constexpr double kCountsPerTurn = 281474976710656.0;  // 2^48
// In turns. The fields of one position are written one after the other while the axis may turn, so they may differ by
// this.
constexpr double kSame = 0.001;

std::uint64_t littleEndian(std::string_view data, std::size_t at, std::size_t bytes)
{
    std::uint64_t value = 0;
    for (std::size_t i = bytes; i-- > 0;) {
        value = value << 8 | static_cast<std::uint8_t>(data[at + i]);
    }
    return value;
}

double real(std::string_view data, std::size_t at)
{
    return static_cast<double>(std::bit_cast<float>(static_cast<std::uint32_t>(littleEndian(data, at, 4))));
}

double turns(std::uint64_t count)
{
    return static_cast<double>(static_cast<std::int64_t>(count)) / kCountsPerTurn;
}

}  // namespace

std::optional<CountOrigin> countOrigin(std::string_view data)
{
    // The first byte is the error code. With an error both counts stand still, even if the axis moves.
    if (data.size() <= kTail || data.front() != 0) {
        return std::nullopt;
    }
    const std::string_view tail = data.substr(data.size() - kTail);
    const std::uint64_t relative = littleEndian(tail, kRelativeCount, 8);
    const std::uint64_t position = littleEndian(tail, kCount, 8);
    // Each position exists as a count and as a number. If both agree, the record has the expected layout.
    const bool agree = std::abs(turns(relative) - real(tail, kRelative)) < kSame &&
                       std::abs(turns(position) - real(tail, kPosition)) < kSame;
    const bool valid = tail[kValid] == 1 && littleEndian(tail, kHomeState, 1) <= kMostHomeState;
    if (!agree || !valid) {
        return std::nullopt;
    }
    // Both counts overflow, and their difference may overflow, too.
    return CountOrigin{.beginning = static_cast<std::uint32_t>(littleEndian(tail, kBeginning, 3)),
                       .offset = MotorTurns::fromTurns(turns(position - relative))};
}

}  // namespace boresight::moteus
