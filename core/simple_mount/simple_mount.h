// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mount/mount_driver.h"
#include "core/simple_mount/simple_box.h"

#include <array>
#include <optional>

// The plain simulated rotator behind the port of the mount: whole degrees, one speed, no watchdog. It shows that the
// control needs nothing more of a rotator. It sends an order only when the set-point has left the degree that was
// ordered or reported last, so taking an axis over moves nothing. It may have one axis only. Station thread only.
// Mechanical angles.
namespace boresight {

class SimpleMount final : public MountDriver
{
public:
    // Longer than some lost answers, short enough to be reported while somebody looks.
    static constexpr std::chrono::milliseconds kSilence{500};

    // Which axes there are.
    struct Axes
    {
        bool azimuth = true;
        bool elevation = true;
    };

    // The box outlives this. An axis that is missing is never ordered anywhere.
    explicit SimpleMount(SimpleBox& box, const Axes& axes = {true, true});

    // After the control has commanded.
    void send();

    [[nodiscard]] Capabilities capabilities() const override { return m_capabilities; }
    [[nodiscard]] const QString& name(Axis axis) const override { return m_names[index(axis)]; }
    [[nodiscard]] QString label(Axis axis) const override;
    [[nodiscard]] std::optional<QString> identity(Axis axis) const override;
    [[nodiscard]] QString lastIdentity(Axis /*axis*/) const override { return {}; }
    [[nodiscard]] AxisReport report(Axis axis) const override;
    [[nodiscard]] Result<> available() const override { return {}; }
    [[nodiscard]] const Result<>& fitness() const override { return m_fitness; }
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
    Result<> m_fitness;
    std::optional<AxisPosition> m_place;            // as reported last
    std::array<std::optional<Angle>, 2> m_ordered;  // where it was sent last, since it follows
    std::optional<SteadyTime> m_heard;
    std::array<tracking::Setpoint, 2> m_setpoints{};
    std::array<bool, 2> m_begins{};  // to follow, not taken yet
    bool m_wanted = false;           // to be taken over
    bool m_follows = false;
    bool m_lost = false;  // while it followed: nothing moves before recover()
    SteadyTime m_now{};   // of the running or last tick
};

}  // namespace boresight
