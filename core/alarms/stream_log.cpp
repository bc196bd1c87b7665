// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/alarms/stream_log.h"

#include "core/base/text.h"

namespace boresight {

bool StreamLog::begins(const QString& source, const QString& command, const QString& reason)
{
    const SteadyTime now = m_clock.now();
    const auto found = m_streams.find(source);
    if (found == m_streams.end() || now - found->last >= kPeriod || found->reason != reason) {
        gone(source);
        m_streams.insert(source, {.since = now, .last = now, .command = {}, .reason = reason});
        return true;
    }
    ++found->count;
    found->last = now;
    found->command = command;
    if (now - found->since >= kPeriod) {
        write(source, *found);
    }
    return false;
}

void StreamLog::gone(const QString& source)
{
    if (const auto found = m_streams.find(source); found != m_streams.end()) {
        write(source, *found);
        m_streams.erase(found);
    }
}

void StreamLog::write(const QString& source, Stream& stream)
{
    if (stream.count > 0) {
        const auto seconds = std::chrono::round<std::chrono::seconds>(stream.last - stream.since).count();
        const QString text = m_answer == Answer::Accepted ? Text::tr("%1 more accepted in %2 s. The last: %3")
                                                          : Text::tr("%1 more refused in %2 s. The last: %3");
        m_log.add(m_answer == Answer::Accepted ? Severity::Advisory : Severity::Warning, source,
                  text.arg(stream.count).arg(seconds).arg(stream.command));
    }
    stream.since = stream.last;
    stream.count = 0;
}

}  // namespace boresight
