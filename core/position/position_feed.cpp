// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/position/position_feed.h"

#include "core/base/text.h"

#include <algorithm>
#include <cmath>

namespace boresight::position {
namespace {

constexpr double kMetres = 1000.0;  // in a kilometre

// The time between two times of day, on the nearest day.
Seconds between(std::chrono::milliseconds from, std::chrono::milliseconds to)
{
    constexpr double kDay = 86400.0;
    return Seconds(std::remainder(Seconds(to - from).count(), kDay));
}

std::chrono::milliseconds timeOfDay(UtcTime utc)
{
    return std::chrono::floor<std::chrono::milliseconds>(utc - std::chrono::floor<std::chrono::days>(utc));
}

orbit::Vector groundOf(const Site& site)
{
    return orbit::Observer(site).ground({}, 0.0);
}

}  // namespace

void PositionFeed::setLimits(const FeedLimits& limits)
{
    if (limits != m_limits) {
        *this = {};
        m_limits = limits;
    }
}

Result<> PositionFeed::take(const Result<PositionText>& read, SteadyTime now, UtcTime utc)
{
    Result<> taken = read.and_then([&](const PositionText& text) { return believe(text, now, utc); });
    if (taken) {
        ++m_accepted;
    } else {
        ++m_refused;
        m_lastRefusal = taken.error().text;
    }
    return taken;
}

Result<> PositionFeed::believe(const PositionText& text, SteadyTime now, UtcTime utc)
{
    if (!m_limits.name.isEmpty() && text.name.compare(m_limits.name, Qt::CaseInsensitive) != 0) {
        return failure(ErrorCode::NotAvailable,
                       Text::tr("the report is from another call sign than %1").arg(m_limits.name));
    }
    const Seconds old = text.time ? between(*text.time, timeOfDay(utc)) : Seconds(0.0);
    if (std::abs(old.count()) > kOldest.count()) {
        return failure(
            ErrorCode::Refused,
            Text::tr("its time and the clock of this computer differ by %1 s").arg(std::abs(old.count()), 0, 'f', 0));
    }
    return moveTo(text, now);
}

// True for a report that was repeated or overtaken by a newer one. A report that arrives later than 2 × kOldest after
// the last one cannot be older. Times of day alone would not show that, because they repeat every day.
bool PositionFeed::isKnown(const PositionText& text, SteadyTime now) const
{
    const Seconds arrived = now - m_arrived;
    const bool isSame = m_last && text.site == m_last->site;
    if (!m_last || !text.time || !m_last->time || arrived > 2.0 * kOldest) {
        return isSame && arrived < kEcho;
    }
    const Seconds later = between(*m_last->time, *text.time);
    return later < Seconds(0.0) || (isSame && (later == Seconds(0.0) || arrived < kEcho));
}

// After a silence the path may begin again at any place. The speed of the mount is limited anyway.
Result<> PositionFeed::moveTo(const PositionText& text, SteadyTime now)
{
    if (isKnown(text, now)) {
        return {};
    }
    const orbit::Vector place = groundOf(text.site);
    orbit::Vector velocity{};
    if (m_last && isFresh(now)) {
        const Seconds arrived = now - m_arrived;
        const bool timed = text.time && m_last->time && between(*m_last->time, *text.time) > Seconds(0.0);
        const double seconds = std::max(timed ? between(*m_last->time, *text.time) : arrived, kEcho).count();
        velocity = (1.0 / seconds) * (place - m_place);
        if (!(length(velocity) * kMetres <= m_limits.fastest)) {
            return failure(ErrorCode::Refused, Text::tr("the position jumped by %1 km in %2 s")
                                                   .arg(length(place - m_place), 0, 'f', 1)
                                                   .arg(seconds, 0, 'f', 1));
        }
    }
    m_last = text;
    m_place = place;
    m_velocity = velocity;
    m_arrived = now;
    return {};
}

std::optional<Seconds> PositionFeed::age(SteadyTime now) const
{
    return m_last ? std::optional<Seconds>(now - m_arrived) : std::nullopt;
}

Result<> PositionFeed::isFresh(SteadyTime now) const
{
    if (!m_last) {
        return failure(ErrorCode::NoAnswer,
                       m_lastRefusal.isEmpty() ? Text::tr("no position was received") : m_lastRefusal);
    }
    if (now - m_arrived > m_limits.stale) {
        return failure(ErrorCode::NoAnswer,
                       Text::tr("no position was received for %1 s").arg(m_limits.stale.count(), 0, 'f', 0));
    }
    return {};
}

orbit::GroundState PositionFeed::at(SteadyTime now) const
{
    const Seconds since = std::clamp(Seconds(now - m_arrived), Seconds(0.0), kExtrapolated);
    const bool moves = now - m_arrived < kExtrapolated;
    return {.position = m_place + since.count() * m_velocity, .velocity = moves ? m_velocity : orbit::Vector{}};
}

}  // namespace boresight::position
