// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/alarms/alarm_board.h"

#include "core/base/text.h"

#include <QStringList>

#include <algorithm>
#include <utility>

namespace boresight {
namespace {

constexpr int kLinesPerSecond = 4;  // of one alarm

bool endsSentence(const QString& text)
{
    return text.endsWith(QLatin1Char('.')) || text.endsWith(QLatin1Char('?')) || text.endsWith(QLatin1Char('!'));
}

// "drives.missing.azimuth" as the source of a line.
QString spoken(QString cause)
{
    return cause.replace(QLatin1Char('.'), QLatin1Char(' '));
}

// The parts come from many hands: some whole sentences, some not. The name of a device keeps its first letter.
QString asSentence(const QString& text)
{
    if (text.isEmpty()) {
        return text;
    }
    const QString sentence = endsSentence(text) ? text : text + QLatin1Char('.');
    const auto word = std::ranges::find_if_not(sentence, [](QChar letter) { return letter.isLetter(); });
    const bool plain = word != sentence.end() && *word == QLatin1Char(' ');
    return plain ? sentence[0].toUpper() + sentence.sliced(1) : sentence;
}

}  // namespace

AlarmBoard::AlarmBoard(EventLog& log, const Clock& clock) : m_log(log), m_clock(clock) {}

AlarmBoard::Lines& AlarmBoard::linesOf(const QString& cause)
{
    return m_lines.try_emplace(cause, Lines{.throttle = LogThrottle(m_log, m_clock, kLinesPerSecond)}).first->second;
}

void AlarmBoard::raise(const QString& cause, Severity severity, const AlarmText& text)
{
    const AlarmText whole{.what = asSentence(text.what),
                          .action = asSentence(text.action),
                          .remedy = asSentence(text.remedy),
                          .symptom = text.symptom};
    if (m_alarms.raise(cause, severity, whole, m_clock.utc())) {
        // The line begins with the cause: "azimuth drive: Fault 38: …".
        QStringList line{text.brief.isEmpty() ? whole.what : asSentence(text.brief), whole.action, whole.remedy};
        line.removeAll(QString());
        Lines& lines = linesOf(cause);
        const QString joined = line.join(QLatin1Char(' '));
        const bool added = lines.throttle.add(severity, spoken(cause), joined, LogKind::Alarm);
        lines.told |= added;
        lines.leftOut =
            added ? std::nullopt : std::optional(LeftOut{.severity = severity, .text = joined, .since = m_clock.now()});
    }
}

void AlarmBoard::tick()
{
    for (auto& [cause, lines] : m_lines) {
        if (lines.leftOut && m_clock.now() - lines.leftOut->since >= std::chrono::seconds(1)) {
            lines.told |=
                lines.throttle.add(lines.leftOut->severity, spoken(cause), lines.leftOut->text, LogKind::Alarm);
            lines.leftOut.reset();
        }
    }
}

void AlarmBoard::clear(const QString& cause)
{
    if (!m_alarms.clear(cause)) {
        return;
    }
    Lines& lines = linesOf(cause);
    lines.leftOut.reset();
    if (std::exchange(lines.told, false)) {
        lines.throttle.insist(Severity::Advisory, spoken(cause), Text::tr("the alarm is over"), LogKind::Alarm);
    }
}

}  // namespace boresight
