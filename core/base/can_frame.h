// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

// One frame on a CAN or CAN-FD bus, as a value. A received frame has the steady time of its arrival.
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
    std::uint8_t size = 0;  // number of data bytes in use; must be a valid CAN-FD length
    SteadyTime received{};  // arrival; the epoch for a frame that we send

    [[nodiscard]] std::span<const std::uint8_t> payload() const { return {data.data(), size}; }
    void setPayload(std::span<const std::uint8_t> bytes);  // asserts bytes.size() <= 64

    // True for the same bits on the wire. The arrival time is not compared.
    bool operator==(const CanFrame& other) const;
};

// The smallest CAN-FD length that holds `size` bytes (size <= 64). The lengths are 0…8, 12, 16, 20, 24, 32, 48 and 64.
[[nodiscard]] std::size_t legalCanLength(std::size_t size);

// For logs and test failures: "8001 [3] 11 00 0f".
[[nodiscard]] std::string toString(const CanFrame& frame);

}  // namespace boresight
