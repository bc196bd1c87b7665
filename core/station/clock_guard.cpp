// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/station/clock_guard.h"

#include "core/alarms/catalogue.h"
#include "core/base/text.h"

#include <cmath>

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

void ClockGuard::tick()
{
    static_cast<void>(m_utc.now(m_clock));
    const Seconds step = m_utc.jump();
    if (const Seconds slept = m_sleep.sleptSince(m_clock); slept > Seconds(0.0)) {
        noticeSleep(slept);
    }
    if (std::chrono::abs(step) > sources::SteeredUtc::kSet) {
        noticeStep(step);
    }
    if (const SteadyTime now = m_clock.now(); !m_asked || now - *m_asked >= kBetweenQuestions) {
        m_asked = now;
        m_status = {.synchronised = m_clock.synchronised(), .error = m_clock.error()};
    }
}

// An alarm that is raised and cleared at once stays on the screen until it is acknowledged.
void ClockGuard::noticeSleep(Seconds slept)
{
    const QString seconds = QString::number(slept.count(), 'f', 1);
    m_log.add(Severity::Warning, kSource, Text::tr("this computer was suspended for %1 s").arg(seconds));
    m_alarms.raise(alarmEntry("computer.slept"), {seconds});
    m_alarms.clear(alarmEntry("computer.slept"));
}

void ClockGuard::noticeStep(Seconds step)
{
    m_log.add(Severity::Warning, kSource, Text::tr("the clock of this computer was set by %1 s").arg(signedText(step)));
    m_alarms.raise(alarmEntry("clock.set"), {signedText(step)});
    m_alarms.clear(alarmEntry("clock.set"));
}

}  // namespace boresight
