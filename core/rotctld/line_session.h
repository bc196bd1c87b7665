// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"
#include "core/rotctld/conversation.h"
#include "core/rotctld/line_protocol.h"

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

// A conversation in a protocol of lines: each line ends with CR or LF and is one command. Empty lines are ignored. Half
// a line is dropped when the client leaves. Station thread.
namespace boresight::rotctld {

class LineSession final : public Conversation
{
public:
    LineSession(Client client, std::unique_ptr<LineProtocol> protocol, Rotator& rotator, const Clock& clock);

    void receive(std::string_view bytes) override { m_input.append(bytes); }
    void endOfInput() override { m_inputEnded = true; }
    [[nodiscard]] bool step(std::string& reply) override;

    [[nodiscard]] const Client& client() const override { return m_client; }
    [[nodiscard]] const QString& ending() const override { return m_ending; }
    [[nodiscard]] bool dropped() const override { return m_dropped; }
    [[nodiscard]] bool midCommand() const override { return !m_input.empty(); }
    [[nodiscard]] const ClientHabits& habits() const override { return m_habits; }

private:
    void run(std::string_view line, std::string& reply);
    [[nodiscard]] LineOutcome obey(std::string_view line);
    void logLine(std::string_view line, const LineOutcome& outcome);
    void odd(std::string_view line);
    void wait();
    void drop(const QString& reason);

    Client m_client;
    std::unique_ptr<LineProtocol> m_protocol;
    Rotator& m_rotator;
    const Clock& m_clock;
    ClientHabits m_habits;
    std::string m_input;
    std::size_t m_taken = 0;  // bytes of m_input that were read
    bool m_inputEnded = false;
    QString m_ending;
    bool m_dropped = false;
    int m_oddInARow = 0;
};

}  // namespace boresight::rotctld
