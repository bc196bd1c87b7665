// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/rotator_box/box_mount.h"
#include "core/rotctld_mount/rotctld_talk.h"

// The rotator of a rotctld as a mount: any model of Hamlib. The limits of the rotator are known, but not its speed and
// accuracy. Station thread only.
namespace boresight::rotctl {

class RotctldMount final : public BoxMount
{
public:
    static constexpr Angle kGrain = Angle::fromDegrees(0.5);  // smaller changes are noise
    static constexpr std::chrono::milliseconds kSilence{1800};
    static constexpr int kMostRefusals = 3;  // refusals of one target

    // The references outlive this. `axes`: the axes that the rotator turns for this mount.
    RotctldMount(const profile::InForce& profile, AlarmBoard& alarms, const AxisSet& axes);

    [[nodiscard]] RotctldTalk& talk() override { return m_talk; }
    [[nodiscard]] const RotctldTalk& talk() const override { return m_talk; }
    [[nodiscard]] QString kind() const override { return QStringLiteral("rotctld"); }
    [[nodiscard]] QString kindInWords() const override;
    [[nodiscard]] const Result<>& interlock() const override { return m_interlock; }
    void observe(SteadyTime now) override;
    [[nodiscard]] MountFindings supervise(const MountSituation& known) override;

private:
    bool goTo(const RotatorTalk::Places& target) override;
    [[nodiscard]] QString remedyOfNoAnswer() const override;
    [[nodiscard]] Result<> fits() const;
    [[nodiscard]] std::optional<AxisPosition> standing() const;
    [[nodiscard]] AxisPosition permitted(const AxisPosition& place) const;

    RotctldTalk m_talk;
    std::optional<RotatorState> m_checked;  // the limits that m_interlock is based on
    Result<> m_interlock;
};

}  // namespace boresight::rotctl
