// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"
#include "core/orbit/topocentric.h"
#include "core/position/position_text.h"

#include <cstdint>
#include <optional>

// What is known of something that flies and reports its position now and then: where it was last, how fast it goes, and
// whether that still counts. A report that is not believed changes nothing. Pure, one thread.
namespace boresight::position {

// Of the profile.
struct FeedLimits
{
    QString name = {};        // of what flies; empty: whoever reports
    Seconds stale{30.0};      // since the last report
    double fastest = 2000.0;  // m/s, from one report to the next

    bool operator==(const FeedLimits&) const = default;
};

class PositionFeed
{
public:
    // The same position again so soon came by two ways.
    static constexpr Seconds kEcho{0.2};
    // Its last velocity counts so long.
    static constexpr Seconds kExtrapolated{10.0};
    // A report that is older than this was kept by somebody.
    static constexpr Seconds kOldest{60.0};

    // A change of the limits forgets what was known.
    void setLimits(const FeedLimits& limits);
    // The error says why it is not believed. NotAvailable: another call sign, which is no trouble.
    Result<> take(const Result<PositionText>& read, SteadyTime now, UtcTime utc);

    // The last one that was believed.
    [[nodiscard]] const std::optional<PositionText>& last() const { return m_last; }
    [[nodiscard]] std::uint64_t accepted() const { return m_accepted; }
    [[nodiscard]] std::uint64_t refused() const { return m_refused; }
    [[nodiscard]] const QString& lastRefusal() const { return m_lastRefusal; }
    [[nodiscard]] std::optional<Seconds> age(SteadyTime now) const;
    // NoAnswer with the reason: nothing came, or nothing for too long.
    [[nodiscard]] Result<> isFresh(SteadyTime now) const;
    // Where it is, on the way that it had. To be asked while it is fresh.
    [[nodiscard]] orbit::GroundState at(SteadyTime now) const;

private:
    [[nodiscard]] Result<> believe(const PositionText& text, SteadyTime now, UtcTime utc);
    [[nodiscard]] bool isKnown(const PositionText& text, SteadyTime now) const;
    [[nodiscard]] Result<> moveTo(const PositionText& text, SteadyTime now);

    FeedLimits m_limits;
    std::optional<PositionText> m_last;
    orbit::Vector m_place{};     // km, fixed to the Earth
    orbit::Vector m_velocity{};  // km/s
    SteadyTime m_arrived{};
    std::uint64_t m_accepted = 0;
    std::uint64_t m_refused = 0;
    QString m_lastRefusal;
};

}  // namespace boresight::position
