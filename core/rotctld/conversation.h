// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/rotctld/client_habits.h"
#include "core/rotctld/rotator.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <string_view>

namespace boresight::rotctld {

inline constexpr int kMaxOddInARow = 8;          // unknown lines in a row before the connection is closed
inline constexpr std::uint64_t kOddRemarks = 3;  // number of unknown lines that are logged in full

// The conversation of one client in some protocol: bytes in, replies out, without a socket. Each step() runs one
// command, in order. So the server decides how many commands of one client run before the next client. Station thread.
class Conversation
{
public:
    virtual ~Conversation() = default;

    virtual void receive(std::string_view bytes) = 0;
    // The client sends no more, though it may still read.
    virtual void endOfInput() = 0;
    // Runs the next command if it is complete, and appends its reply (at most one). True if there may be more to do.
    [[nodiscard]] virtual bool step(std::string& reply) = 0;

    [[nodiscard]] virtual const Client& client() const = 0;
    // Why the conversation is over; empty while it continues.
    [[nodiscard]] virtual const QString& ending() const = 0;
    [[nodiscard]] virtual bool dropped() const = 0;  // by the server; false: the client left by itself
    [[nodiscard]] virtual bool paused() const { return false; }
    [[nodiscard]] virtual bool midCommand() const = 0;
    [[nodiscard]] virtual const ClientHabits& habits() const = 0;
};

using StartConversation = std::function<std::unique_ptr<Conversation>(Client client)>;

}  // namespace boresight::rotctld
