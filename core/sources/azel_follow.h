// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/alarms/catalogue.h"
#include "core/control/motion_source.h"
#include "core/sources/azel_moon.h"
#include "core/sources/stale_wait.h"
#include "core/sources/steered_utc.h"

#include <optional>

// Tracks the Moon by the file azel.dat of WSJT-X. While the Moon is up, the mount gets a new target in each tick, or as
// often as the profile sets. While the Moon is down, the mount is parked once. The mount stands still while the file is
// stale and, if the profile asks for it, while the radio transmits. This source is separate from the operator: any
// motion by the operator ends it. Station thread only.
namespace boresight::sources {

class AzelFollow : public SourceOf<AzelFollow, request::FollowAzel>
{
public:
    using SourceOf::SourceOf;

    Result<> ask(const request::FollowAzel& wanted, const Source& by);
    void step(SteadyTime now) override;
    void describe(StationStatus& status) const override;
    Result<> receive(const SourceReport& report) override;
    [[nodiscard]] std::optional<SkyPointing> targetAt(UtcTime utc) override;

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
        std::optional<UtcTime> next = {};  // the next moonset while the Moon is up, else the next moonrise
        std::optional<AngularRate> skyRate = {};
        std::optional<Target> target = {};
        std::optional<AxisPosition> place = {};     // last axis position: the next one is chosen on the same wrap
        std::optional<AxisPosition> standing = {};  // axis position where the mount stands still and waits
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
