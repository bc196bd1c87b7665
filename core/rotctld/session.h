// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"
#include "core/rotctld/client_habits.h"
#include "core/rotctld/command_parser.h"
#include "core/rotctld/handlers.h"
#include "core/rotctld/rotator.h"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

// One client's conversation: bytes in, replies out, without a socket. Commands run one per step(), in order, so that
// the server decides how much of one client it serves before the next. Station thread.
namespace boresight::rotctld {

class Session
{
public:
    Session(Client client, Rotator& rotator, const Clock& clock, DumpStateForm dumpState);

    void receive(std::string_view bytes);
    // The client sends no more, though it may still read. A pause it asked for ends, and with it the session.
    void endOfInput();

    // Takes the next command if one is complete, and appends its reply, one reply at most. True while there may be
    // more to do.
    [[nodiscard]] bool step(std::string& reply);

    [[nodiscard]] const Client& client() const { return m_client; }
    // Why the conversation is over; empty while it goes on.
    [[nodiscard]] const QString& ending() const { return m_ending; }
    [[nodiscard]] bool dropped() const { return m_dropped; }  // by us; else it left by itself
    [[nodiscard]] bool paused() const { return m_pausedUntil.has_value(); }
    [[nodiscard]] bool midCommand() const { return m_parser.midCommand(); }

    [[nodiscard]] const ClientHabits& habits() const { return m_habits; }

private:
    bool resume(std::string& reply);
    bool inputTaken(std::string& reply);
    void run(std::string& reply);
    void failed(const Error& error, std::string& reply, std::size_t replyStart);
    void drop(const QString& reason);
    void endAsStranger();
    Result<> execute(const Command& command, ReplyWriter& writer, QString& became);
    Result<> pause(const Command& command);
    void unknown(std::string_view restOfLine);
    void odd(const QString& text);

    Client m_client;
    Rotator& m_rotator;
    const Clock& m_clock;
    DumpStateForm m_dumpState;
    CommandParser m_parser;
    ClientHabits m_habits;
    std::string m_input;
    std::size_t m_taken = 0;  // of m_input
    bool m_inputEnded = false;
    std::optional<SteadyTime> m_pausedUntil;
    std::string m_pauseReply;
    QString m_ending;
    bool m_dropped = false;
    int m_oddInARow = 0;
};

}  // namespace boresight::rotctld
