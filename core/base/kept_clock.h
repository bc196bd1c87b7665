// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"

// The clock by which the mount is pointed. It follows the clock of this computer in small corrections. When that clock
// is set, this one continues as before until follow() is called. Its time is not confirmed meanwhile. Station thread
// only.
namespace boresight {

class KeptClock final : public Clock
{
public:
    // A larger difference is not a correction: somebody has set the clock.
    static constexpr std::chrono::milliseconds kSet{500};

    explicit KeptClock(const Clock& computer) : m_computer(computer) { follow(); }

    [[nodiscard]] SteadyTime now() const override { return m_computer.now(); }
    [[nodiscard]] UtcTime utc() const override;
    [[nodiscard]] bool synchronised() const override;
    [[nodiscard]] std::optional<Seconds> error() const override;
    [[nodiscard]] Seconds slept() const override { return m_computer.slept(); }
    [[nodiscard]] Seconds ahead() const override;

    // A time source confirms the clock of the computer, and the error is less than a change that counts as set.
    [[nodiscard]] bool isConfirmed() const;
    // Takes the time of the computer.
    void follow();

private:
    [[nodiscard]] UtcTime running() const;
    [[nodiscard]] UtcTime goneOn() const { return running() + m_offset; }

    const Clock& m_computer;
    UtcTime::duration m_offset{};  // UTC minus the time that this computer runs
};

}  // namespace boresight
