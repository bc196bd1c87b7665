// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/control/motion_source.h"
#include "core/sources/pass_drive.h"
#include "core/sources/steered_utc.h"
#include "core/targets/target_path.h"

#include <optional>

// Tracks a target of core/targets. If the target rises and sets, the mount waits where the target rises, follows it
// until it sets, and holds there. If the target does not move, the mount goes there and stays. In each tick position
// and rate of the set-point come from the path of the target. The cable wrap is chosen at the start: a wrap with room
// for the whole path, if there is one. A pass of a satellite, or of a table, is driven by a plan of core/plan. Station
// thread only.
namespace boresight::sources {

class TargetTrack : public SourceOf<TargetTrack, request::Track>
{
public:
    using SourceOf::SourceOf;

    Result<> ask(const request::Track& wanted, const Source& by);
    void step(SteadyTime now) override;
    void profileChanged(const profile::Profile& before, const profile::Profile& after) override;
    void describe(StationStatus& status) const override;
    [[nodiscard]] std::optional<SkyPointing> targetAt(UtcTime utc) override;

    // Tracks the target for this client, which stays the source of the motion. The antenna in use stays in use.
    Result<> trackFor(const Source& client, const targets::Target& target);
    [[nodiscard]] bool isTracking() const { return m_tracked.has_value(); }
    // When the target rises, or rose. Call while it is tracked.
    [[nodiscard]] UtcTime rises() const { return m_tracked->up.rises; }
    // Ends the tracking, but not the motion.
    void forget();

private:
    struct Tracked
    {
        targets::Target target;
        targets::TargetPath path;
        Site site;
        Source by;
        targets::UpTime up = {};
        targets::SkyWay way = {};
        std::optional<plan::ChosenWay> wanted = {};  // by the operator, through the pass
        PassDrive drive = {};
        pointing::PointingTerms terms = {};      // of the beam when the way was computed
        bool isWayOld = false;                   // computed for other limits of the mount
        SkyPointing aimedAt = {};                // the direction of the target, the last time
        AngularRate skyRate = {};                // across the sky, now or at the rise
        AngularRate fastest = {};                // the largest rate on the way
        std::optional<AxisPosition> place = {};  // last axis position: the next one is on the same wrap
        std::uint64_t motionId = 0;
        bool isUp = false;

        [[nodiscard]] Result<SkyPointing> at(UtcTime utc);
    };

    [[nodiscard]] Result<> permits(const targets::Target& target, UtcTime now) const;
    [[nodiscard]] Result<> reaches(Tracked& tracked, UtcTime now) const;
    [[nodiscard]] Result<Tracked> plan(const targets::Target& target, const Source& by) const;
    void setWay(Tracked& tracked, UtcTime from) const;
    [[nodiscard]] targets::SkyWay wayOf(Tracked& tracked, UtcTime from) const;
    [[nodiscard]] Seconds lostByHolding() const;
    [[nodiscard]] UtcTime aimed(UtcTime utc) const;
    [[nodiscard]] Result<> mayGoOn() const;
    Result<> begin(Tracked tracked);
    Result<AxisPosition> follow(Tracked& tracked, UtcTime utc);
    Result<AxisPosition> point(const Tracked& tracked, Helm::Lead lead, UtcTime utc);
    void takePlan(UtcTime utc);
    void followOn(UtcTime utc);
    void renewWay(UtcTime utc);
    [[nodiscard]] Result<> planAgain(UtcTime utc);
    void watchClock();
    void end(Severity severity, const QString& why);

    SteeredUtc m_utc;
    std::optional<Tracked> m_tracked;
};

}  // namespace boresight::sources
