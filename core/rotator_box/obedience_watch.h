// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"
#include "core/units/quantity.h"
#include "core/units/sky.h"

#include <optional>

// Whether one axis of a rotator obeys. The box does not report the end of a motion, so its positions are compared. An
// axis that stops away from its target is sent there once more, then it is stuck. An axis that moves on after a stop is
// stopped again each second, then it counts as running on. Pure.
namespace boresight {

class ObedienceWatch
{
public:
    static constexpr Angle kMet = Angle::fromDegrees(2.0);  // a rotator may stop this far from its target
    static constexpr std::chrono::seconds kSendAgain{2};
    static constexpr std::chrono::seconds kStuck{5};
    static constexpr std::chrono::seconds kCoast{3};  // after a stop; then it is stopped again
    static constexpr int kMostRepeats = 3;            // one a second; then it runs on
    static constexpr std::chrono::seconds kStands{
        2};  // time without another position until the axis counts as standing

    enum class Verdict
    {
        Obeys,
        SendAgain,
        Stuck,
        StopAgain,
        RunsOn
    };

    // Positions within `noise` may be the same one, because the potentiometer is worn. With 0 only a flicker between
    // two counts is no motion.
    explicit ObedienceWatch(Angle noise) : m_noise(noise) {}

    void sent(Angle target, SteadyTime now);
    void stopped(SteadyTime now);
    // Boresight sends it nothing more and does not watch it.
    void release();
    void place(Angle place, SteadyTime now);
    [[nodiscard]] Verdict judge(SteadyTime now);

    // The axis was stopped, and was not seen standing still since then.
    [[nodiscard]] bool stopping() const { return m_stopped.has_value(); }
    // The position has changed within kStands.
    [[nodiscard]] bool moves(SteadyTime now) const { return m_changed && now - *m_changed < kStands; }

private:
    [[nodiscard]] Verdict judgeTarget(SteadyTime now);
    [[nodiscard]] Verdict judgeStop(SteadyTime now);
    [[nodiscard]] bool leavesNoise(Angle place);
    [[nodiscard]] bool isNoFlicker(Angle place);
    void watchStop(Angle place, SteadyTime now);

    Angle m_noise;
    std::optional<Angle> m_place;
    std::optional<Angle> m_before;        // the position before m_place
    TravelRange m_same{};                 // the last positions that may be one
    std::optional<SteadyTime> m_changed;  // when the position last changed from a known one
    std::optional<Angle> m_target;
    double m_way = 1.0;              // the direction of the target: -1, 1
    std::optional<Angle> m_reached;  // the farthest position in this direction
    SteadyTime m_progress{};         // when the axis was last near its target, moved, or got another target
    bool m_sentAgain = false;
    std::optional<SteadyTime> m_stopped;  // set until the axis was seen standing still
    SteadyTime m_lastStop{};
    int m_repeats = 0;       // of the stop
    TravelRange m_passed{};  // all positions since the stop
    SteadyTime m_widened{};  // when m_passed last became wider
};

}  // namespace boresight
