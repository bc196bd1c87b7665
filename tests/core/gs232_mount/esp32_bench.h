// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/gs232_mount/esp32_box.h"
#include "core/gs232_mount/gs232_mount.h"
#include "tests/core/mount/mount_bench.h"

#include <string>

// An ESP32 relay controller below a control, with a clock that is turned by hand.
namespace boresight::gs232 {

// The settings that the manual recommends for such a rotator. It turns at 3 °/s.
inline profile::Profile esp32Profile(profile::AxisDriver azimuth = profile::AxisDriver::Gs232,
                                     profile::AxisDriver elevation = profile::AxisDriver::Gs232)
{
    profile::Profile profile = slowProfile(azimuth, elevation);
    profile.azimuth.geometry.travel = {.min = 0_deg, .max = 350_deg};
    profile.limits.azimuth = profile.azimuth.geometry.travel;
    for (profile::AxisSettings* const axis : {&profile.azimuth, &profile.elevation}) {
        axis->limits.speed = AngularRate::fromDegrees(2.8);
        axis->limits.acceleration = 3_deg_s2;
        axis->limits.jerk = AngularJerk::fromDegrees(6.0);
    }
    return profile;
}

class Esp32Bench final : public Bench
{
public:
    explicit Esp32Bench(const AxisSet& axes = kAxes)
        : Esp32Bench(esp32Profile(driverIn(axes, Axis::Azimuth), driverIn(axes, Axis::Elevation)), axes)
    {}
    explicit Esp32Bench(const profile::Profile& profile, const AxisSet& axes = kAxes)
        : m_profile(profile), m_mount(m_profile, m_alarms, axes)
    {
        m_mount.lineOpened();
    }

    StationControl& control() override { return m_control; }
    profile::InForce& inForce() override { return m_profile; }
    void tick() override
    {
        m_clock.advance(kOneTick);
        const std::string answers = m_box.answers(m_clock.now());
        if (m_connected) {
            m_mount.console().take(answers);
            m_mount.take(answers, m_clock.now());
        }
        m_control.tick();
        const std::string bytes = m_mount.send();
        if (m_connected) {
            m_box.take(bytes, m_clock.now());
        }
    }
    AxisPosition truth() override { return m_box.truth(); }
    Angle resolution() override { return Esp32Box::kTolerance; }
    void setPace(const std::array<double, 2>& pace) override { m_box.faults().pace = pace; }
    bool ordered() override { return m_box.moves() > 0; }
    // Unplugs the cable. The box then goes on to its last target.
    void setLine(bool connected) override { m_connected = connected; }

    [[nodiscard]] Esp32Box& box() { return m_box; }
    [[nodiscard]] Gs232Mount& mount() { return m_mount; }
    [[nodiscard]] fakes::ManualClock& clock() { return m_clock; }

private:
    static profile::AxisDriver driverIn(const AxisSet& axes, Axis axis)
    {
        return std::ranges::find(axes, axis) != axes.end() ? profile::AxisDriver::Gs232 : profile::AxisDriver::None;
    }

    profile::InForce m_profile;
    fakes::ManualClock m_clock;
    EventLog m_log{m_clock};
    AlarmBoard m_alarms{m_log, m_clock};
    Esp32Box m_box{kBetweenDegrees};
    Gs232Mount m_mount;
    bool m_connected = true;
    StationControl m_control{m_profile, m_clock, m_log, m_alarms, m_mount, motionSources};
};

}  // namespace boresight::gs232
