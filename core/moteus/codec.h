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

// The client side of a moteus exchange: a request becomes a frame, and a reply frame becomes values. A reply shows the
// state of the drive *before* the command in the same exchange took effect. Pure, any thread.
namespace boresight::moteus {

// Once its reply is longer than this, a drive starts no new block and drops the remaining queries without an error.
inline constexpr std::size_t kReplyBlockStartLimit = 41;

using Query = std::vector<RegisterRead>;

// The default of the official clients: mode, position, velocity, torque, voltage, temperature, fault (22 bytes of
// reply).
[[nodiscard]] const Query& basicQuery();
// The query of a rotator in every frame: the values of basicQuery(), and q and d current, power, control position and
// velocity, the echo of a PositionCommand, motor temperature, trajectory and home state (55 bytes of reply).
[[nodiscard]] const Query& rotatorQuery();
// For finding drives, as the maker's tools do: the UUID, and whether the drive can be addressed by its UUID.
[[nodiscard]] const Query& discoveryQuery();
// Model number, firmware version, register map version.
[[nodiscard]] const Query& versionQuery();

// Uuid: the 16 bytes of a drive as four words. UuidMask: the first one to four words, to address one of two drives with
// the same id.
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
    std::optional<Command> command{};  // empty: only a query
    Query query{};
    bool replyWanted = true;  // if false, the drive stays silent
};

// The number of bytes in the reply to a query.
[[nodiscard]] std::size_t replySize(std::span<const RegisterRead> query);
// Refuses a query whose reply would be cut short or missing.
[[nodiscard]] Result<> checkAnswerable(std::span<const RegisterRead> query);

// Refuses requests that the protocol cannot carry: more than 64 bytes, a query that cannot be answered completely or
// that wants no reply, an id out of range, or a register that cannot be read.
[[nodiscard]] Result<CanFrame> encode(const Request& request);

struct RegisterError
{
    Register reg = Register::Mode;
    std::uint32_t code = 0;
    bool write = false;

    bool operator==(const RegisterError&) const = default;
};

// Text from the diagnostic tunnel. `number` exists only with flow control.
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
    std::vector<RegisterValue> values{};  // in the order of the reply; NaN is "unset"
    std::vector<RegisterError> errors{};
    std::vector<TunnelText> texts{};
    ParseEnd end = ParseEnd::Complete;  // any other value: the end of the reply is missing or unreadable

    // Empty if the reply does not contain the register, or if the value is unset or infinite (no drive measures
    // infinity).
    [[nodiscard]] std::optional<double> value(Register reg) const;
    [[nodiscard]] std::optional<Mode> mode() const;  // also empty for a number that the protocol does not define
    [[nodiscard]] std::optional<int> fault() const;
    [[nodiscard]] std::optional<HomeState> homeState() const;
    [[nodiscard]] std::optional<Uuid> uuid() const;
};

// Fails only if the frame is no reply, because its "reply wanted" bit is set. From a damaged payload, all readable
// values are returned.
[[nodiscard]] Result<Reply> decodeReply(const CanFrame& frame);

}  // namespace boresight::moteus
