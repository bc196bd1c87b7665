// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/rotctld/command_parser.h"

#include "core/rotctld/foreign_protocol.h"

#include <algorithm>

namespace boresight::rotctld {
namespace {

using Event = CommandParser::Event;

constexpr std::size_t kLineHead = 32;       // longer than the longest known opening of a foreign protocol
constexpr std::size_t kMaxNameLength = 32;  // the longest name has 11 letters
constexpr std::size_t kMaxBinaryBytes = 4;  // a stray NUL or umlaut is no foreign protocol

bool isBlank(char byte)
{
    return byte == ' ' || byte == '\t' || byte == '\r' || byte == '\n';
}

bool isWordByte(char byte)
{
    return (byte >= 'a' && byte <= 'z') || (byte >= 'A' && byte <= 'Z') || (byte >= '0' && byte <= '9') || byte == '_';
}

// Any ASCII punctuation except the three characters with another meaning.
bool isSeparator(char byte)
{
    return byte > ' ' && byte < 0x7f && !isWordByte(byte) && byte != '\\' && byte != '#';
}

bool isBinary(unsigned char byte)
{
    return byte >= 0x7f || (byte < ' ' && !isBlank(static_cast<char>(byte)));
}

}  // namespace

Event CommandParser::next(std::string_view& input)
{
    while (!input.empty()) {
        if (m_lineLength >= kMaxLineLength) {
            return Event::TooLong;
        }
        const Event event = step(input);
        if (event != Event::NeedMore) {
            return event;
        }
    }
    return Event::NeedMore;
}

Event CommandParser::step(std::string_view& input)
{
    switch (m_state) {
        case State::Idle:
            return idle(input);
        case State::Plus:
            return plus(input);
        case State::Prefixed: {
            const unsigned char byte = take(input);
            return letter(byte, input);
        }
        case State::Name:
            return name(input);
        case State::Argument:
            return argument(input);
        case State::RestOfLine:
            return restOfLine(input);
        case State::WordEnd:
            return wordEnd(input);
        case State::Ignore:
            return ignore(input);
    }
    return Event::NeedMore;
}

unsigned char CommandParser::take(std::string_view& input)
{
    const char byte = input.front();
    input.remove_prefix(1);
    m_lineLength = byte == '\n' ? 0 : m_lineLength + 1;
    if (m_lineHead.size() < kLineHead) {
        m_lineHead += byte;
    }
    return static_cast<unsigned char>(byte);
}

void CommandParser::startLine()
{
    m_state = State::Idle;
    m_lineHead.clear();
    clearPrefix();
}

void CommandParser::clearPrefix()
{
    m_command.extended = false;
    m_command.separator = '\n';
}

Event CommandParser::idle(std::string_view& input)
{
    if (m_lineHead.empty()) {
        if (const auto opened = openLine(input)) {
            return *opened;
        }
    }
    const unsigned char byte = take(input);
    if (byte == '\n' || (byte == '\r' && m_lineHead.size() == 1)) {
        startLine();
        return Event::NeedMore;
    }
    clearPrefix();
    if (byte == '+') {
        m_state = State::Plus;
        m_command.extended = true;
        return Event::NeedMore;
    }
    if (isSeparator(static_cast<char>(byte))) {
        m_state = State::Prefixed;
        m_command.extended = true;
        m_command.separator = static_cast<char>(byte);
        return Event::NeedMore;
    }
    return letter(byte, input);
}

// Checks that apply only at the start of a line: a foreign protocol, or a long name without its backslash (Look4Sat).
std::optional<Event> CommandParser::openLine(std::string_view& input)
{
    constexpr std::string_view kOrdinary =
        "p\\+|;\r\n";  // these characters open most lines, but no line of a foreign protocol and no bare name
    if (kOrdinary.find(input.front()) != std::string_view::npos) {
        return std::nullopt;
    }
    const std::string_view line = input.substr(0, input.find('\n') + 1);  // the whole input when there is no LF
    if (const auto protocol = foreignProtocolIn(line.empty() ? input : line)) {
        m_foreignProtocol = *protocol;
        return Event::Foreign;
    }
    for (const CommandSpec& spec : commandTable()) {
        const std::size_t length = spec.name.size();
        if (spec.bareName && input.size() > length && input.starts_with(spec.name) && isBlank(input[length])) {
            for (std::size_t i = 0; i < length; ++i) {
                take(input);
            }
            clearPrefix();
            return begin(spec, Spelling::BareName);
        }
    }
    return std::nullopt;
}

Event CommandParser::plus(std::string_view& input)
{
    m_state = State::Prefixed;
    if (isSeparator(input.front())) {
        m_command.separator = static_cast<char>(take(input));
    }
    return Event::NeedMore;
}

// Handles the byte after the prefix, which decides which command follows.
Event CommandParser::letter(unsigned char byte, std::string_view rest)
{
    if (isBlank(static_cast<char>(byte))) {  // "+ p" and "+\np": the prefix is void
        m_state = State::Idle;
        if (byte == '\n') {
            startLine();
        }
        return Event::NeedMore;
    }
    if (byte == '#') {
        m_state = State::Ignore;
        m_comment = true;
        return Event::NeedMore;
    }
    if (byte == '\\') {
        m_state = State::Name;
        m_name.clear();
        return Event::NeedMore;
    }
    const CommandSpec* const spec = findCommand(byte);
    if (spec == nullptr) {
        m_binaryBytes += isBinary(byte) ? 1 : 0;
        return odd();
    }
    return byLetter(*spec, rest);
}

Event CommandParser::byLetter(const CommandSpec& spec, std::string_view rest)
{
    if (spec.start == Start::UnlessGlued && !rest.empty() && !isBlank(rest.front())) {
        return odd();
    }
    const bool waits = spec.start == Start::UnlessGlued && rest.empty() && m_doubtful;
    if (waits || spec.start == Start::AfterItsWord) {
        select(spec, Spelling::Letter);
        m_state = State::WordEnd;
        return Event::NeedMore;
    }
    return begin(spec, Spelling::Letter);
}

Event CommandParser::name(std::string_view& input)
{
    const char byte = static_cast<char>(take(input));
    if (isWordByte(byte) && m_name.size() < kMaxNameLength) {
        m_name += byte;
        return Event::NeedMore;
    }
    const CommandSpec* const spec = findCommand(m_name);
    if (spec != nullptr) {
        const Event event = begin(*spec, Spelling::LongName);
        if (byte == '\n' && m_state == State::Idle) {
            m_lineHead.clear();
        }
        return event;
    }
    if (byte != '\n') {
        return odd();
    }
    startLine();
    return m_name.empty() ? Event::NeedMore : Event::Odd;
}

void CommandParser::select(const CommandSpec& spec, Spelling spelling)
{
    m_command.spec = &spec;
    m_command.spelling = spelling;
    m_command.argumentCount = 0;
    m_command.tooLong = false;
    m_command.arguments[0].clear();
}

Event CommandParser::begin(const CommandSpec& spec, Spelling spelling)
{
    select(spec, spelling);
    if (spec.argumentCount() == 0) {
        return complete();
    }
    m_state = spec.restOfLine ? State::RestOfLine : State::Argument;
    return Event::NeedMore;
}

void CommandParser::addToArgument(char byte)
{
    std::string& text = m_command.arguments[m_command.argumentCount];
    if (text.size() < kMaxArgumentLength) {
        text += byte;
    } else {
        m_command.tooLong = true;
    }
}

// Blanks and line ends before an argument are skipped. The blank after it stays for the next command.
Event CommandParser::argument(std::string_view& input)
{
    std::string& text = m_command.arguments[m_command.argumentCount];
    if (!isBlank(input.front())) {
        addToArgument(static_cast<char>(take(input)));
        return Event::NeedMore;
    }
    if (text.empty()) {
        take(input);
        return Event::NeedMore;
    }
    ++m_command.argumentCount;
    if (m_command.argumentCount == m_command.spec->argumentCount() || m_command.arguments[0].front() == '?') {
        return complete();
    }
    m_command.arguments[m_command.argumentCount].clear();
    return Event::NeedMore;
}

Event CommandParser::restOfLine(std::string_view& input)
{
    if (input.front() == '\n') {
        m_command.argumentCount = 1;
        return complete();
    }
    const char byte = static_cast<char>(take(input));
    if (byte != '\r' && !(m_command.arguments[0].empty() && isBlank(byte))) {
        addToArgument(byte);
    }
    return Event::NeedMore;
}

Event CommandParser::wordEnd(std::string_view& input)
{
    return isBlank(input.front()) ? complete() : odd();
}

Event CommandParser::complete()
{
    m_state = State::Idle;
    m_binaryBytes = 0;
    m_doubtful = false;
    return Event::Command;
}

Event CommandParser::odd()
{
    m_state = State::Ignore;
    m_comment = false;
    m_doubtful = true;
    const Event foreignProtocol = checkForeignProtocol();
    return foreignProtocol == Event::Foreign ? foreignProtocol : Event::Odd;
}

Event CommandParser::ignore(std::string_view& input)
{
    const unsigned char byte = take(input);
    if (m_comment) {
        if (byte == '\n') {
            startLine();
        }
        return Event::NeedMore;
    }
    m_binaryBytes += isBinary(byte) ? 1 : 0;
    const Event event = byte == '\n' || m_binaryBytes > kMaxBinaryBytes ? checkForeignProtocol() : Event::NeedMore;
    if (byte == '\n') {
        startLine();
    }
    return event;
}

Event CommandParser::checkForeignProtocol()
{
    if (m_binaryBytes > kMaxBinaryBytes) {
        m_foreignProtocol = "binary data";
        return Event::Foreign;
    }
    const auto protocol = foreignProtocolIn(m_lineHead);
    m_foreignProtocol = protocol.value_or("");
    return protocol ? Event::Foreign : Event::NeedMore;
}

Event CommandParser::skipLine()
{
    if (m_state != State::Idle || m_lineHead.empty()) {
        return Event::NeedMore;
    }
    m_state = State::Ignore;
    m_comment = false;
    return checkForeignProtocol();
}

Event CommandParser::finish()
{
    const bool lastArgument = m_state == State::Argument && !m_command.arguments[m_command.argumentCount].empty() &&
                              m_command.argumentCount + 1 == m_command.spec->argumentCount();
    if (lastArgument || m_state == State::RestOfLine) {
        ++m_command.argumentCount;
        return complete();
    }
    return m_state == State::WordEnd ? complete() : Event::NeedMore;
}

}  // namespace boresight::rotctld
