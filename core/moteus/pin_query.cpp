// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/moteus/pin_query.h"

namespace boresight::moteus {
namespace {

constexpr Register kPort1 = Register::AuxGpioStatus;
constexpr auto kPort2 = static_cast<Register>(static_cast<std::uint32_t>(kPort1) + 1);
constexpr double kMostBits = 31.0;  // five pins

std::optional<std::uint8_t> bitsOf(const std::optional<double>& value)
{
    return value && *value >= 0.0 && *value <= kMostBits ? std::optional(static_cast<std::uint8_t>(*value))
                                                         : std::nullopt;
}

}  // namespace

const Query& pinQuery()
{
    static const Query query{{kPort1, Resolution::Int8}, {kPort2, Resolution::Int8}};
    return query;
}

std::optional<std::array<std::uint8_t, 2>> pinsIn(const Reply& reply)
{
    const auto first = bitsOf(reply.value(kPort1));
    const auto second = bitsOf(reply.value(kPort2));
    return first && second ? std::optional(std::array{*first, *second}) : std::nullopt;
}

}  // namespace boresight::moteus
