// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/rotator_box/obedience_watch.h"

namespace boresight {

void ObedienceWatch::sent(Angle target, SteadyTime now)
{
    const bool wasThere = !m_target || (m_place && abs(*m_target - *m_place) <= kMet);
    m_target = target;
    m_stopped.reset();
    if (wasThere) {
        m_progress = now;  // a target that moves on is no excuse for an axis that stands still
        m_sentAgain = false;
    }
}

void ObedienceWatch::stopped(SteadyTime now)
{
    m_target.reset();
    m_stopped = now;
    m_lastStop = now;
}

void ObedienceWatch::release()
{
    m_target.reset();
    m_stopped.reset();
}

void ObedienceWatch::place(Angle place, SteadyTime now)
{
    if (m_place && *m_place != place) {
        if (m_before != place) {  // a change to and fro by one count is noise of the converter
            m_changed = now;
            m_progress = now;
            m_sentAgain = false;
        }
        m_before = m_place;
    }
    m_place = place;
}

ObedienceWatch::Verdict ObedienceWatch::judge(SteadyTime now)
{
    return m_stopped ? judgeStop(now) : m_target ? judgeTarget(now) : Verdict::Obeys;
}

ObedienceWatch::Verdict ObedienceWatch::judgeTarget(SteadyTime now)
{
    if (!m_place || abs(*m_target - *m_place) <= kMet) {
        m_progress = now;
        m_sentAgain = false;
        return Verdict::Obeys;
    }
    if (now - m_progress >= kStuck) {
        return Verdict::Stuck;
    }
    if (!m_sentAgain && now - m_progress >= kSendAgain) {
        m_sentAgain = true;
        return Verdict::SendAgain;
    }
    return Verdict::Obeys;
}

ObedienceWatch::Verdict ObedienceWatch::judgeStop(SteadyTime now)
{
    if (!moves(now)) {
        if (now - *m_stopped >= kStands) {
            m_stopped.reset();  // it was seen standing still
        }
        return Verdict::Obeys;
    }
    if (now - *m_stopped >= kRunsOn) {
        return Verdict::RunsOn;
    }
    if (now - *m_stopped >= kCoast && now - m_lastStop >= std::chrono::seconds(1)) {
        m_lastStop = now;
        return Verdict::StopAgain;
    }
    return Verdict::Obeys;
}

}  // namespace boresight
