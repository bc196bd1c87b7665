// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/rotctld_mount/rotctld_box.h"
#include "core/rotctld_mount/rotctld_mount.h"
#include "tests/core/mount/mount_bench.h"

#include <string>

// A rotctld with its rotator below a control, with a clock that is turned by hand.
namespace boresight::rotctl {

// The settings that the manual recommends for such a rotator.
inline profile::Profile rotctldProfile(profile::AxisDriver azimuth = profile::AxisDriver::Rotctld,
                                       profile::AxisDriver elevation = profile::AxisDriver::Rotctld)
{
    profile::Profile profile = slowProfile(azimuth, elevation);
    for (profile::AxisSettings* const axis : {&profile.azimuth, &profile.elevation}) {
        axis->limits.speed = 6_deg_s;
        axis->limits.acceleration = 3_deg_s2;
        axis->limits.jerk = AngularJerk::fromDegrees(6.0);
    }
    return profile;
}

// Axes that stand only at steps: 512 in 180°, and 866 in a turn.
inline profile::Profile steppedProfile()
{
    profile::Profile profile = rotctldProfile();
    profile.azimuth.stepsPerTurn = 1024.0;
    profile.elevation.stepsPerTurn = 866.0;
    return profile;
}

class RotctldBench final : public Bench
{
public:
    explicit RotctldBench(const AxisSet& axes = kAxes)
        : RotctldBench(rotctldProfile(driverIn(axes, Axis::Azimuth), driverIn(axes, Axis::Elevation)), axes)
    {}
    explicit RotctldBench(const profile::Profile& profile, const AxisSet& axes = kAxes)
        : m_profile(profile), m_box(kBetweenDegrees, stepsOf(profile)), m_mount(m_profile, m_alarms, axes)
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
            m_mount.take(answers, m_clock.now());
        }
        m_control.tick();
        const std::string bytes = m_mount.send();
        if (m_connected) {
            m_box.take(bytes, m_clock.now());
        }
        if (m_mount.talk().wantsAnotherLine()) {
            ++m_reopened;
            m_box.reconnect();
            m_mount.lineClosed();
            m_mount.lineOpened();
        }
    }
    AxisPosition truth() override { return m_box.truth(); }
    void setPace(const std::array<double, 2>& pace) override { m_box.faults().pace = pace; }
    bool ordered() override { return m_box.moves() > 0; }
    // Interrupts the network. The rotator then goes on to its last target.
    void setLine(bool connected) override { m_connected = connected; }

    [[nodiscard]] RotctldBox& box() { return m_box; }
    [[nodiscard]] RotctldMount& mount() { return m_mount; }
    [[nodiscard]] fakes::ManualClock& clock() { return m_clock; }
    [[nodiscard]] int reopened() const { return m_reopened; }
    [[nodiscard]] const Alarm* alarm(const char* name)
    {
        m_shown = control().status().alarms;
        const auto found = std::ranges::find_if(
            m_shown, [name](const Alarm& one) { return one.active && one.name == QLatin1String(name); });
        return found != m_shown.end() ? &*found : nullptr;
    }
    [[nodiscard]] int heardOf(const std::string& beginning) const
    {
        return static_cast<int>(std::ranges::count_if(
            m_box.heard(), [&beginning](const std::string& one) { return one.starts_with(beginning); }));
    }

private:
    // The rotator has the steps of its profile.
    static std::array<Angle, 2> stepsOf(const profile::Profile& profile)
    {
        const auto step = [](double steps) { return steps > 0.0 ? Angle::fromTurns(1.0 / steps) : Angle{}; };
        return {step(profile.azimuth.stepsPerTurn), step(profile.elevation.stepsPerTurn)};
    }
    static profile::AxisDriver driverIn(const AxisSet& axes, Axis axis)
    {
        return std::ranges::find(axes, axis) != axes.end() ? profile::AxisDriver::Rotctld : profile::AxisDriver::None;
    }

    profile::InForce m_profile;
    fakes::ManualClock m_clock;
    EventLog m_log{m_clock};
    AlarmBoard m_alarms{m_log, m_clock};
    RotctldBox m_box;
    RotctldMount m_mount;
    bool m_connected = true;
    int m_reopened = 0;
    std::vector<Alarm> m_shown;
    StationControl m_control{m_profile, m_clock, m_log, m_alarms, m_mount, motionSources};
};

}  // namespace boresight::rotctl
