// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/computer_clock/clock_guard.h"

#include "core/alarms/catalogue.h"
#include "core/base/text.h"

#include <utility>

namespace boresight {
namespace {

constexpr std::chrono::seconds kBetweenQuestions{1};
const QString kSource = QStringLiteral("station");

// "+90.0"
QString signedText(Seconds time)
{
    return (time < Seconds(0.0) ? QString() : QStringLiteral("+")) + QString::number(time.count(), 'f', 1);
}

}  // namespace

ClockGuard::ClockGuard(KeptClock& clock, EventLog& log, AlarmBoard& alarms, Effect effect)
    : m_clock(clock), m_log(log), m_alarms(alarms), m_effect(std::move(effect)), m_sleep(clock)
{}

bool ClockGuard::tick()
{
    const SteadyTime now = m_clock.now();
    const bool due = !m_asked || now - *m_asked >= kBetweenQuestions;
    if (!m_asked) {
        m_clock.follow();
    }
    noticeSleep();
    const bool wasSet = noticeStep(due);
    if (due) {
        m_asked = now;
        m_status.synchronised = m_clock.synchronised();
        m_status.error = m_clock.error();
        m_wasConfirmed = m_wasConfirmed || (!m_status.ahead && m_clock.isConfirmed());
    }
    return wasSet;
}

// An alarm that is raised and cleared at once stays on the screen until it is acknowledged.
void ClockGuard::noticeSleep()
{
    const Seconds slept = m_sleep.sleptSince(m_clock);
    if (slept <= Seconds(0.0)) {
        return;
    }
    const QString seconds = QString::number(slept.count(), 'f', 1);
    m_log.add(Severity::Warning, kSource, Text::tr("this computer was suspended for %1 s").arg(seconds));
    m_alarms.raise(alarmEntry("computer.slept"), {seconds});
    m_alarms.clear(alarmEntry("computer.slept"));
}

bool ClockGuard::noticeStep(bool due)
{
    const Seconds ahead = m_clock.ahead();
    if (ahead == Seconds(0.0)) {
        if (m_status.ahead) {
            m_log.add(Severity::Advisory, kSource, Text::tr("the clock of this computer has the time before again"));
        }
        follow();
        return false;
    }
    const bool isNew = !m_status.ahead || std::chrono::abs(ahead - *m_status.ahead) > KeptClock::kSet;
    if (isNew || due) {
        judge(isNew ? ahead : *m_status.ahead);
    }
    return isNew;
}

// The time before counts more than a time source that contradicts it in the middle of a pass. Without a time source the
// new time counts only when it changes nothing.
void ClockGuard::judge(Seconds ahead)
{
    const TimeEffect effect = m_effect(ahead);
    const bool mayUse = m_clock.isConfirmed() ? !m_wasConfirmed || !effect.moves : !effect.isAny();
    if (!mayUse) {
        keep(ahead, effect.shift);
        return;
    }
    m_log.add(Severity::Warning, kSource,
              Text::tr("the clock of this computer was set by %1 s").arg(signedText(ahead)));
    m_alarms.raise(alarmEntry("clock.set"), {signedText(ahead)});
    m_alarms.clear(alarmEntry("clock.set"));
    m_wasConfirmed = m_clock.isConfirmed();
    follow();
}

void ClockGuard::keep(Seconds ahead, const QString& shift)
{
    m_status.ahead = ahead;
    m_alarms.raise(alarmEntry("clock.kept"),
                   {signedText(ahead), shift.isEmpty() ? shift : QStringLiteral(": ") + shift});
}

void ClockGuard::follow()
{
    m_clock.follow();
    if (std::exchange(m_status.ahead, std::nullopt)) {
        m_alarms.clear(alarmEntry("clock.kept"));
    }
}

Result<> ClockGuard::useNewTime(const Source& by)
{
    if (!m_status.ahead) {
        return failure(ErrorCode::Refused, Text::tr("Boresight already uses the time of this computer."));
    }
    m_log.add(Severity::Warning, by.name,
              Text::tr("uses the new time of this computer (%1 s)").arg(signedText(*m_status.ahead)));
    m_wasConfirmed = m_clock.isConfirmed();
    follow();
    return {};
}

}  // namespace boresight
