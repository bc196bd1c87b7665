// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/can_frame.h"
#include "core/base/result.h"
#include "core/moteus/arbitration.h"
#include "core/moteus/drive_commands.h"
#include "core/moteus/subframes.h"

#include <array>
#include <optional>
#include <string>
#include <vector>

// The client's side of a moteus exchange: a request becomes a frame, a reply frame becomes values. A reply shows the
// drive as it was *before* the command in the same exchange took effect. Pure, any thread.
namespace boresight::moteus {

// A drive starts no new block of its answer once it holds more than this; later queries are dropped without a word.
inline constexpr std::size_t kReplyBlockStartLimit = 41;

using Query = std::vector<RegisterRead>;

// The official clients' default: mode, position, velocity, torque, voltage, temperature, fault (22 bytes of reply).
[[nodiscard]] const Query& basicQuery();
// What a rotator wants in every reply: also q and d current, power, control position and velocity, the echo of a
// PositionCommand, motor temperature, trajectory and home state (55 bytes).
[[nodiscard]] const Query& rotatorQuery();
// Who is there: the UUID and whether it can be addressed by it, as the maker's tools discover drives.
[[nodiscard]] const Query& discoveryQuery();
// Model number, firmware version, register map version.
[[nodiscard]] const Query& versionQuery();

// The four words of a drive's 16 bytes, and the first one to four of them, to address it when two share one id.
using Uuid = std::array<std::uint32_t, 4>;
struct UuidMask
{
    Uuid uuid{};
    std::size_t words = 4;
};

struct Request
{
    std::uint8_t destination = 1;
    std::uint16_t prefix = 0;
    std::uint8_t source = kHostId;
    std::optional<UuidMask> uuid{};    // usually with destination = kBroadcastId
    std::optional<Command> command{};  // nothing: a plain query
    Query query{};
    bool replyWanted = true;  // a drive asked without it stays silent
};

// The bytes a query will bring back.
[[nodiscard]] std::size_t replySize(std::span<const RegisterRead> query);
// Refuses a query whose answer would come back cut short or not at all.
[[nodiscard]] Result<> checkAnswerable(std::span<const RegisterRead> query);

// Refuses what the protocol cannot carry: over 64 bytes, a query that cannot be answered in full or that asks without
// wanting a reply, an id out of range, a register that cannot be read.
[[nodiscard]] Result<CanFrame> encode(const Request& request);

struct RegisterError
{
    Register reg = Register::Mode;
    std::uint32_t code = 0;
    bool write = false;

    bool operator==(const RegisterError&) const = default;
};

// Text of the diagnostic tunnel; `number` only with flow control.
struct TunnelText
{
    std::uint32_t channel = 0;
    std::optional<std::uint8_t> number{};
    std::string text{};

    bool operator==(const TunnelText&) const = default;
};

struct Reply
{
    std::uint8_t source = 0;
    std::uint8_t destination = 0;
    std::uint16_t prefix = 0;
    std::vector<RegisterValue> values{};  // in order of appearance; NaN is "unset"
    std::vector<RegisterError> errors{};
    std::vector<TunnelText> texts{};
    ParseEnd end = ParseEnd::Complete;  // anything else: the tail is missing or unreadable

    // Empty if the reply does not have the register, or its value is unset or infinite (no drive measures that).
    [[nodiscard]] std::optional<double> value(Register reg) const;
    [[nodiscard]] std::optional<Mode> mode() const;  // empty also for a number the protocol does not define
    [[nodiscard]] std::optional<int> fault() const;
    [[nodiscard]] std::optional<HomeState> homeState() const;
    [[nodiscard]] std::optional<Uuid> uuid() const;
};

// Fails only if the frame is no reply at all: the "reply wanted" bit is set. A damaged payload gives what could be
// read.
[[nodiscard]] Result<Reply> decodeReply(const CanFrame& frame);

}  // namespace boresight::moteus
