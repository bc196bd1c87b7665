// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/alarms/alarm_board.h"

#include "core/base/text.h"

#include <QStringList>

#include <utility>

namespace boresight {
namespace {

constexpr int kLinesPerSecond = 4;  // of one alarm

}  // namespace

AlarmBoard::AlarmBoard(EventLog& log, const Clock& clock) : m_log(log), m_clock(clock) {}

AlarmBoard::Lines& AlarmBoard::linesOf(const AlarmKey& key)
{
    const std::pair place(key.entry->place(), key.about);
    return m_lines
        .try_emplace(place, Lines{.source = logSource(key), .throttle = LogThrottle(m_log, m_clock, kLinesPerSecond)})
        .first->second;
}

void AlarmBoard::raise(const AlarmKey& key, const QStringList& arguments)
{
    raise(key, key.entry->severity, arguments);
}

void AlarmBoard::raise(const AlarmKey& key, Severity severity, const QStringList& arguments)
{
    Q_ASSERT(severity == key.entry->severity || severity == key.entry->worst);
    Q_ASSERT(arguments.size() == key.entry->argumentCount());
    if (const auto text = m_alarms.raise(key, severity, arguments, m_clock.utc())) {
        // The line begins with its source: "azimuth drive: Fault 38: …".
        QStringList line{text->brief, text->action, text->remedy};
        line.removeAll(QString());
        Lines& lines = linesOf(key);
        lines.what = text->brief;
        lines.alarm = {.name = QString::fromLatin1(key.entry->id), .about = key.about};
        const QString joined = line.join(QLatin1Char(' '));
        const bool added = lines.throttle.add(severity, lines.source, joined, LogKind::Alarm, lines.alarm);
        lines.told |= added;
        lines.leftOut =
            added ? std::nullopt : std::optional(LeftOut{.severity = severity, .text = joined, .since = m_clock.now()});
    }
}

void AlarmBoard::tick()
{
    for (auto& [place, lines] : m_lines) {
        if (lines.leftOut && m_clock.now() - lines.leftOut->since >= std::chrono::seconds(1)) {
            lines.told |= lines.throttle.add(lines.leftOut->severity, lines.source, lines.leftOut->text, LogKind::Alarm,
                                             lines.alarm);
            lines.leftOut.reset();
        }
    }
}

void AlarmBoard::clear(const AlarmKey& key)
{
    if (!m_alarms.clear(key)) {
        return;
    }
    Lines& lines = linesOf(key);
    lines.leftOut.reset();
    if (std::exchange(lines.told, false)) {
        lines.throttle.insist(Severity::Advisory, lines.source, Text::tr("Cleared: %1").arg(lines.what), LogKind::Alarm,
                              lines.alarm);
    }
}

}  // namespace boresight
