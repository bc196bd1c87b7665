// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/control/motion_source.h"
#include "core/orbit/sgp4.h"
#include "core/orbit/topocentric.h"
#include "core/sources/steered_utc.h"

#include <optional>

// A satellite by its elements: waits where it rises, follows it until it sets, and holds there. The set-points come
// from the orbit in each tick, position and rate. Its cable is chosen before the pass begins: on a wrap that has room
// for all of it, if there is one. Station thread only.
namespace boresight::sources {

class TargetTrack : public SourceOf<TargetTrack, request::Track>
{
public:
    // It waits no longer than this for a satellite to rise.
    static constexpr std::chrono::minutes kLongestWait{30};

    using SourceOf::SourceOf;

    Result<> ask(const request::Track& wanted, const Source& by);
    void step(SteadyTime now) override;
    void describe(StationStatus& status) const override;

private:
    struct Tracked
    {
        QString name;
        std::int64_t number = 0;
        orbit::Sgp4 orbit;
        orbit::Observer observer;
        Source by;
        UtcTime rises;
        std::optional<UtcTime> sets;             // empty: it does not
        std::optional<AxisPosition> place = {};  // of the axes, the last one: chooses the turn of the next
        std::uint64_t errand = 0;
        bool isUp = false;

        [[nodiscard]] Result<SkyPointing> at(UtcTime utc) const;
    };

    [[nodiscard]] Result<Tracked> plan(const request::Track& wanted, const Source& by) const;
    [[nodiscard]] std::optional<AxisPosition> roomyStart(const Tracked& tracked, UtcTime from) const;
    [[nodiscard]] UtcTime aimed(UtcTime utc) const;
    Result<AxisPosition> follow(const Tracked& tracked, UtcTime utc);
    void end(Severity severity, const QString& why);

    SteeredUtc m_utc;
    std::optional<Tracked> m_tracked;
};

}  // namespace boresight::sources
