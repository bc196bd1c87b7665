// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"
#include "core/units/sky.h"

#include <QString>

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

// The lines of the protocol log: what a client sent, what Boresight understood, what Boresight answered. A line holds
// bytes and numbers. The functions below make its texts, when somebody reads them. Plain values, any thread.
namespace boresight {

// Bytes of a client, or for a client. Long ones are cut.
struct ProtocolBytes
{
    static constexpr std::size_t kMost = 200;

    std::string begin;     // at most kMost bytes
    std::size_t size = 0;  // of all bytes
};
// `size`: of all bytes, if `bytes` are only the first of them.
[[nodiscard]] ProtocolBytes protocolBytes(std::string_view bytes, std::size_t size = 0);

// What a line of a client asked of the mount.
struct ProtocolAct
{
    enum class Kind : std::uint8_t
    {
        Point,  // to azimuth and elevation, as the client sent them
        AskPosition,
        AskTarget,
        AskMotion,
        MoveUp,
        MoveDown,
        MoveLeft,
        MoveRight,
        Stop,
        Park,
        Reset,
        SetSpeed  // to `level`
    };

    Kind kind = Kind::Stop;
    Angle azimuth{};
    Angle elevation{};
    int level = 0;
};

enum class ProtocolOutcome : std::uint8_t
{
    Done,
    Refused,
    NotUnderstood
};

struct ProtocolLine
{
    std::uint64_t number = 0;  // counts up by one
    UtcTime utc;
    std::uint64_t clientId = 0;
    QString client;                 // "rotctld 127.0.0.1:51234"
    ProtocolBytes line;             // as received, without its line end
    std::vector<ProtocolAct> acts;  // empty: nothing was asked of the mount
    std::string command;            // the name of the command in its protocol; may be empty
    ProtocolOutcome outcome = ProtocolOutcome::Done;
    QString remark;        // the reason of the refusal, or what became of the target; may be empty
    ProtocolBytes answer;  // as sent; may be empty
    bool odd = false;      // counted in ClientStatus::oddCommands, or of another protocol
};

using ProtocolLines = std::shared_ptr<const std::vector<ProtocolLine>>;

// The bytes as one line of text. A byte that does not print is "\n", "\r", "\t" or "\x1b". A backslash is doubled if it
// would read as one of these. The line end after other bytes is left out. Cut bytes end with "… (4096 bytes)".
[[nodiscard]] QString bytesText(const ProtocolBytes& bytes);
// "go to 113.0° / 10.0°", "asks the position", "go to 400.0° / 30.0° → az 40.0°", "not understood".
[[nodiscard]] QString understoodText(const ProtocolLine& line);
// For a file, with tabs between: UTC, client, "odd" or "-", line, what was understood, answer.
[[nodiscard]] QString fileText(const ProtocolLine& line);

}  // namespace boresight
