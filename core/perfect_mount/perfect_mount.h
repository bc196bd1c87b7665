// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mount/mount_driver.h"

#include <array>

// The mount of a rehearsal as a MountDriver: its axes are always at the last set-points. If even this mount loses a
// target, the limits of the profile or the cable are the reason. It never fails. Mechanical angles. One thread.
namespace boresight {

class PerfectMount final : public MountDriver
{
public:
    PerfectMount(const AxisSet& axes, const AxisPosition& standing);

    [[nodiscard]] Capabilities capabilities() const override { return m_capabilities; }
    [[nodiscard]] const QString& name(Axis axis) const override { return m_names[index(axis)]; }
    [[nodiscard]] QString label(Axis axis) const override;
    [[nodiscard]] std::optional<QString> identity(Axis /*axis*/) const override { return QString(); }
    [[nodiscard]] QString lastIdentity(Axis /*axis*/) const override { return {}; }
    [[nodiscard]] AxisReport report(Axis axis) const override;
    [[nodiscard]] Result<> available() const override { return {}; }
    [[nodiscard]] const Result<>& interlock() const override { return m_interlock; }
    [[nodiscard]] MountService* service() override { return nullptr; }
    [[nodiscard]] const MountService* service() const override { return nullptr; }
    void observe(SteadyTime now) override { m_now = now; }
    [[nodiscard]] MountFindings supervise(const MountSituation& known) override;
    void engage() override { m_wanted = true; }
    [[nodiscard]] std::optional<Angle> takeFollowing(Axis axis) override;
    void command(Axis axis, const tracking::Setpoint& setpoint) override { m_setpoints[index(axis)] = setpoint; }
    void brakeHard(bool /*hard*/) override {}
    void seize() override {}
    void recover() override {}
    void rearmed() override {}
    void leave(profile::OnExit /*how*/) override { m_follows = m_wanted = false; }
    void setSensor(Axis /*axis*/, const std::optional<Angle>& /*heading*/) override {}

private:
    Capabilities m_capabilities;
    std::array<QString, 2> m_names;
    Result<> m_interlock;
    std::array<tracking::Setpoint, 2> m_setpoints{};
    std::array<bool, 2> m_begins{};  // starts to follow, but takeFollowing() was not called yet
    bool m_wanted = false;           // engage() was called, and the axes do not follow yet
    bool m_follows = false;
    SteadyTime m_now{};
};

}  // namespace boresight
