// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/supervision/place_belief.h"

#include <algorithm>

namespace boresight::supervision {
namespace {

// Wind and control may drive an axis faster than its profile.
constexpr double kFaster = 1.5;
// The shortest time from standing still to that speed or back. A hard obstacle stops an axis this fast.
constexpr Seconds kSpeedsUpIn{0.05};
// The estimated rate follows half as fast, so that a reply with a small error does not spoil it. This is still faster
// than a drive brakes by its own ramp.
constexpr double kRateFollows = 0.5;
// If one reply in ten is false, three false ones in a row with errors below the allowance come once in hours. So one of
// four believed places is true.
constexpr std::size_t kCourses = 4;

// Where the axis is expected at the time of the reply.
MotorTurns ahead(MotorTurns place, const std::optional<MotorRate>& rate, Seconds time)
{
    return place + rate.value_or(MotorRate{}) * time;
}

}  // namespace

// By how much the rate can change within this time.
MotorRate PlaceBelief::gain(const Course& course, Seconds within) const
{
    const double share = course.rate ? std::clamp(within / kSpeedsUpIn, 0.0, 1.0) : 1.0;
    return m_limits.speed * (kFaster * share);
}

MotorTurns PlaceBelief::miss(const Course& course, const Reply& reply)
{
    return abs(*reply.place - ahead(course.place, course.rate, reply.asked - course.asked));
}

// Whether the axis can have moved to this place. The drive measures at any time between question and reply. The motion
// took at least from the first reply to the second question, and at most from the first question to the second reply.
bool PlaceBelief::reaches(const Course& course, const Reply& reply) const
{
    const Seconds longest = std::max(Seconds(reply.received - course.asked), Seconds(0.0));
    const Seconds shortest = std::max(Seconds(reply.asked - course.received), Seconds(0.0));
    const MotorRate rate = course.rate.value_or(MotorRate{});
    const auto [least, most] = std::minmax({rate * shortest, rate * longest});
    const MotorTurns slack = gain(course, longest) * longest + m_limits.allowance;
    const MotorTurns moved = *reply.place - course.place;
    return moved >= least - slack && moved <= most + slack;
}

// The rate is computed between the times of the questions, because replies may come late.
PlaceBelief::Course PlaceBelief::continued(const Course& course, const Reply& reply) const
{
    const Seconds passed = reply.asked - course.asked;
    Course next{.place = *reply.place, .rate = course.rate, .asked = reply.asked, .received = reply.received};
    if (passed > Seconds(0.0)) {
        const MotorRate rate = course.rate.value_or(MotorRate{});
        const MotorRate more = gain(course, passed) * (course.rate ? kRateFollows : 1.0);
        next.rate = std::clamp((*reply.place - course.place) / passed, rate - more, rate + more);
    }
    return next;
}

void PlaceBelief::take(const Reply& reply)
{
    if (!reply.place) {
        if (!skip()) {
            m_doubted.reset();
        }
        passWithout(reply.received);
        return;
    }
    const Course* const from = courseTo(reply);
    const bool expected = from != nullptr && reaches(*from, reply);
    const bool agrees = m_doubted && reaches(*m_doubted, reply);
    // After kAgree replies without a believed place the axis can be far away. One reply alone is then not believed.
    if (expected && m_without < kAgree && !(agrees && miss(*m_doubted, reply) < miss(*from, reply))) {
        m_false = m_doubt ? m_doubt : m_false;
        believe(continued(*from, reply));
        return;
    }
    if (!agrees && skip() && !(expected && rivals(reply))) {
        passWithout(reply.received);
        return;
    }
    m_skipped = false;
    m_doubt = agrees ? m_doubt : expected ? std::nullopt : leapTo(reply);
    m_agreeing = agrees ? m_agreeing + 1 : 1;
    m_doubted = agrees ? continued(*m_doubted, reply)
                       : Course{.place = *reply.place, .rate = {}, .asked = reply.asked, .received = reply.received};
    if (m_agreeing < (m_doubt || m_believed.empty() ? kJump : kAgree)) {
        passWithout(reply.received);
        return;
    }
    m_jump = m_doubt;
    m_believed.clear();
    believe(*m_doubted);
}

// The believed course that the reply continues. Places with a small error may have been believed. The next true place
// then seems to leap back, but continues the course from before them. Null: nothing is believed yet.
const PlaceBelief::Course* PlaceBelief::courseTo(const Reply& reply) const
{
    if (m_believed.empty()) {
        return nullptr;
    }
    const auto missed = [&](const Course& course) { return miss(course, reply); };
    const auto best = std::ranges::min_element(m_believed, {}, missed);
    return missed(*best) < m_limits.allowance ? &*best : &m_believed.back();
}

std::optional<PlaceBelief::Leap> PlaceBelief::leapTo(const Reply& reply) const
{
    if (m_believed.empty()) {
        return std::nullopt;
    }
    const Course& last = m_believed.back();
    return Leap{.from = ahead(last.place, last.rate, reply.asked - last.asked),
                .to = *reply.place,
                .within = reply.received - last.received};
}

void PlaceBelief::believe(const Course& course)
{
    if (m_believed.size() == kCourses) {
        m_believed.erase(m_believed.begin());
    }
    m_believed.push_back(course);
    m_doubted.reset();
    m_doubt.reset();
    m_rival.reset();
    m_agreeing = 0;
    m_without = 0;
    const MotorTurns before = m_place ? m_place->position : course.place;
    m_place = Place{.position = course.place, .moved = course.place - before, .received = course.received};
}

// Whether this reply is skipped. Where the axis is expected, one bad reply does not break a row of agreeing replies.
bool PlaceBelief::skip()
{
    const bool expected = m_doubted && !m_believed.empty() && !m_doubt;
    return expected && !std::exchange(m_skipped, true);
}

// Whether two rows of places alternate and the axis can be at either. Nobody knows which row is true, so each breaks
// the other.
bool PlaceBelief::rivals(const Reply& reply)
{
    const bool rivals = m_rival && reaches(*m_rival, reply);
    m_rival = Course{.place = *reply.place, .rate = {}, .asked = reply.asked, .received = reply.received};
    return rivals;
}

void PlaceBelief::passWithout(SteadyTime now)
{
    ++m_without;
    const int most = m_believed.empty() ? kJump : kAgree;  // without believed places, a new one needs kJump replies
    if (m_place && m_without >= most && now - m_place->received >= kForgotten) {
        m_place.reset();
    }
}

void PlaceBelief::forget()
{
    expectAnother();
    m_place.reset();
}

void PlaceBelief::expectAnother()
{
    m_believed.clear();
    m_doubted.reset();
    m_doubt.reset();
    m_rival.reset();
    m_false.reset();
    m_jump.reset();
    m_agreeing = 0;
}

}  // namespace boresight::supervision
