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

inline constexpr int kMaxOddInARow = 8;          // lines without sense before we hang up
inline constexpr std::uint64_t kOddRemarks = 3;  // of them are logged word for word

// One client's conversation in some protocol: bytes in, replies out, without a socket. Commands run one per step(), in
// order, so that the server decides how much of one client it serves before the next. Station thread.
class Conversation
{
public:
    virtual ~Conversation() = default;

    virtual void receive(std::string_view bytes) = 0;
    // The client sends no more, though it may still read.
    virtual void endOfInput() = 0;
    // Takes the next command if one is complete, and appends its reply, one reply at most. True while there may be
    // more to do.
    [[nodiscard]] virtual bool step(std::string& reply) = 0;

    [[nodiscard]] virtual const Client& client() const = 0;
    // Why the conversation is over; empty while it goes on.
    [[nodiscard]] virtual const QString& ending() const = 0;
    [[nodiscard]] virtual bool dropped() const = 0;  // by us; else it left by itself
    [[nodiscard]] virtual bool paused() const { return false; }
    [[nodiscard]] virtual bool midCommand() const = 0;
    [[nodiscard]] virtual const ClientHabits& habits() const = 0;
};

using StartConversation = std::function<std::unique_ptr<Conversation>(Client client)>;

}  // namespace boresight::rotctld
