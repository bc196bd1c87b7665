// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/moteus/subframe_types.h"
#include "core/moteus/subframes.h"

#include <cassert>

namespace boresight::moteus {

std::uint32_t ValueBlock::bits(std::uint32_t index) const
{
    assert(index < count);
    const std::size_t size = sizeInBytes(resolution);
    std::uint32_t result = 0;
    for (std::size_t i = 0; i < size; ++i) {
        result |= std::uint32_t{bytes[index * size + i]} << (8 * i);
    }
    return result;
}

RegisterValue ValueBlock::value(std::uint32_t index, Side side) const
{
    const Register reg = first + index;
    const Kind kind = registerKind(reg).value_or(Kind::Integer);
    return {reg, resolution, fromWire(bits(index), kind, resolution, side)};
}

std::optional<Subframe> SubframeReader::next()
{
    if (m_rest.empty()) {
        return std::nullopt;
    }
    const std::uint8_t code = *byte();
    if (code < type::kWriteError) {
        return block(code);
    }
    switch (code) {
        case type::kWriteError:
        case type::kReadError:
            return error(code);
        case type::kTunnelToDevice:
        case type::kTunnelFromDevice:
        case type::kTunnelPoll:
        case type::kTunnelPacket:
        case type::kTunnelPollFlow:
            return tunnel(code);
        case type::kNop:
            return Nop{};
        default:
            return stop(ParseEnd::Unknown);
    }
}

std::optional<Subframe> SubframeReader::stop(ParseEnd end)
{
    m_end = end;
    m_rest = {};
    return std::nullopt;
}

std::optional<std::uint8_t> SubframeReader::byte()
{
    if (m_rest.empty()) {
        return std::nullopt;
    }
    const std::uint8_t value = m_rest.front();
    m_rest = m_rest.subspan(1);
    return value;
}

// Five bytes hold 32 bits. A longer or larger number does not exist in this protocol.
std::optional<std::uint32_t> SubframeReader::varuint()
{
    std::uint64_t value = 0;
    for (unsigned shift = 0; shift < 35; shift += 7) {
        const auto part = byte();
        if (!part) {
            return std::nullopt;
        }
        value |= std::uint64_t{*part & 0x7fU} << shift;
        if ((*part & 0x80U) == 0) {
            return value <= UINT32_MAX ? std::optional(static_cast<std::uint32_t>(value)) : std::nullopt;
        }
    }
    return std::nullopt;
}

std::optional<std::span<const std::uint8_t>> SubframeReader::counted()
{
    const auto length = varuint();
    if (!length || *length > m_rest.size()) {
        return std::nullopt;
    }
    const auto bytes = m_rest.first(*length);
    m_rest = m_rest.subspan(*length);
    return bytes;
}

std::optional<Subframe> SubframeReader::block(std::uint8_t code)
{
    BlockHeader header;
    header.resolution = static_cast<Resolution>(code >> 2 & 3);
    header.longCount = (code & 3) == 0;
    const auto count = header.longCount ? varuint() : std::optional<std::uint32_t>(code & 3U);
    const auto first = count ? varuint() : std::nullopt;
    if (!first) {
        return stop(ParseEnd::Truncated);
    }
    header.count = *count;
    header.first = static_cast<Register>(*first);
    switch (code & 0xf0) {
        case type::kWrite:
            return values<WriteBlock>(header);
        case type::kRead:
            return ReadBlock{header};
        default:
            return values<ReplyBlock>(header);
    }
}

template <class Block>
std::optional<Subframe> SubframeReader::values(const BlockHeader& header)
{
    Block result;
    static_cast<BlockHeader&>(result) = header;
    const std::size_t size = sizeInBytes(header.resolution);
    const std::size_t complete = m_rest.size() / size;
    if (header.count <= complete) {
        result.bytes = m_rest.first(header.count * size);
        m_rest = m_rest.subspan(result.bytes.size());
        return result;
    }
    result.bytes = m_rest.first(complete * size);
    result.count = static_cast<std::uint32_t>(complete);
    static_cast<void>(stop(ParseEnd::Truncated));
    return result;
}

std::optional<Subframe> SubframeReader::error(std::uint8_t code)
{
    const auto number = varuint();
    const auto reason = number ? varuint() : std::nullopt;
    if (!reason) {
        return stop(ParseEnd::Truncated);
    }
    const auto reg = static_cast<Register>(*number);
    return code == type::kWriteError ? Subframe(WriteError{reg, *reason}) : Subframe(ReadError{reg, *reason});
}

std::optional<Subframe> SubframeReader::tunnel(std::uint8_t code)
{
    const bool numbered = code == type::kTunnelPacket || code == type::kTunnelPollFlow;
    const auto channel = varuint();
    const auto number = !channel ? std::nullopt : numbered ? byte() : std::optional<std::uint8_t>(0);
    if (!number) {
        return stop(ParseEnd::Truncated);
    }
    if (code == type::kTunnelPoll || code == type::kTunnelPollFlow) {
        const auto maximum = varuint();
        if (!maximum) {
            return stop(ParseEnd::Truncated);
        }
        return numbered ? Subframe(TunnelPollFlow{*channel, *number, *maximum})
                        : Subframe(TunnelPoll{*channel, *maximum});
    }
    const auto bytes = counted();
    if (!bytes) {
        return stop(ParseEnd::Truncated);
    }
    if (numbered) {
        return TunnelPacket{*channel, *number, *bytes};
    }
    return code == type::kTunnelToDevice ? Subframe(TunnelToDevice{*channel, *bytes})
                                         : Subframe(TunnelFromDevice{*channel, *bytes});
}

}  // namespace boresight::moteus
