// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/rotctld/line_session.h"

#include "core/base/control_characters.h"
#include "core/base/text.h"
#include "core/rotctld/command_parser.h"
#include "core/rotctld/foreign_protocol.h"

#include <utility>

namespace boresight::rotctld {
namespace {

constexpr std::string_view kLineEnds = "\r\n";

// True for programs that use no rotator protocol at all. Only HTTP and TLS, because other openings may be valid in this
// protocol.
bool speaksOtherwise(std::string_view line)
{
    const auto foreignProtocol = foreignProtocolIn(line);
    return foreignProtocol && (*foreignProtocol == "HTTP" || *foreignProtocol == "TLS");
}

}  // namespace

LineSession::LineSession(Client client, std::unique_ptr<LineProtocol> protocol, Rotator& rotator, const Clock& clock)
    : m_client(std::move(client)),
      m_protocol(std::move(protocol)),
      m_rotator(rotator),
      m_clock(clock),
      m_habits(clock.now())
{}

bool LineSession::step(std::string& reply)
{
    if (!m_ending.isEmpty()) {
        return false;
    }
    const std::size_t begin = m_input.find_first_not_of(kLineEnds, m_taken);
    const std::size_t end = begin == std::string::npos ? begin : m_input.find_first_of(kLineEnds, begin);
    if (end == std::string::npos) {
        m_input.erase(0, std::min(begin, m_input.size()));
        m_taken = 0;
        wait();
        return !m_ending.isEmpty();
    }
    m_taken = end + 1;
    run(std::string_view(m_input).substr(begin, end - begin), reply);
    return true;
}

// Waits for the rest of a line.
void LineSession::wait()
{
    if (m_input.size() > kMaxLineLength) {
        drop(Text::tr("sent %1 bytes without a line end").arg(QString::number(kMaxLineLength)));
    } else if (m_inputEnded) {
        m_ending = Text::tr("closed the connection");
    }
}

void LineSession::run(std::string_view line, std::string& reply)
{
    const LineOutcome outcome = obey(line);
    reply += outcome.reply;
    if (m_rotator.isLoggingExchanges()) {
        logLine(line, outcome);
    }
}

LineOutcome LineSession::obey(std::string_view line)
{
    if (speaksOtherwise(line)) {
        drop(Text::tr("is not a program for rotators (%1)").arg(shownText(line)));
        return {.reply = {}, .result = failure(ErrorCode::InvalidInput, m_ending)};
    }
    LineOutcome outcome = m_protocol->obey(line);
    m_habits.take(line.substr(0, kShownBytes), outcome, m_clock.now());
    m_habits.answered(outcome.result, outcome.became);
    if (isOdd(outcome)) {
        odd(line);
    } else {
        m_oddInARow = 0;
    }
    return outcome;
}

// An opening of another protocol is logged as an odd command, too.
void LineSession::logLine(std::string_view line, const LineOutcome& outcome)
{
    m_rotator.logExchange(m_client, {.line = line,
                                     .answer = outcome.reply,
                                     .result = outcome.result,
                                     .became = outcome.became,
                                     .odd = isOdd(outcome)});
}

void LineSession::odd(std::string_view line)
{
    m_habits.countOdd();
    if (m_habits.oddCommands() <= kOddRemarks) {
        m_rotator.clientRemark(m_client, Text::tr("unknown command \"%1\"").arg(shownText(line)));
    }
    if (++m_oddInARow >= kMaxOddInARow) {
        drop(Text::tr("sent %1 unknown commands in a row").arg(QString::number(kMaxOddInARow)));
    }
}

void LineSession::drop(const QString& reason)
{
    m_ending = reason;
    m_dropped = true;
}

}  // namespace boresight::rotctld
