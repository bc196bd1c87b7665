// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/alarms/catalogue.h"
#include "core/control/motion_source.h"
#include "core/position/position_feed.h"
#include "core/sources/stale_wait.h"

#include <optional>

// Keeps the beam on a balloon or rocket that reports its position. Between two reports the flight is extrapolated.
// Without a report for too long the mount stands still. If a report from a near direction arrives within 2 minutes, the
// mount tracks again by itself. This source is separate from the operator: any motion by the operator ends it. Station
// thread only.
namespace boresight::sources {

class PositionFollow : public SourceOf<PositionFollow, request::FollowPosition>
{
public:
    using SourceOf::SourceOf;

    Result<> ask(const request::FollowPosition& wanted, const Source& by);
    void step(SteadyTime now) override;
    void describe(StationStatus& status) const override;
    Result<> receive(const SourceReport& report) override;
    void profileChanged(const profile::Profile& before, const profile::Profile& after) override;

private:
    struct Followed
    {
        Site site;  // the site of the mount when the tracking began
        std::uint64_t motionId = 0;
        std::optional<SkyPointing> direction = {};  // the last one
        std::optional<AxisPosition> place = {};     // last axis position: the next one is chosen on the same wrap
    };

    [[nodiscard]] Result<> isUsable() const;
    [[nodiscard]] Result<SkyPointing> directionAt(SteadyTime now) const;
    [[nodiscard]] QString whyToEnd(SteadyTime now);
    [[nodiscard]] Angle returnedBy(SteadyTime now) const;
    // The directions now and kFlightApart later. Without a fresh position both are the last direction.
    struct Leg
    {
        SkyPointing here;
        SkyPointing soon;
    };
    [[nodiscard]] Result<Leg> legAt(SteadyTime now) const;
    Result<> follow(SteadyTime now);
    void forget();
    void end(Severity severity, const QString& why);

    position::PositionFeed m_feed;
    StaleWait m_stale{helm(), alarmEntry("position.stale")};
    std::optional<Followed> m_followed;
};

}  // namespace boresight::sources
