// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/cross_check/sensor_watch.h"
#include "tests/fakes/manual_clock.h"

#include <gmock/gmock.h>

#include <string>

// A sensor that is compared with axes, which stand still unless a test moves them, with a hand-turned clock.
namespace boresight {

inline constexpr SkyPointing kStandingAt{.azimuth = Angle::fromDegrees(100.0), .elevation = Angle::fromDegrees(20.0)};

struct SensorWatchRig
{
    explicit SensorWatchRig(const profile::Profile& settings = {})
        : profile(settings), watch(inForce, clock, log, alarms)
    {
        watch.begin(QStringLiteral("serial /dev/ttyUSB0"));
    }

    void setProfile(const profile::Profile& wanted)
    {
        const auto before = inForce.shared();
        inForce.apply(wanted);
        watch.profileChanged(*before, *inForce);
    }

    // One value a second, while `speaking`.
    void run(double seconds)
    {
        for (int i = 0; i < static_cast<int>(seconds * 50.0); ++i) {
            clock.advance(Seconds(0.02));
            watch.tick(axes, 0.0, proposedAxes);
            if (speaking && ++ticks % 50 == 0) {
                watch.take(value());
            }
        }
    }

    [[nodiscard]] orientation::Orientation value() const
    {
        return {.heading = orientation::SensorHeading::folded(heading),
                .extendedAzimuth = heading,
                .elevation = elevation,
                .temperature = 27.0,
                .calibration = calibration,
                .arrival = clock.now(),
                .unknown = unknown};
    }

    [[nodiscard]] std::string alarmText() const
    {
        for (const Alarm& alarm : alarms.list()) {
            if (alarm.active) {
                EXPECT_EQ(alarm.severity, Severity::Warning) << "amber: the mount goes on";
                return (alarm.what + QLatin1Char(' ') + alarm.action + QLatin1Char(' ') + alarm.remedy).toStdString();
            }
        }
        return {};
    }

    [[nodiscard]] std::string logText() const
    {
        std::string text;
        for (const LogEntry& entry : log.since(0, 100)) {
            text += entry.source.toStdString() + ": " + entry.text.toStdString() + "\n";
        }
        return text;
    }

    fakes::ManualClock clock;
    EventLog log{clock};
    AlarmBoard alarms{log, clock};
    profile::Profile profile;  // as applied first
    profile::InForce inForce{profile};
    SensorWatch watch;
    bool speaking = true;
    int ticks = 0;
    Angle heading = 100_deg;
    Angle elevation = 20_deg;
    std::optional<orientation::Calibration> calibration{
        {.system = 3, .gyro = 3, .accelerometer = 3, .magnetometer = 3}};
    std::string unknown;
    std::optional<SkyPointing> axes{kStandingAt};
    std::optional<SkyPointing> proposedAxes;
};

// A mount whose north was found.
inline profile::Profile withNorth()
{
    profile::Profile profile;
    profile.pointing.azimuthOffset = 5_deg;
    return profile;
}

}  // namespace boresight
