// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/plan/plan_pass.h"
#include "core/units/angle_between.h"
#include "tests/core/control/station_rig.h"
#include "tests/fakes/found_orbit.h"

#include <QThreadPool>

#include <gtest/gtest.h>

#include <algorithm>

// A station that tracks a pass, and how far its beam is off the satellite.
namespace boresight {

inline const Site kPassSite{.latitude = 38.757_deg, .longitude = -9.117_deg, .heightMetres = 80.0};

// The azimuth turns at 6 °/s.
inline profile::Profile passMount()
{
    profile::Profile profile;
    profile.site = {.known = true,
                    .latitude = kPassSite.latitude,
                    .longitude = kPassSite.longitude,
                    .heightMetres = kPassSite.heightMetres};
    profile.control.tickHz = 20;  // the lowest
    profile.control.watchdog = Seconds(0.2);
    profile.azimuth.limits.speed = 6_deg_s;
    profile.azimuth.limits.acceleration = 12_deg_s2;
    return profile;
}

class PassRig
{
public:
    explicit PassRig(const profile::Profile& profile) : rig(profile) { rig.run(Seconds(0.5)); }

    // A pass that begins soon.
    [[nodiscard]] fakes::FoundOrbit passWith(const std::function<bool(const passes::Pass&)>& wanted) const
    {
        return fakes::orbitWith(kPassSite, rig.clock.utc(), [&](const passes::Pass& pass) {
            const Seconds wait = pass.aos.utc - rig.clock.utc();
            return Seconds(60.0) < wait && wait < Seconds(1500.0) && !pass.isUpAtEnd && wanted(pass);
        });
    }
    // The plan for a mount that stands where this one does.
    [[nodiscard]] plan::PassPlan planOf(const fakes::FoundOrbit& found) const
    {
        const auto mount = plan::planMount(rig.profile, rig.profile.antenna({}));
        return plan::planPass([&](UtcTime utc) { return std::optional(fakes::directionOf(found, kPassSite, utc)); },
                              {.from = found.pass.aos.utc,
                               .to = found.pass.los.utc,
                               .now = rig.mount.measured().value_or(AxisPosition{})},
                              *mount);
    }
    Result<> track(const fakes::FoundOrbit& found, const std::optional<plan::ChosenWay>& way = {})
    {
        return rig.ask(request::Track{.target = targets::satelliteTarget(found.elements), .way = way}, kOperator);
    }
    void awaitPlan()
    {
        rig.tick();
        QThreadPool::globalInstance()->waitForDone();
        rig.tick();
    }
    void runUntil(UtcTime utc)
    {
        while (rig.clock.utc() < utc) {
            rig.tick();
        }
    }
    struct Run
    {
        Angle peak;             // error of the beam
        UtcTime worst{};        // when
        Seconds lost{0.0};      // time with an error of more than a degree
        Angle lowest, highest;  // elevation of the axis
    };
    // Runs until a second before the end of the pass, or to another time.
    [[nodiscard]] Run follow(const fakes::FoundOrbit& found, std::optional<UtcTime> until = {})
    {
        Run run{.lowest = 360_deg};
        const UtcTime end = until.value_or(found.pass.los.utc - std::chrono::seconds(1));
        while (rig.clock.utc() < end) {
            rig.tick();
            const SkyPointing wanted = fakes::directionOf(found, kPassSite, rig.clock.utc());
            const StationStatus status = rig.control.status();
            const Angle error = angleBetween(status.commanded.value(), wanted);
            run.worst = error > run.peak ? rig.clock.utc() : run.worst;
            run.peak = std::max(run.peak, error);
            run.lost += error > 1_deg ? rig.step : Seconds(0.0);
            run.lowest = std::min(run.lowest, status.elevation.commanded.value());
            run.highest = std::max(run.highest, status.elevation.commanded.value());
        }
        return run;
    }
    [[nodiscard]] bool logged(const char* words) const
    {
        return std::ranges::any_of(rig.log.since(0, EventLog::kCapacity),
                                   [&](const LogEntry& line) { return line.text.contains(QLatin1String(words)); });
    }

    StationRig rig;
};

}  // namespace boresight
