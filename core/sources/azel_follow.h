// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/alarms/catalogue.h"
#include "core/control/motion_source.h"
#include "core/sources/azel_moon.h"
#include "core/sources/stale_wait.h"
#include "core/sources/steered_utc.h"

#include <optional>

// The Moon of WSJT-X's azel.dat. While it is up the mount goes on to it in each tick, or as often as the profile says.
// While it is down the mount is parked, once. It stands still while the radio transmits, if the profile wants that, and
// while the file is stale. It is a source of its own beside the operator's hand, which ends it. Station thread only.
namespace boresight::sources {

class AzelFollow : public SourceOf<AzelFollow, request::FollowAzel>
{
public:
    using SourceOf::SourceOf;

    Result<> ask(const request::FollowAzel& wanted, const Source& by);
    void step(SteadyTime now) override;
    void describe(StationStatus& status) const override;
    Result<> receive(const SourceReport& report) override;

private:
    struct Target
    {
        SkyPointing now;
        SkyPointing soon;
        SteadyTime since;
    };
    struct Followed
    {
        std::uint64_t motionId = 0;
        AzelPhase phase = AzelPhase::Off;
        bool isUp = false;
        std::optional<UtcTime> next = {};  // it sets, or rises
        std::optional<AngularRate> skyRate = {};
        std::optional<Target> target = {};
        std::optional<AxisPosition> place = {};     // of the axes for it: chooses the turn of the next
        std::optional<AxisPosition> standing = {};  // of the axes, while it stands still
    };

    [[nodiscard]] Result<> isUsable() const;
    [[nodiscard]] QString whyToEnd(SteadyTime now);
    [[nodiscard]] AzelPhase wantedPhase() const;
    [[nodiscard]] bool isParking() const;
    void setUp(bool isUp, UtcTime utc);
    void watchHorizon(UtcTime utc);
    void tellDifference();
    [[nodiscard]] std::optional<AxisPosition> roomyPlace(UtcTime utc);
    [[nodiscard]] bool isDue(const SkyPointing& moon, SteadyTime now) const;
    Result<> drive(SteadyTime now, UtcTime utc);
    Result<> follow(SteadyTime now, UtcTime utc);
    Result<> park();
    Result<> stand();
    void aimAtTheMoon(StationStatus& status) const;
    void forget();
    void end(Severity severity, const QString& why);

    azel::AzelFeed m_feed;
    AzelMoon m_moon;
    StaleWait m_stale{helm(), alarmEntry("azel.stale")};
    SteeredUtc m_utc;
    std::optional<Followed> m_followed;
};

}  // namespace boresight::sources
