// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/azel/azel_feed.h"

#include "core/base/text.h"

#include <cmath>

namespace boresight::azel {
namespace {

using Days = std::chrono::days;

// The time from the shown time of day to `utc`, on the nearest day: -12 h to 12 h.
UtcTime::duration sinceShown(std::chrono::seconds timeOfDay, UtcTime utc)
{
    constexpr UtcTime::duration kDay = Days(1);
    const UtcTime::duration apart = utc - std::chrono::floor<Days>(utc) - timeOfDay;
    return apart > kDay / 2 ? apart - kDay : apart < -kDay / 2 ? apart + kDay : apart;
}

}  // namespace

void AzelFeed::take(const AzelReading& reading, SteadyTime now, UtcTime utc)
{
    if (reading.path != m_path) {
        *this = {};
        m_path = reading.path;
    }
    m_written = reading.written;
    if (reading.text) {
        m_problem.reset();
        takeText(*reading.text, now, utc);
        return;
    }
    m_wrongSince = m_problem ? m_wrongSince : now;
    m_problem = reading.text.error();
}

void AzelFeed::takeText(const AzelText& text, SteadyTime now, UtcTime utc)
{
    if (m_text && m_text->timeOfDay == text.timeOfDay) {
        m_text = text;  // the flag R or T may have changed
        return;
    }
    if (m_text) {
        m_changed = now;
    }
    m_text = text;
    const UtcTime::duration since = sinceShown(text.timeOfDay, utc);
    m_time = utc - since;
    m_clockOff = since;
}

std::optional<Seconds> AzelFeed::age(SteadyTime now, UtcTime utc) const
{
    if (m_changed) {
        return now - *m_changed;
    }
    return m_text && m_written ? std::optional<Seconds>(utc - *m_written) : std::optional<Seconds>();
}

QString AzelFeed::problem(SteadyTime now) const
{
    const bool isPatient = m_text && now - m_wrongSince < kPatience;
    return m_problem && !isPatient ? m_problem->text : QString();
}

Result<> AzelFeed::isFresh(SteadyTime now) const
{
    if (!m_text) {
        return failure(ErrorCode::NoAnswer, m_problem ? m_problem->text : Text::tr("the file was not read yet"));
    }
    if (!m_changed || now - *m_changed > kStale) {
        return failure(ErrorCode::NoAnswer, Text::tr("nothing writes the file. Open Astronomical Data in WSJT-X"));
    }
    if (std::abs(m_clockOff.count()) > Seconds(kStale).count()) {
        return failure(ErrorCode::NoAnswer, Text::tr("the time in the file and the clock of this computer differ by "
                                                     "%1 s")
                                                .arg(std::abs(m_clockOff.count()), 0, 'f', 0));
    }
    return {};
}

}  // namespace boresight::azel
