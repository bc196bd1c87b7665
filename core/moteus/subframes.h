// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/can_frame.h"
#include "core/moteus/registers.h"
#include "core/moteus/scaling.h"

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <variant>
#include <vector>

// The layer that both sides share: a payload is a sequence of subframes. SubframeReader reads it, SubframeWriter builds
// it. Writing the subframes that were read gives the same bytes. The spans in a subframe point into the payload that
// was read, so they live as long as the payload. Pure, any thread.
namespace boresight::moteus {

// One register with its value in the unit of its kind, and its format on the bus. NaN is "unset".
struct RegisterValue
{
    Register reg = Register::Mode;
    Resolution resolution = Resolution::Float;
    double value = 0.0;
};

struct RegisterRead
{
    Register reg = Register::Mode;
    Resolution resolution = Resolution::Float;

    bool operator==(const RegisterRead&) const = default;
};

// Consecutive registers in one resolution. `longCount` records how the count was written, because a drive answers in
// the form of the request.
struct BlockHeader
{
    Resolution resolution = Resolution::Float;
    std::uint32_t count = 0;
    Register first = Register::Mode;
    bool longCount = false;
};

struct ReadBlock : BlockHeader
{};

struct ValueBlock : BlockHeader
{
    std::span<const std::uint8_t> bytes;  // count * sizeInBytes(resolution)

    [[nodiscard]] std::uint32_t bits(std::uint32_t index) const;  // of the register first + index, for fromWire()
    [[nodiscard]] RegisterValue value(std::uint32_t index, Side side = Side::Client) const;
};

struct WriteBlock : ValueBlock
{};

struct ReplyBlock : ValueBlock
{};

// Codes of both errors. 1: unknown, not accessible or not in that resolution. 2: not writable, or no room in the reply.
inline constexpr std::uint32_t kUnknownRegister = 1;
inline constexpr std::uint32_t kNotWritable = 2;
inline constexpr std::uint32_t kNoRoom = 2;

struct WriteError
{
    Register reg = Register::Mode;
    std::uint32_t code = 0;
};

struct ReadError
{
    Register reg = Register::Mode;
    std::uint32_t code = 0;
};

struct TunnelToDevice
{
    std::uint32_t channel = 0;
    std::span<const std::uint8_t> bytes;
};

struct TunnelFromDevice
{
    std::uint32_t channel = 0;
    std::span<const std::uint8_t> bytes;
};

struct TunnelPoll
{
    std::uint32_t channel = 0;
    std::uint32_t maximum = 0;
};

struct TunnelPacket
{
    std::uint32_t channel = 0;
    std::uint8_t number = 0;
    std::span<const std::uint8_t> bytes;
};

struct TunnelPollFlow
{
    std::uint32_t channel = 0;
    std::uint8_t lastNumber = 0;  // number of the last packet that the host received
    std::uint32_t maximum = 0;
};

struct Nop
{};

using Subframe = std::variant<ReadBlock, WriteBlock, ReplyBlock, WriteError, ReadError, TunnelToDevice,
                              TunnelFromDevice, TunnelPoll, TunnelPacket, TunnelPollFlow, Nop>;

enum class ParseEnd : std::uint8_t
{
    Complete,   // every byte was understood
    Truncated,  // the last subframe is cut off; its complete values were returned
    Unknown,    // unknown subframe type: the rest cannot be read
};

class SubframeReader
{
public:
    explicit SubframeReader(std::span<const std::uint8_t> payload) : m_rest(payload) {}

    // The next subframe. Empty at the end, and end() then tells the reason.
    [[nodiscard]] std::optional<Subframe> next();
    [[nodiscard]] ParseEnd end() const { return m_end; }

private:
    [[nodiscard]] std::optional<Subframe> stop(ParseEnd end);
    [[nodiscard]] std::optional<std::uint8_t> byte();
    [[nodiscard]] std::optional<std::uint32_t> varuint();
    [[nodiscard]] std::optional<std::span<const std::uint8_t>> counted();
    [[nodiscard]] std::optional<Subframe> block(std::uint8_t type);
    [[nodiscard]] std::optional<Subframe> error(std::uint8_t type);
    [[nodiscard]] std::optional<Subframe> tunnel(std::uint8_t type);
    template <class Block>
    [[nodiscard]] std::optional<Subframe> values(const BlockHeader& header);

    std::span<const std::uint8_t> m_rest;
    ParseEnd m_end = ParseEnd::Complete;
};

// The number of bytes of a varuint, which holds 7 bits per byte.
[[nodiscard]] std::size_t varuintSize(std::uint32_t value);

// Removes from the front the registers that the writer puts into one subframe. `reads` is not empty.
[[nodiscard]] ReadBlock takeBlock(std::span<const RegisterRead>& reads);
// The number of bytes of a block in the reply.
[[nodiscard]] std::size_t replySize(const ReadBlock& block);

// Consecutive registers in equal resolution share one subframe. The writer never writes beyond 64 bytes: after that it
// only counts, and overflowed() is true.
class SubframeWriter
{
public:
    void append(const Subframe& subframe);
    void appendWrites(std::span<const RegisterValue> writes, Side side = Side::Client);
    void appendReplies(std::span<const RegisterValue> values, Side side = Side::Device);
    void appendReads(std::span<const RegisterRead> reads);

    [[nodiscard]] std::size_t needed() const { return m_needed; }  // may exceed 64
    [[nodiscard]] std::size_t room() const { return overflowed() ? 0 : m_bytes.size() - m_needed; }
    [[nodiscard]] bool overflowed() const { return m_needed > m_bytes.size(); }
    [[nodiscard]] std::span<const std::uint8_t> bytes() const;

private:
    void put(std::uint8_t byte);
    void putVaruint(std::uint32_t value);
    void putBytes(std::span<const std::uint8_t> bytes);
    void putHeader(std::uint8_t base, const BlockHeader& header);
    void putValues(std::uint8_t base, std::span<const RegisterValue> values, Side side);

    std::array<std::uint8_t, kMaxCanPayload> m_bytes{};
    std::size_t m_needed = 0;
};

}  // namespace boresight::moteus
