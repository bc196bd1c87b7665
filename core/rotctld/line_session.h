// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"
#include "core/rotctld/conversation.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

// A conversation in a protocol of lines: each line ends with CR or LF and is one command. Empty lines are ignored. Half
// a line is dropped when the client leaves. Station thread.
namespace boresight::rotctld {

// The effect of one line. A result of InvalidInput: the line is no command.
struct LineOutcome
{
    std::string reply;
    Result<> result;
    QString became = {};                    // the changed target, as text; empty if unchanged
    bool motion = false;                    // it requested a motion, accepted or not
    std::optional<SkyPointing> point = {};  // the target that it requested
};

class LineProtocol
{
public:
    virtual ~LineProtocol() = default;
    // Without its line end, never empty.
    [[nodiscard]] virtual LineOutcome obey(std::string_view line) = 0;
};

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
