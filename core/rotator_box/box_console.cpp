// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/rotator_box/box_console.h"

#include "core/base/control_characters.h"
#include "core/base/text.h"

#include <utility>

namespace boresight {
namespace {

// A damaged byte must not spoil the log.
QStringList shownLines(const std::string& bytes)
{
    QStringList lines;
    const QStringList all = toQString(bytes).replace(u'\r', u'\n').split(u'\n', Qt::SkipEmptyParts);
    for (const QString& line : all) {
        lines << printable(line);
    }
    return lines;
}

}  // namespace

Result<> BoxConsole::admits(const RotatorTalk& talk, bool answers) const
{
    if (!talk.takesLines()) {
        return failure(ErrorCode::NotAvailable, Text::tr("this rotator does not have this function"));
    }
    if (talk.proof() != RotatorTalk::Proof::Box || !answers) {
        return failure(ErrorCode::NoAnswer, Text::tr("The control box does not answer."));
    }
    return isBusy() ? failure(ErrorCode::Refused, Text::tr("The answer to the last line is awaited. Wait a second."))
                    : Result<>{};
}

std::string BoxConsole::send(RotatorTalk& talk, SteadyTime now)
{
    std::string bytes = m_waiting.empty() ? std::string() : talk.type(m_waiting, kListens, now);
    if (!bytes.empty()) {
        show(QStringLiteral("> ") + toQString(std::exchange(m_waiting, {})));
        m_heard.clear();
        m_until = now + kListens;
    }
    return bytes;
}

void BoxConsole::take(std::string_view bytes)
{
    if (m_until) {
        m_heard += bytes.substr(0, kLongestAnswer - m_heard.size());
    }
}

bool BoxConsole::ends(SteadyTime now)
{
    if (!m_until || now < *m_until) {
        return false;
    }
    m_until.reset();
    const QStringList answer = shownLines(m_heard);
    for (const QString& line : answer) {
        show(line);
    }
    if (answer.isEmpty()) {
        show(Text::tr("(no answer)"));
    }
    m_answer = answer.join(QStringLiteral(" | "));
    return true;
}

void BoxConsole::drop()
{
    m_waiting.clear();
    m_until.reset();
}

std::optional<QString> BoxConsole::takeAnswer()
{
    return std::exchange(m_answer, std::nullopt);
}

void BoxConsole::show(const QString& line)
{
    m_lines << line;
    while (m_lines.size() > kKept) {
        m_lines.removeFirst();
    }
}

}  // namespace boresight
