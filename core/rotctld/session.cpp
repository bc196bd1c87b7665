// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/rotctld/session.h"

#include "core/base/control_characters.h"
#include "core/base/text.h"
#include "core/rotctld/c_number.h"

#include <algorithm>
#include <utility>

namespace boresight::rotctld {
namespace {

using Event = CommandParser::Event;

constexpr std::size_t kMaxWaitingInPause = 4096;  // bytes

// The command is invalid, or asks for something that the mount does not have.
bool isOdd(const Error& error)
{
    return error.code == ErrorCode::InvalidInput || error.code == ErrorCode::NotAvailable;
}

}  // namespace

Session::Session(Client client, Rotator& rotator, const Clock& clock, DumpStateForm dumpState)
    : m_client(std::move(client)), m_rotator(rotator), m_clock(clock), m_dumpState(dumpState), m_habits(clock.now())
{}

StartConversation talkRotctld(Rotator& rotator, const Clock& clock, DumpStateForm dumpState)
{
    return [&rotator, &clock, dumpState](Client client) -> std::unique_ptr<Conversation> {
        return std::make_unique<Session>(std::move(client), rotator, clock, dumpState);
    };
}

void Session::receive(std::string_view bytes)
{
    m_input.append(bytes);
    if (paused() && m_input.size() - m_taken > kMaxWaitingInPause) {
        drop(
            Text::tr("sent more than %1 bytes during the pause it asked for").arg(QString::number(kMaxWaitingInPause)));
    }
}

void Session::endOfInput()
{
    m_inputEnded = true;
    if (paused()) {
        // A half-closed connection looks the same as a client that has left. And a park command of a client that has
        // left must not run minutes later.
        m_ending = Text::tr("closed the connection during the pause it asked for");
    }
}

bool Session::step(std::string& reply)
{
    if (!m_ending.isEmpty()) {
        return false;
    }
    if (m_pause) {
        return resume(reply);
    }
    const std::string_view unread = std::string_view(m_input).substr(m_taken);
    std::string_view rest = unread;
    const Event event = m_parser.next(rest);
    m_taken = m_input.size() - rest.size();
    keep(unread.substr(0, unread.size() - rest.size()));
    switch (event) {
        case Event::NeedMore:
            return inputTaken(reply);
        case Event::Command:
            run(reply);
            break;
        case Event::Odd:
            unknown(rest);
            logUnread({});
            break;
        case Event::Foreign:
            endAsForeign();
            logUnread(m_ending);
            break;
        case Event::TooLong:
            drop(Text::tr("sent %1 bytes without a line end").arg(QString::number(kMaxLineLength)));
            logUnread(m_ending);
            break;
    }
    return true;
}

bool Session::resume(std::string& reply)
{
    if (m_clock.now() < m_pause->until) {
        return false;
    }
    const std::string answer = std::exchange(m_pause, std::nullopt)->reply;
    reply += answer;
    if (m_rotator.isLoggingExchanges()) {
        m_rotator.logExchange(m_client, {.command = "pause", .answer = answer});
    }
    return true;
}

void Session::endAsForeign()
{
    drop(Text::tr("is not a rotctld client (%1)").arg(toQString(m_parser.foreignProtocol())));
}

void Session::drop(const QString& reason)
{
    m_ending = reason;
    m_dropped = true;
}

bool Session::inputTaken(std::string& reply)
{
    m_input.clear();
    m_taken = 0;
    if (!m_inputEnded) {
        return false;
    }
    if (m_parser.finish() == Event::Command) {
        run(reply);
    } else {
        m_ending = Text::tr("closed the connection");
    }
    return true;
}

// Only the protocol log wants the bytes of a command.
void Session::keep(std::string_view bytes)
{
    if (m_rotator.isLoggingExchanges()) {
        m_line.add(bytes);
    } else {
        m_line.forget();
    }
}

// Adds the bytes of the command that was read last. The rest of a failed line is ignored.
void Session::logLine(Exchange exchange)
{
    if (!exchange.result) {
        m_line.addIgnored(std::string_view(m_input).substr(m_taken));
    }
    exchange.line = m_line.bytes();
    exchange.size = m_line.size();
    m_rotator.logExchange(m_client, exchange);
    m_line.end();
}

void Session::logUnread(const QString& reason)
{
    if (m_rotator.isLoggingExchanges()) {
        logLine({.result = failure(ErrorCode::InvalidInput, reason), .odd = true});
    }
}

void Session::run(std::string& reply)
{
    const std::size_t before = reply.size();
    const std::uint64_t odd = m_habits.oddCommands();
    QString became;
    const Result<> outcome = obey(reply, became);
    if (m_rotator.isLoggingExchanges()) {
        logLine({.command = m_parser.command().spec->name,
                 .answer = std::string_view(reply).substr(before),
                 .result = outcome,
                 .became = became,
                 .odd = m_habits.oddCommands() != odd});
    }
}

Result<> Session::obey(std::string& reply, QString& became)
{
    const Command& command = m_parser.command();
    m_habits.take(command, m_clock.now());
    if (command.spec->id == CommandId::Quit) {
        m_ending = Text::tr("ended the session");
        return {};
    }
    const std::size_t before = reply.size();
    ReplyWriter writer(command, reply);
    Result<> outcome = execute(command, writer, became);
    writer.finish(outcome);
    m_habits.answered(outcome, became);
    if (command.spec->id != CommandId::GetOutcome) {
        m_outcome = boresight::printable(outcome ? became : outcome.error().text);
    }
    if (outcome || !isOdd(outcome.error())) {
        m_habits.understood(command);
    }
    if (!outcome) {
        failed(outcome.error(), reply, before);
        return outcome;
    }
    m_oddInARow = 0;
    if (m_pause) {
        m_pause->reply = reply.substr(before);
        reply.resize(before);
    }
    return outcome;
}

void Session::failed(const Error& error, std::string& reply, std::size_t replyStart)
{
    if (isOdd(error)) {
        odd(Text::tr("\"%1\" refused: %2").arg(m_habits.lastCommand(), boresight::printable(error.text)));
    }
    if (m_parser.skipLine() == Event::Foreign) {
        reply.resize(replyStart);
        endAsForeign();
    }
}

Result<> Session::execute(const Command& command, ReplyWriter& writer, QString& became)
{
    if (command.spec->id == CommandId::Pause) {
        return pause(command);
    }
    if (command.spec->id == CommandId::GetOutcome) {
        writer.value(m_outcome.toStdString());
        return {};
    }
    return runCommand(command, {.rotator = m_rotator, .client = m_client, .outcome = became, .dumpState = m_dumpState},
                      writer);
}

// Only this client waits. Hamlib sleeps with its lock held, so nobody could stop the mount during that time.
Result<> Session::pause(const Command& command)
{
    const auto seconds = leadingInteger(command.arguments[0]);
    if (!seconds || *seconds < 0) {
        return badArgument(command, 0);
    }
    if (*seconds > 0) {
        m_pause = Pause{.until = m_clock.now() + std::chrono::seconds(*seconds)};
    }
    return {};
}

void Session::unknown(std::string_view restOfLine)
{
    std::string line(m_parser.lineHead());
    line.append(restOfLine.substr(0, std::min(restOfLine.find('\n'), kShownBytes)));
    odd(Text::tr("unknown command \"%1\"").arg(shownText(line)));
    if (++m_oddInARow >= kMaxOddInARow) {
        drop(Text::tr("sent %1 unknown commands in a row").arg(QString::number(kMaxOddInARow)));
    }
}

void Session::odd(const QString& text)
{
    m_habits.countOdd();
    if (m_habits.oddCommands() <= kOddRemarks) {
        m_rotator.clientRemark(m_client, text);
    }
}

}  // namespace boresight::rotctld
