// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"
#include "core/messages/motor_starts.h"
#include "core/units/quantity.h"

#include <cstdint>
#include <deque>
#include <optional>

// The motor of one axis, which relays switch on and off: whether it runs, how often it was started, and whether it may
// be started now. Nothing reports that, so its places and our orders tell. A motor that turns round counts as started.
// Pure.
namespace boresight::gs232 {

class SwitchedMotor
{
public:
    // Nearer to its target than this it is switched off, or will be within one look.
    static constexpr Angle kThere = Angle::fromDegrees(1.1);
    static constexpr std::chrono::seconds kMinute{60};
    static constexpr std::chrono::seconds kBegins{2};  // until its place must have changed

    // The axis is at `place` and is sent to `target`.
    void send(Angle place, Angle target, SteadyTime now);
    void stop() { m_target.reset(); }
    // `moves`: its place has changed lately.
    void observe(Angle place, bool moves, SteadyTime now);

    [[nodiscard]] bool runs() const { return m_target.has_value(); }
    // Whether to send it from `place` to `target` costs no start, or one that is within `most` per minute. The second
    // half of them is spread over the minute: a target that needs more must not wait for most of it.
    [[nodiscard]] bool maySend(Angle place, Angle target, int most, SteadyTime now) const;
    [[nodiscard]] MotorStarts starts(SteadyTime now) const;

private:
    [[nodiscard]] bool starts(Angle place, Angle target) const;

    std::optional<Angle> m_target;  // it runs there
    SteadyTime m_started{};
    std::deque<SteadyTime> m_lately;  // starts of the last minute, and older ones until the next
    std::uint64_t m_total = 0;
};

}  // namespace boresight::gs232
