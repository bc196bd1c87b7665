// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mount/mount_driver.h"
#include "core/simple_mount/simple_box.h"

#include <array>
#include <optional>

// The simple simulated rotator as a MountDriver: whole degrees, one speed, no watchdog. It shows that the control needs
// nothing more from a rotator. It sends a command only when the set-point has left the degree that was commanded or
// reported last, so taking an axis over moves nothing. It may have only one axis. Station thread only. Mechanical
// angles.
namespace boresight {

class SimpleMount final : public MountDriver
{
public:
    // Long enough for some lost answers, short enough that the operator sees the report at once.
    static constexpr std::chrono::milliseconds kSilence{500};

    // The axes of the rotator.
    struct Axes
    {
        bool azimuth = true;
        bool elevation = true;
    };

    // The box outlives this. A missing axis is never commanded.
    explicit SimpleMount(SimpleBox& box, const Axes& axes = {true, true});

    // Call it after the control has commanded.
    void send();

    [[nodiscard]] Capabilities capabilities() const override { return m_capabilities; }
    [[nodiscard]] const QString& name(Axis axis) const override { return m_names[index(axis)]; }
    [[nodiscard]] QString label(Axis axis) const override;
    [[nodiscard]] std::optional<QString> identity(Axis axis) const override;
    [[nodiscard]] QString lastIdentity(Axis /*axis*/) const override { return {}; }
    [[nodiscard]] AxisReport report(Axis axis) const override;
    [[nodiscard]] Result<> available() const override { return {}; }
    [[nodiscard]] const Result<>& interlock() const override { return m_interlock; }
    [[nodiscard]] MountService* service() override { return nullptr; }
    [[nodiscard]] const MountService* service() const override { return nullptr; }
    void observe(SteadyTime now) override;
    [[nodiscard]] MountFindings supervise(const MountSituation& known) override;
    void engage() override { m_wanted = !m_lost; }
    [[nodiscard]] std::optional<Angle> takeFollowing(Axis axis) override;
    void command(Axis axis, const tracking::Setpoint& setpoint) override { m_setpoints[index(axis)] = setpoint; }
    void brakeHard(bool /*hard*/) override {}
    void seize() override;
    void recover() override { m_lost = false; }
    void rearmed() override {}
    void leave(profile::OnExit how) override;
    void setSensor(Axis /*axis*/, const std::optional<Angle>& /*heading*/) override {}

private:
    [[nodiscard]] bool answers() const { return m_heard && m_now - *m_heard <= kSilence; }
    void letGo();

    SimpleBox& m_box;
    Capabilities m_capabilities;
    std::array<QString, 2> m_names;
    Result<> m_interlock;
    std::optional<AxisPosition> m_place;            // as last reported
    std::array<std::optional<Angle>, 2> m_ordered;  // the last target of each axis, since it follows set-points
    std::optional<SteadyTime> m_heard;
    std::array<tracking::Setpoint, 2> m_setpoints{};
    std::array<bool, 2> m_begins{};  // starts to follow, but takeFollowing() was not called yet
    bool m_wanted = false;           // engage() was called, and the axes do not follow yet
    bool m_follows = false;
    bool m_lost = false;  // lost while it followed: nothing moves before recover()
    SteadyTime m_now{};   // of the current or last tick
};

}  // namespace boresight
