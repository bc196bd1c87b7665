// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/rotctld/command_table.h"

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

// Bytes of one client -> commands. The protocol is a stream of characters, not of lines: `p` runs before its newline,
// `P` waits for two words even on later lines, and `#` begins a comment. Half a command is kept until the rest arrives.
// Unlike in Hamlib, the rest of a line after an unknown or failed command is dropped (HAMLIB.md). Pure. No I/O, no
// clock.
namespace boresight::rotctld {

inline constexpr std::size_t kMaxArgumentLength = 127;  // Hamlib 4.7 cuts here, older ones overflow
inline constexpr std::size_t kMaxLineLength = 4096;     // bytes without a line feed

enum class Spelling : std::uint8_t
{
    Letter,
    LongName,
    BareName  // a long name without its backslash
};

struct Command
{
    const CommandSpec* spec = nullptr;
    Spelling spelling = Spelling::Letter;
    bool extended = false;
    char separator = '\n';
    std::array<std::string, kMaxArguments> arguments;  // as received
    std::size_t argumentCount = 0;
    bool tooLong = false;  // an argument was longer than kMaxArgumentLength; `arguments` holds its beginning
};

class CommandParser
{
public:
    enum class Event
    {
        NeedMore,  // all input was read
        Command,   // see command()
        Odd,       // an unknown command; the rest of its line will be ignored
        Foreign,   // this is another protocol: see foreignProtocol()
        TooLong    // no line feed in kMaxLineLength bytes
    };

    // Removes bytes from the front of `input`, up to and including the next event.
    [[nodiscard]] Event next(std::string_view& input);
    // The client sends no more, so a command that waits only for the end of its word is complete.
    [[nodiscard]] Event finish();
    // The command failed, so the rest of its line is dropped.
    [[nodiscard]] Event skipLine();

    [[nodiscard]] const Command& command() const { return m_command; }
    [[nodiscard]] std::string_view foreignProtocol() const { return m_foreignProtocol; }
    [[nodiscard]] std::string_view lineHead() const { return m_lineHead; }
    // A command is incomplete.
    [[nodiscard]] bool midCommand() const { return m_state != State::Idle && m_state != State::Ignore; }

private:
    enum class State
    {
        Idle,        // at the start of a line or after a command
        Plus,        // after '+': a separator may follow
        Prefixed,    // after the prefix: a command must follow
        Name,        // inside a long name
        Argument,    // before or inside an argument
        RestOfLine,  // inside the argument of send_cmd
        WordEnd,     // an acting command waits for the end of its word
        Ignore,      // up to the line feed
    };

    unsigned char take(std::string_view& input);
    void startLine();
    Event step(std::string_view& input);
    Event idle(std::string_view& input);
    std::optional<Event> openLine(std::string_view& input);
    Event plus(std::string_view& input);
    Event letter(unsigned char byte, std::string_view rest);
    Event byLetter(const CommandSpec& spec, std::string_view rest);
    Event name(std::string_view& input);
    Event argument(std::string_view& input);
    Event restOfLine(std::string_view& input);
    Event wordEnd(std::string_view& input);
    Event ignore(std::string_view& input);
    void select(const CommandSpec& spec, Spelling spelling);
    Event begin(const CommandSpec& spec, Spelling spelling);
    Event complete();
    Event odd();
    Event checkForeignProtocol();
    void addToArgument(char byte);
    void clearPrefix();

    State m_state = State::Idle;
    Command m_command;
    std::string m_name;
    std::string m_lineHead;  // first bytes of the line, to detect foreign protocols
    std::string_view m_foreignProtocol;
    std::size_t m_lineLength = 0;
    std::size_t m_binaryBytes = 0;  // unprintable bytes outside arguments since the last command
    bool m_comment = false;
    bool m_doubtful = false;  // the last command was unknown
};

}  // namespace boresight::rotctld
