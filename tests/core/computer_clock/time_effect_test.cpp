// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/computer_clock/time_effect.h"

#include <gtest/gtest.h>

namespace boresight {
namespace {

const UtcTime kStart{std::chrono::hours(480'000)};

StationStatus tracking(bool isUp = true)
{
    StationStatus status;
    status.utc = kStart;
    status.tracked = TrackedTarget{.name = QStringLiteral("ISS"), .isUp = isUp, .skyRate = 1_deg_s};
    return status;
}

// Moves 1° in a second along the horizon, for 100 s before and after the start.
std::optional<SkyPointing> along(UtcTime utc)
{
    const Seconds since = utc - kStart;
    return std::chrono::abs(since) > Seconds(100.0)
               ? std::nullopt
               : std::optional(SkyPointing{.azimuth = Angle::fromDegrees(180.0 + since.count()), .elevation = 0_deg});
}

TimeEffect effect(const StationStatus& status, double seconds)
{
    return timeEffect(status, along, Seconds(seconds));
}

// REQ-STATION-235: The effect of a clock that was set is the angle between the two directions of the target that is
// tracked by the time, whether or not it would be up. Without such a target only the seconds are reported.
TEST(TimeEffect, TheTrackedTargetWouldBeElsewhere)
{
    EXPECT_EQ(effect(tracking(), 90.0),
              (TimeEffect{.moves = true, .shift = QStringLiteral("ISS would be 90.0° away")}));
    EXPECT_EQ(effect(tracking(), -60.0).shift, QStringLiteral("ISS would be 60.0° away"));
    EXPECT_EQ(effect(tracking(), -3600.0),
              (TimeEffect{.moves = true, .shift = QStringLiteral("ISS has no direction at the new time")}));
}

// REQ-STATION-235
TEST(TimeEffect, ARiseOrAPassWouldComeAtAnotherTime)
{
    const TimeEffect later{.delays = true};
    EXPECT_EQ(effect(tracking(false), 90.0), later);
    StationStatus armed;
    ScheduleStatus schedule;
    schedule.armed = true;
    armed.schedule = std::make_shared<const ScheduleStatus>(schedule);
    EXPECT_EQ(effect(armed, 90.0), later);
    EXPECT_TRUE(later.isAny());
}

// REQ-STATION-235
TEST(TimeEffect, WhatStaysNeedsNoTime)
{
    StationStatus status = tracking();
    status.tracked->skyRate.reset();
    EXPECT_FALSE(effect(status, 90.0).isAny());
    EXPECT_FALSE(effect({}, 90.0).isAny());
}

}  // namespace
}  // namespace boresight
