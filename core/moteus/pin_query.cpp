// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/moteus/pin_query.h"

namespace boresight::moteus {
namespace {

constexpr double kMostBits = 31.0;  // five pins

constexpr Register ofPort2(Register ofPort1)
{
    return static_cast<Register>(static_cast<std::uint32_t>(ofPort1) + 1);
}

Query queryOf(Register ofPort1)
{
    return {{ofPort1, Resolution::Int8}, {ofPort2(ofPort1), Resolution::Int8}};
}

std::optional<std::uint8_t> bitsOf(const std::optional<double>& value)
{
    return value && *value >= 0.0 && *value <= kMostBits ? std::optional(static_cast<std::uint8_t>(*value))
                                                         : std::nullopt;
}

std::optional<PinBits> bothPorts(const Reply& reply, Register ofPort1)
{
    const auto first = bitsOf(reply.value(ofPort1));
    const auto second = bitsOf(reply.value(ofPort2(ofPort1)));
    return first && second ? std::optional(PinBits{*first, *second}) : std::nullopt;
}

}  // namespace

const Query& pinQuery()
{
    static const Query query = queryOf(Register::AuxGpioStatus);
    return query;
}

std::optional<PinBits> pinsIn(const Reply& reply)
{
    return bothPorts(reply, Register::AuxGpioStatus);
}

const Query& outputQuery()
{
    static const Query query = queryOf(Register::AuxGpioCommand);
    return query;
}

std::optional<PinBits> outputsIn(const Reply& reply)
{
    return bothPorts(reply, Register::AuxGpioCommand);
}

}  // namespace boresight::moteus
