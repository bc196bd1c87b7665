// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/control/motion_source.h"
#include "core/sources/steered_utc.h"
#include "core/targets/target_path.h"

#include <optional>

// A target of core/targets. One that rises and sets: waits where it rises, follows it until it sets, and holds there.
// One that stays in its place: goes there and stays. The set-points come from its path in each tick, position and rate.
// The wrap of the cable is chosen before it rises: one that has room for the whole path, if there is one. Station
// thread only.
namespace boresight::sources {

class TargetTrack : public SourceOf<TargetTrack, request::Track>
{
public:
    using SourceOf::SourceOf;

    Result<> ask(const request::Track& wanted, const Source& by);
    void step(SteadyTime now) override;
    void describe(StationStatus& status) const override;

private:
    struct Tracked
    {
        targets::Target target;
        targets::TargetPath path;
        Site site;
        Source by;
        targets::UpTime up = {};
        targets::SkyWay way = {};
        pointing::PointingTerms terms = {};      // of the beam, for which parts of the way are hidden
        AngularRate skyRate = {};                // now, or at its rise
        AngularRate fastest = {};                // of its way
        std::optional<AxisPosition> place = {};  // of the axes, the last one: chooses the turn of the next
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
    void followOn(UtcTime utc);
    void renewWay(UtcTime utc);
    void watchClock();
    void forget();
    void end(Severity severity, const QString& why);

    SteeredUtc m_utc;
    std::optional<Tracked> m_tracked;
};

}  // namespace boresight::sources
