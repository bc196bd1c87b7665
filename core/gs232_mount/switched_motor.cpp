// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/gs232_mount/switched_motor.h"

#include <algorithm>
#include <cmath>

namespace boresight::gs232 {
namespace {

constexpr std::chrono::seconds kMinute{60};
// An order takes up to a second from the place that it was decided for, and the usual motor turns by 6 °/s: nearer to
// its target than this it may have stopped already. The next piece of a way is sent before.
constexpr double kAboutToArrive = 5.0;  // degrees
constexpr double kNextPiece = 8.5;
// No more orders reach the box.
constexpr std::chrono::milliseconds kBetweenOrders{500};
// Places and orders are whole degrees, compared in between.
constexpr double kHalf = 0.5;  // degrees
// One count to and fro is the converter. Two counts are a motion.
constexpr Angle kMotion = Angle::fromDegrees(1.5);

bool isWithin(Angle way, Angle miss)
{
    return abs(way).degrees() < miss.degrees() + kHalf;
}

double signOf(Angle way)
{
    return way < Angle{} ? -1.0 : 1.0;
}

}  // namespace

void SwitchedMotor::place(Angle place, SteadyTime now)
{
    if (!m_place) {
        m_place = m_before = place;
        m_changed = now;
        m_state = State::Settles;
        m_arrived = false;
        return;
    }
    if (place != *m_place) {
        m_changed = place != m_before ? now : m_changed;
        m_before = *m_place;
        m_place = place;
    }
    const auto still = now - m_changed;
    if (m_state == State::Runs && ahead(m_to) < kHalf) {
        m_state = State::Settles;  // its relay opens as soon as it shows its target
        m_arrived = true;
    } else if (m_state == State::Runs && still >= kNear && ahead(m_to) < kMiss.degrees() + kHalf) {
        standNow();
    } else if (m_state == State::Settles && still >= kStill) {
        standNow();
    } else if (m_state == State::Stands && abs(place - m_rest) >= kMotion) {
        m_state = State::Settles;  // nobody here has ordered that
        m_arrived = false;
        count(now);
    }
}

void SwitchedMotor::standNow()
{
    if (m_state == State::Settles && m_arrived) {
        const double beyond = -ahead(m_to);
        m_coast = std::clamp(m_coast + 0.5 * (Angle::fromDegrees(beyond) - m_coast), Angle{}, kMostCoast);
    }
    m_state = State::Stands;
    m_rest = *m_place;
    m_met = m_met || (m_isFinal && isWithin(*m_place - m_end, kMiss));
}

void SwitchedMotor::sent(Angle to, Angle end, SteadyTime now)
{
    m_end = end;
    m_met = false;
    m_isFinal = isWithin(end - to, Angle::fromDegrees(std::round(m_coast.degrees())));
    const Angle from = m_place.value_or(to);
    if (m_state == State::Runs) {
        if (ahead(m_to) <= kAboutToArrive && now - m_starts.back() >= kBetweenOrders) {
            count(now);  // it may have stopped already
        }
        m_to = to;
        return;
    }
    m_from = believed();
    m_to = to;
    if (isWithin(to - from, {})) {
        m_met = m_isFinal;
        return;  // the box shows it already
    }
    m_sign = signOf(to - from);
    m_state = State::Runs;
    m_changed = now;
    count(now);
}

void SwitchedMotor::stopped(SteadyTime now)
{
    if (m_state != State::Unknown) {
        m_changed = m_state == State::Runs ? now : m_changed;
        m_state = State::Settles;
        m_arrived = false;
    }
}

void SwitchedMotor::beginHere()
{
    m_from = m_to = m_end = m_place.value_or(Angle{});
    m_isFinal = m_met = true;
}

void SwitchedMotor::forget()
{
    m_state = State::Unknown;
    m_place.reset();
}

double SwitchedMotor::ahead(Angle of) const
{
    return (of - *m_place).degrees() * m_sign;
}

bool SwitchedMotor::ends() const
{
    return m_state == State::Settles || (m_state == State::Runs && ahead(m_to) <= kAboutToArrive);
}

bool SwitchedMotor::hasMet(Angle end) const
{
    return m_state == State::Stands && m_met && isWithin(m_end - end, {});
}

bool SwitchedMotor::isAt(Angle end) const
{
    return hasMet(end) && isWithin(*m_place - end, kMiss);
}

bool SwitchedMotor::overran() const
{
    return m_state == State::Settles && m_arrived && -ahead(m_to) > kOverrun.degrees();
}

bool SwitchedMotor::reverses(Angle to) const
{
    return m_state == State::Runs && ahead(to) < -kHalf;
}

Angle SwitchedMotor::believed() const
{
    const Angle place = m_place.value_or(Angle{});
    const Angle onWay = std::clamp(place, std::min(m_from, m_to), std::max(m_from, m_to));
    const Angle counts = m_state == State::Stands ? m_to : onWay;
    return isWithin(place - counts, kMiss) ? counts : place;
}

// Less than it coasts it cannot go.
Angle SwitchedMotor::deadBand(Angle slack) const
{
    return std::max({kStep, slack - kStep, m_coast});
}

int SwitchedMotor::startsInLastMinute(SteadyTime now) const
{
    return static_cast<int>(std::ranges::count_if(m_starts, [now](SteadyTime one) { return now - one < kMinute; }));
}

void SwitchedMotor::count(SteadyTime now)
{
    std::erase_if(m_starts, [now](SteadyTime one) { return now - one >= kMinute; });
    m_starts.push_back(now);
    ++m_total;
}

// A quarter of a minute's starts is free. The others are spread: else a busy moment is paid with a long pause.
bool SwitchedMotor::mayStart(int most, SteadyTime now) const
{
    constexpr Seconds kSpread{60.0};
    const int used = startsInLastMinute(now);
    return used < most && (4 * used < most || now - m_starts.back() >= kSpread / most);
}

// It is sent less far by its coast, and not farther than the next piece of the way.
Angle SwitchedMotor::aim(Angle end) const
{
    const double sign = signOf(end - *m_place);
    const double way = std::abs((end - *m_place).degrees());
    const double early = std::clamp(std::round(m_coast.degrees()), 0.0, std::max(way - kStep.degrees(), 0.0));
    return *m_place + Angle::fromDegrees(sign * std::min(way - early, kFarthest.degrees()));
}

SwitchedMotor::Decision SwitchedMotor::decide(const Wish& wish, SteadyTime now) const
{
    if (m_state == State::Runs) {
        return decideRunning(wish);
    }
    const bool there = wish.follows ? abs(wish.target - *m_place) <= deadBand(wish.slack) : hasMet(wish.end);
    if (m_state != State::Stands || there || isWithin(wish.end - *m_place, {})) {
        return {};
    }
    return mayStart(wish.most, now) ? Decision{.act = Act::Go, .to = aim(wish.end)} : Decision{.act = Act::Wait};
}

// What lies beyond its end may have become forbidden since it was sent.
SwitchedMotor::Decision SwitchedMotor::decideRunning(const Wish& wish) const
{
    const Angle to = aim(wish.end);
    const double longer = ahead(to) - ahead(m_to);
    const bool tooFar = longer < -kHalf;
    if (tooFar && ahead(to) < kHalf) {
        return {.act = Act::Stop};
    }
    const bool nextPiece = longer > kHalf && ahead(m_to) < kNextPiece && ahead(m_to) > kAboutToArrive;
    return tooFar || nextPiece ? Decision{.act = Act::Go, .to = to} : Decision{};
}

}  // namespace boresight::gs232
