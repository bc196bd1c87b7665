// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"
#include "core/rotctld/client_habits.h"
#include "core/rotctld/command_parser.h"
#include "core/rotctld/conversation.h"
#include "core/rotctld/handlers.h"
#include "core/rotctld/received_line.h"
#include "core/rotctld/rotator.h"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

// A conversation in the protocol of Hamlib's rotctld. Station thread.
namespace boresight::rotctld {

class Session final : public Conversation
{
public:
    Session(Client client, Rotator& rotator, const Clock& clock, DumpStateForm dumpState);

    void receive(std::string_view bytes) override;
    // A pause that the client asked for ends, and with it the session.
    void endOfInput() override;

    [[nodiscard]] bool step(std::string& reply) override;

    [[nodiscard]] const Client& client() const override { return m_client; }
    [[nodiscard]] const QString& ending() const override { return m_ending; }
    [[nodiscard]] bool dropped() const override { return m_dropped; }
    [[nodiscard]] bool paused() const override { return m_pause.has_value(); }
    [[nodiscard]] bool midCommand() const override { return m_parser.midCommand(); }
    [[nodiscard]] const ClientHabits& habits() const override { return m_habits; }

private:
    struct Pause
    {
        SteadyTime until;
        std::string reply = {};  // at its end
    };

    bool resume(std::string& reply);
    bool inputTaken(std::string& reply);
    void run(std::string& reply);
    void keep(std::string_view bytes);
    void logLine(Exchange exchange);
    void logUnread(const QString& reason);
    Result<> obey(std::string& reply, QString& became);
    void failed(const Error& error, std::string& reply, std::size_t replyStart);
    void drop(const QString& reason);
    void endAsForeign();
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
    std::size_t m_taken = 0;  // bytes of m_input that were read
    ReceivedLine m_line;      // of the command that is being read; empty while the protocol log is off
    bool m_inputEnded = false;
    std::optional<Pause> m_pause;
    // Of the last command: why it was refused, or the changed target. Empty: it was accepted as it was sent.
    QString m_outcome;
    QString m_ending;
    bool m_dropped = false;
    int m_oddInARow = 0;
};

// How a server starts a conversation with a client. Rotator and clock outlive it.
[[nodiscard]] StartConversation talkRotctld(Rotator& rotator, const Clock& clock, DumpStateForm dumpState);

}  // namespace boresight::rotctld
