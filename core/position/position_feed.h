// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"
#include "core/orbit/topocentric.h"
#include "core/position/position_text.h"

#include <cstdint>
#include <optional>

// The state of a flying object that reports its position from time to time: its last position, its velocity, and
// whether they are still valid. A report that is not believed changes nothing. Pure, one thread.
namespace boresight::position {

// From the profile.
struct FeedLimits
{
    QString name = {};        // call sign; empty: any
    Seconds stale{30.0};      // without a report for this time the position is stale
    double fastest = 2000.0;  // m/s, highest believed speed between two reports

    bool operator==(const FeedLimits&) const = default;
};

class PositionFeed
{
public:
    // If the same position arrives twice within this time, it is the same report, received in two ways.
    static constexpr Seconds kEcho{0.2};
    // The last velocity is used for this time.
    static constexpr Seconds kExtrapolated{10.0};
    // An older report was delayed by some program and is refused.
    static constexpr Seconds kOldest{60.0};

    // A change of the limits clears the state.
    void setLimits(const FeedLimits& limits);
    // The error explains why the report is not believed. NotAvailable: a report of another call sign, which is no
    // problem.
    Result<> take(const Result<PositionText>& read, SteadyTime now, UtcTime utc);

    // The last report that was believed.
    [[nodiscard]] const std::optional<PositionText>& last() const { return m_last; }
    [[nodiscard]] std::uint64_t accepted() const { return m_accepted; }
    [[nodiscard]] std::uint64_t refused() const { return m_refused; }
    [[nodiscard]] const QString& lastRefusal() const { return m_lastRefusal; }
    [[nodiscard]] std::optional<Seconds> age(SteadyTime now) const;
    // Error NoAnswer with the reason: no report came, or none for too long.
    [[nodiscard]] Result<> isFresh(SteadyTime now) const;
    // The position at this time, extrapolated with the last velocity. Call it only while isFresh().
    [[nodiscard]] orbit::GroundState at(SteadyTime now) const;

private:
    [[nodiscard]] Result<> believe(const PositionText& text, SteadyTime now, UtcTime utc);
    [[nodiscard]] bool isKnown(const PositionText& text, SteadyTime now) const;
    [[nodiscard]] Result<> moveTo(const PositionText& text, SteadyTime now);

    FeedLimits m_limits;
    std::optional<PositionText> m_last;
    orbit::Vector m_place{};     // km, Earth-fixed
    orbit::Vector m_velocity{};  // km/s, Earth-fixed
    SteadyTime m_arrived{};
    std::uint64_t m_accepted = 0;
    std::uint64_t m_refused = 0;
    QString m_lastRefusal;
};

}  // namespace boresight::position
