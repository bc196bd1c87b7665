// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/alarms/catalogue.h"
#include "core/control/motion_source.h"
#include "core/position/position_feed.h"
#include "core/sources/stale_wait.h"

#include <optional>

// A balloon or a rocket that reports its position: the beam is kept on it, on the way that it had. Without a report for
// too long the mount stands still, and goes on by itself for two minutes if one comes from nearby. It is a source of
// its own beside the operator's hand, which ends it. Station thread only.
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
        Site site;  // of the mount
        std::uint64_t motionId = 0;
        std::optional<SkyPointing> direction = {};  // the last one
        std::optional<AxisPosition> place = {};     // of the axes for it: chooses the turn of the next
    };

    [[nodiscard]] Result<> isUsable() const;
    [[nodiscard]] Result<SkyPointing> directionAt(SteadyTime now) const;
    [[nodiscard]] QString whyToEnd(SteadyTime now);
    [[nodiscard]] Angle returnedBy(SteadyTime now) const;
    // Where it is now, and a little later. Without a fresh position: where it was.
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
