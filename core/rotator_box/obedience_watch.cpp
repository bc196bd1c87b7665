// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/rotator_box/obedience_watch.h"

#include <algorithm>
#include <utility>

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
        m_progress = now;  // a target that moves on is no excuse for an axis that stands still
        m_sentAgain = false;
    }
}

void ObedienceWatch::stopped(SteadyTime now)
{
    m_target.reset();
    m_stopped = now;
    m_lastStop = now;
    m_repeats = 0;
    m_widened = now;
    m_passed = {.min = m_place.value_or(Angle{}), .max = m_place.value_or(Angle{})};
}

void ObedienceWatch::release()
{
    m_target.reset();
    m_stopped.reset();
}

bool ObedienceWatch::leavesNoise(Angle place)
{
    m_same = m_place ? TravelRange{.min = std::min(m_same.min, place), .max = std::max(m_same.max, place)}
                     : TravelRange{.min = place, .max = place};
    if (m_same.max - m_same.min <= m_noise + kRounding) {
        return false;
    }
    m_same = place == m_same.max ? TravelRange{.min = place - m_noise, .max = place}
                                 : TravelRange{.min = place, .max = place + m_noise};
    return true;
}

bool ObedienceWatch::isNoFlicker(Angle place)
{
    if (!m_place || *m_place == place) {
        return false;
    }
    return std::exchange(m_before, m_place) != place;
}

void ObedienceWatch::place(Angle place, SteadyTime now)
{
    const bool isNoisy = m_noise > Angle{};
    const bool moves = isNoisy ? leavesNoise(place) : isNoFlicker(place);
    if (moves) {
        m_changed = now;
    }
    // A slow motor takes long for more than the noise. It comes nearer all the same, which noise does twice at most.
    if (moves || (isNoisy && (!m_reached || m_way * (place - *m_reached) > kRounding))) {
        m_reached = place;
        m_progress = now;
        m_sentAgain = false;
    }
    if (m_stopped && isNoisy && m_place) {
        watchStop(place, now);
    }
    m_place = place;
}

// A slow motor that does not stop takes long for more than the noise.
void ObedienceWatch::watchStop(Angle place, SteadyTime now)
{
    const TravelRange before = m_passed;
    m_passed = {.min = std::min(before.min, place), .max = std::max(before.max, place)};
    m_widened = m_passed == before ? m_widened : now;
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
    const bool goesOn = moves(now) || now - m_widened < kStands;
    const bool isMotion = moves(now) || m_passed.max - m_passed.min > m_noise + kRounding;
    if (!goesOn) {
        m_stopped.reset();  // it was seen standing still
        return Verdict::Obeys;
    }
    if (!isMotion || now - *m_stopped < kCoast || now - m_lastStop < std::chrono::seconds(1)) {
        return Verdict::Obeys;
    }
    if (m_repeats == kMostRepeats) {
        return Verdict::RunsOn;
    }
    ++m_repeats;
    m_lastStop = now;
    return Verdict::StopAgain;
}

}  // namespace boresight
