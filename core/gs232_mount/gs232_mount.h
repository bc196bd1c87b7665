// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/gs232_mount/box_talk.h"
#include "core/gs232_mount/esp32_talk.h"
#include "core/gs232_mount/offset_watch.h"
#include "core/rotator_box/box_mount.h"

// A GS-232 box as a mount: whole degrees, one speed. The ESP32 relay controller calls itself such a box and speaks
// other words. The first answer shows which of them it is. Station thread only.
namespace boresight::gs232 {

class Gs232Mount final : public BoxMount
{
public:
    // Longer than three lost answers on the slowest line.
    static constexpr std::chrono::milliseconds kSilence{1800};

    // The references outlive this. `axes`: the axes that the box turns.
    Gs232Mount(const profile::InForce& profile, AlarmBoard& alarms, const AxisSet& axes);

    [[nodiscard]] RotatorTalk& talk() override { return m_isEsp32 ? static_cast<RotatorTalk&>(m_esp32) : m_box; }
    [[nodiscard]] const RotatorTalk& talk() const override
    {
        return m_isEsp32 ? static_cast<const RotatorTalk&>(m_esp32) : m_box;
    }
    [[nodiscard]] QString kind() const override;
    [[nodiscard]] QString kindInWords() const override;
    [[nodiscard]] QString condition() const override;
    [[nodiscard]] std::string sensorOffsets() const override;
    [[nodiscard]] const Result<>& interlock() const override { return m_interlock; }
    void observe(SteadyTime now) override;

private:
    bool goTo(const RotatorTalk::Places& target) override;
    bool goToBox(const RotatorTalk::Places& target);
    void goToEsp32(const RotatorTalk::Places& target);
    [[nodiscard]] QString remedyOfNoAnswer() const override;

    Result<> m_interlock;
    BoxTalk m_box;
    Esp32Talk m_esp32;
    OffsetWatch m_offsets;
    bool m_isEsp32 = false;
    SteadyTime m_now{};
};

}  // namespace boresight::gs232
