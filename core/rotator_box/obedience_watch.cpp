// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/rotator_box/obedience_watch.h"

#include <algorithm>

namespace boresight {
namespace {

constexpr Angle kRounding = Angle::fromDegrees(1e-6);

bool isNear(Angle target, Angle place)
{
    return abs(target - place) <= ObedienceWatch::kMet + kRounding;
}

}  // namespace

void ObedienceWatch::sent(Angle target, SteadyTime now)
{
    const bool wasThere = !m_target || (m_place && isNear(*m_target, *m_place));
    const double way = m_place && target < *m_place ? -1.0 : 1.0;
    if (wasThere || way != m_way) {
        m_way = way;
        m_reached = m_place;
    }
    m_target = target;
    m_stopped.reset();
    if (wasThere) {
        m_progress = now;  // a target that moves on is no excuse for an axis that stands
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
    m_same = m_place ? TravelRange{.min = std::min(m_same.min, place), .max = std::max(m_same.max, place)}
                     : TravelRange{.min = place, .max = place};
    if (m_same.max - m_same.min > m_noise + kRounding) {
        m_same = place == m_same.max ? TravelRange{.min = place - m_noise, .max = place}
                                     : TravelRange{.min = place, .max = place + m_noise};
        m_changed = now;
    }
    // A slow motor takes long for more than the noise. It comes nearer all the same, which noise does twice at most.
    if (m_changed == now || !m_reached || m_way * (place - *m_reached) > kRounding) {
        m_reached = place;
        m_progress = now;
        m_sentAgain = false;
    }
    m_place = place;
}

ObedienceWatch::Verdict ObedienceWatch::judge(SteadyTime now)
{
    return m_stopped ? judgeStop(now) : m_target ? judgeTarget(now) : Verdict::Obeys;
}

ObedienceWatch::Verdict ObedienceWatch::judgeTarget(SteadyTime now)
{
    if (!m_place || isNear(*m_target, *m_place)) {
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
            m_stopped.reset();  // seen to stand
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
