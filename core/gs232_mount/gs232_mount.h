// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/gs232_mount/box_talk.h"
#include "core/rotator_box/box_mount.h"

// A GS-232 box as a mount: whole degrees, one speed. Station thread only.
namespace boresight::gs232 {

class Gs232Mount final : public BoxMount
{
public:
    // Longer than three lost answers on the slowest line.
    static constexpr std::chrono::milliseconds kSilence{1800};

    // The references outlive this. `axes`: the axes that the box turns.
    Gs232Mount(const profile::InForce& profile, AlarmBoard& alarms, const AxisSet& axes);

    [[nodiscard]] BoxTalk& talk() override { return m_talk; }
    [[nodiscard]] const BoxTalk& talk() const override { return m_talk; }
    [[nodiscard]] QString kind() const override;
    [[nodiscard]] QString kindInWords() const override;
    [[nodiscard]] const Result<>& interlock() const override { return m_interlock; }

private:
    bool goTo(const RotatorTalk::Places& target) override;
    [[nodiscard]] QString remedyOfNoAnswer() const override;

    Result<> m_interlock;
    BoxTalk m_talk;
};

}  // namespace boresight::gs232
