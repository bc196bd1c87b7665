// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

// One frame on a CAN or CAN-FD bus, as a value: what every bus sends and receives. Received frames carry the steady
// time of their arrival.
namespace boresight {

inline constexpr std::size_t kMaxCanPayload = 64;
inline constexpr std::uint32_t kMaxStandardId = 0x7ff;

struct CanFrame
{
    std::uint32_t id = 0;
    bool extended = false;      // 29-bit identifier
    bool flexibleData = true;   // CAN-FD frame
    bool bitRateSwitch = true;  // data phase at the fast bit rate
    std::array<std::uint8_t, kMaxCanPayload> data{};
    std::uint8_t size = 0;  // bytes of data in use, a legal CAN-FD length on the wire
    SteadyTime received{};  // arrival; epoch for a frame of our own

    [[nodiscard]] std::span<const std::uint8_t> payload() const { return {data.data(), size}; }
    void setPayload(std::span<const std::uint8_t> bytes);  // bytes.size() <= 64, asserted

    // Same bits on the wire; the arrival time does not count.
    bool operator==(const CanFrame& other) const;
};

// The CAN-FD lengths are 0..8, 12, 16, 20, 24, 32, 48 and 64: the smallest that holds `size` bytes (size <= 64).
[[nodiscard]] std::size_t legalCanLength(std::size_t size);

// "8001 [3] 11 00 0f": for logs and test failures.
[[nodiscard]] std::string toString(const CanFrame& frame);

}  // namespace boresight
