// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/alarms/alarm_board.h"
#include "core/base/can_frame.h"
#include "core/moteus_mount/drive.h"
#include "core/mount/third_axis.h"
#include "core/profile/in_force.h"

#include <QString>

#include <optional>
#include <string>
#include <vector>

// A further moteus on the bus that turns an axis beside the two. Without one in the profile it sends nothing. Before
// the board has reported the register map that Boresight knows, it gets only queries. Station thread only. Mechanical
// angles.
namespace boresight {

class ThirdDrive final : public ThirdAxis
{
public:
    // Profile and alarms outlive this. The board is the one in the profile now.
    ThirdDrive(const profile::InForce& profile, AlarmBoard& alarms);

    [[nodiscard]] bool isUsed() const { return m_drive.has_value(); }
    void take(const CanFrame& frame);
    // Once per tick, before the control.
    void observe(SteadyTime now);
    // The command and the query of this tick, after the control.
    [[nodiscard]] std::vector<CanFrame> frames() const;
    void framesTaken();  // by the link
    // The bus is released to other tools, or taken back.
    void setReleased(bool released);

    [[nodiscard]] Result<> fit() const override;
    [[nodiscard]] bool isFaulted() const override;
    [[nodiscard]] std::optional<Angle> place() const override;
    [[nodiscard]] bool underOrders() const override;
    [[nodiscard]] bool follows() const override;
    void describe(ThirdAxisStatus& status) const override;
    void engage() override;
    [[nodiscard]] std::optional<Angle> takeFollowing() override;
    void command(const tracking::Setpoint& setpoint) override;
    void brakeHard(bool hard) override;
    [[nodiscard]] std::optional<QString> takeLoss() override;
    void seize() override;
    void recover() override;
    void leave(profile::OnExit how) override;

private:
    [[nodiscard]] const pointing::AxisGeometry& geometry() const { return m_profile->thirdAxis.axis.geometry; }
    [[nodiscard]] Result<> isKnownBoard() const;
    [[nodiscard]] bool answers() const { return m_drive && m_drive->answering(m_now); }
    [[nodiscard]] bool isSilent() const;
    void watch();
    void watchFollowing();
    void tell();

    const profile::InForce& m_profile;
    AlarmBoard& m_alarms;
    int m_id;
    std::optional<Drive> m_drive;
    std::optional<int> m_registerMap;  // as the board reports it since it answers
    bool m_released = false;
    std::optional<Angle> m_setpoint;     // that the axis follows
    std::optional<SteadyTime> m_behind;  // since when the axis is far from its set-point
    std::optional<QString> m_loss;
    std::optional<SteadyTime> m_started;  // of the first query
    SteadyTime m_now{};
};

}  // namespace boresight
