// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mount/mount_driver.h"

#include <array>

// Two drivers as one mount: the azimuth of the first and the elevation of the second. They may be of different kinds. A
// trouble of one stops both, because the control sees one mount. Station thread only. Mechanical angles.
namespace boresight {

class PairedMount final : public MountDriver
{
public:
    // The drivers outlive this. Neither of them may have the axis of the other.
    PairedMount(MountDriver& azimuth, MountDriver& elevation) : m_drivers{&azimuth, &elevation} {}

    [[nodiscard]] Capabilities capabilities() const override;
    [[nodiscard]] const QString& name(Axis axis) const override { return of(axis).name(axis); }
    [[nodiscard]] QString label(Axis axis) const override { return of(axis).label(axis); }
    [[nodiscard]] std::optional<QString> identity(Axis axis) const override { return of(axis).identity(axis); }
    [[nodiscard]] QString lastIdentity(Axis axis) const override { return of(axis).lastIdentity(axis); }
    [[nodiscard]] AxisReport report(Axis axis) const override { return of(axis).report(axis); }
    [[nodiscard]] Result<> available() const override;
    [[nodiscard]] const Result<>& interlock() const override;
    [[nodiscard]] Result<> mayType() const override;
    // The service of the only driver that has one, for its axis. If both have one, the pair has none, because each
    // service would act on both axes.
    [[nodiscard]] MountService* service() override;
    [[nodiscard]] const MountService* service() const override;
    [[nodiscard]] ThirdAxis* thirdAxis() override;
    [[nodiscard]] const ThirdAxis* thirdAxis() const override;
    void observe(SteadyTime now) override;
    [[nodiscard]] MountFindings supervise(const MountSituation& known) override;
    void engage() override;
    [[nodiscard]] std::optional<Angle> takeFollowing(Axis axis) override { return of(axis).takeFollowing(axis); }
    void command(Axis axis, const tracking::Setpoint& setpoint) override { of(axis).command(axis, setpoint); }
    void setLeeway(Axis axis, const tracking::Leeway& leeway) override { of(axis).setLeeway(axis, leeway); }
    void retake() override;
    void brakeHard(bool hard) override;
    void seize() override;
    void recover() override;
    void rearmed() override;
    void leave(profile::OnExit how) override;
    void setSensor(Axis axis, const std::optional<Angle>& heading) override { of(axis).setSensor(axis, heading); }

private:
    [[nodiscard]] MountDriver& of(Axis axis) { return *m_drivers[index(axis)]; }
    [[nodiscard]] const MountDriver& of(Axis axis) const { return *m_drivers[index(axis)]; }

    std::array<MountDriver*, 2> m_drivers;
};

}  // namespace boresight
