// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/link/direction_question.h"

namespace boresight::ui {

namespace {

constexpr std::chrono::seconds kAskedAgainAfter{1};

}  // namespace

void DirectionQuestion::ask(const SkyPointing& direction)
{
    if (direction != m_direction) {
        drop();
        m_direction = direction;
    }
    send();
}

void DirectionQuestion::drop()
{
    ++m_number;
    m_direction.reset();
    m_verdict = {};
    m_waits = false;
}

void DirectionQuestion::showStatus(const StationStatus& status)
{
    const bool otherProfile = status.profile != m_profile;
    m_profile = status.profile;
    m_now = status.utc;
    const bool old = m_now < m_sent || m_now - m_sent >= kAskedAgainAfter;
    if (m_direction && (otherProfile || (old && !m_waits))) {
        send();
    }
}

QString DirectionQuestion::whyNot() const
{
    return m_verdict.whyNot.isEmpty() ? QString() : tr("forbidden: %1").arg(m_verdict.whyNot);
}

void DirectionQuestion::send()
{
    m_waits = true;
    m_sent = m_now;
    m_desk.ask(request::JudgeDirection{*m_direction}, this, [this, number = ++m_number](const Answer& answer) {
        if (number == m_number) {
            take(answer);
        }
    });
}

void DirectionQuestion::take(const Answer& answer)
{
    m_waits = false;
    if (answer.verdict) {
        m_verdict = *answer.verdict;
        Q_EMIT answered();
    }
}

}  // namespace boresight::ui

#include "moc_direction_question.cpp"
