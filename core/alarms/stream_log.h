// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/alarms/event_log.h"
#include "core/base/clock.h"

#include <QHash>
#include <QString>

// The log of a source that sends the same thing again and again. Its first line is written. Later ones are counted, and
// a line each minute gives the number. The last number is written when the source is gone. Station thread only.
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

    // True: the line begins a stream and must be written. False: it is only counted. A different reason of a refusal
    // begins a new stream.
    [[nodiscard]] bool begins(const QString& source, const QString& command, const QString& reason = {});
    void gone(const QString& source);

private:
    struct Stream
    {
        SteadyTime since{};  // time of the last line
        SteadyTime last{};
        int count = 0;
        QString command;  // the last command
        QString reason;   // of the refusal
    };

    void write(const QString& source, Stream& stream);

    EventLog& m_log;
    const Clock& m_clock;
    Answer m_answer;
    QHash<QString, Stream> m_streams;  // by source
};

}  // namespace boresight
