// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/alarms/event_log.h"
#include "core/base/clock.h"

#include <QHash>
#include <QString>

// The log of what a source sends again and again: its first line is written, those behind it are counted, and a line a
// minute says how many there were. The rest is written when the source goes. Station thread only.
namespace boresight {

class StreamLog
{
public:
    static constexpr std::chrono::seconds kPeriod{60};

    enum class Answer
    {
        Accepted,
        Refused
    };

    StreamLog(EventLog& log, const Clock& clock, Answer answer) : m_log(log), m_clock(clock), m_answer(answer) {}

    // True: it begins a stream, and its own line is to be written. Counted else. Another reason of a refusal begins a
    // stream, too.
    [[nodiscard]] bool begins(const QString& source, const QString& command, const QString& reason = {});
    void gone(const QString& source);

private:
    struct Stream
    {
        SteadyTime since{};  // the last line
        SteadyTime last{};
        int count = 0;
        QString command;  // the last
        QString reason;   // of the refusal
    };

    void write(const QString& source, Stream& stream);

    EventLog& m_log;
    const Clock& m_clock;
    Answer m_answer;
    QHash<QString, Stream> m_streams;  // by source
};

}  // namespace boresight
