// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/rotator_box/box_connection.h"
#include "core/rotctld_mount/rotctld_mount.h"
#include "tests/core/rotctld_mount/rotctld_bench.h"
#include "tests/fakes/wait_until.h"

#include <algorithm>
#include <functional>
#include <memory>
#include <optional>
#include <utility>

namespace boresight::rotctl {

// A control above a real connection. The clock is turned by hand, by one tick for each check of the test.
struct Rig
{
    explicit Rig(std::unique_ptr<BoxLine> line, const profile::Profile& wanted = rotctldProfile())
        : profile(wanted), connection(rotatorBehind<RotctldMount>(std::move(line), {})(profile, clock, log, alarms))
    {}

    void tick()
    {
        clock.advance(kOneTick);
        if (++ticks % 50 == 1) {
            connection->open();  // once a second, as the station does
        }
        control.tick();
        connection->send();
    }
    [[nodiscard]] bool comesTrue(const std::function<bool()>& condition)
    {
        return fakes::waitUntil([&] {
            tick();
            return condition();
        });
    }
    [[nodiscard]] bool warns(const char* alarm) const
    {
        return std::ranges::any_of(
            alarms.list(), [alarm](const Alarm& one) { return one.active && one.name == QLatin1String(alarm); });
    }
    [[nodiscard]] MountLine line() const
    {
        StationStatus status;
        connection->describe(status);
        return status.line;
    }
    [[nodiscard]] std::optional<AxisPosition> place() const { return connection->driver().measured(); }

    fakes::ManualClock clock;
    EventLog log{clock};
    AlarmBoard alarms{log, clock};
    profile::InForce profile;
    std::unique_ptr<MountConnection> connection;
    StationControl control{profile, clock, log, alarms, connection->driver(), motionSources};
    int ticks = 0;
};

}  // namespace boresight::rotctl
