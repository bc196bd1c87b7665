// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"
#include "core/base/result.h"
#include "core/units/sky.h"

#include <QString>

#include <chrono>
#include <optional>
#include <vector>

// The crash-stop proof: moves one axis of the mount after the other at a low speed, has its drive really not fed any
// more, and measures where and when the axis stands. Decides nothing about drives itself: it gives its owner one action
// per tick. Pure: time and what the drive reports are passed in. Mechanical angles.
namespace boresight {

class CrashStopProof
{
public:
    struct Measured  // of the axis under proof, by its last reply
    {
        SteadyTime received{};
        Angle angle;
        bool settled = false;  // commanded again and standing still, or off: the recovery is over
    };
    struct Stop  // how the axis stopped
    {
        AngularRate rate;
        Angle angle;
        std::chrono::milliseconds time{0};
    };
    enum class Action
    {
        Run,      // move the axis at rate()
        Starve,   // send its drive no more orders
        Recover,  // clear its time-out and hold it again
        Wait,
        Finish,  // end(): see result()
    };

    // Of `axes`. Refused when one of them has not the room: the reason.
    static Result<CrashStopProof> prepare(AngularRate rate, const AxisPosition& from, const TravelRange& azimuth,
                                          const TravelRange& elevation, AxisSet axes = kAxes);

    [[nodiscard]] Action step(SteadyTime now, const Measured& measured);

    [[nodiscard]] Axis axis() const { return m_axes.front(); }
    [[nodiscard]] bool runningUp() const { return m_phase == Phase::RunningUp; }
    [[nodiscard]] AngularRate rate() const { return axis() == Axis::Azimuth ? m_azimuthRate : m_elevationRate; }
    // Given once, when an axis has been measured.
    [[nodiscard]] std::optional<Stop> takeStop();
    // Why the proof failed; empty while it goes well.
    [[nodiscard]] const QString& failure() const { return m_failure; }
    [[nodiscard]] QString progress() const;

private:
    enum class Phase
    {
        RunningUp,
        Starving,
        Recovering,
        Over,
    };
    struct Sample
    {
        SteadyTime time;
        Angle angle;
    };

    CrashStopProof(AngularRate azimuthRate, AngularRate elevationRate, AxisSet axes);
    [[nodiscard]] Action runUp(SteadyTime now, const Measured& measured);
    [[nodiscard]] Action watchStop(SteadyTime now);
    [[nodiscard]] Action recover(SteadyTime now, const Measured& measured);
    [[nodiscard]] Action fail(const QString& why);
    [[nodiscard]] SteadyTime within(Angle band) const;
    void enter(Phase phase, SteadyTime now);

    AngularRate m_azimuthRate;
    AngularRate m_elevationRate;
    AxisSet m_axes;  // this one, and those that follow
    Phase m_phase = Phase::RunningUp;
    std::optional<SteadyTime> m_phaseSince;
    std::vector<Sample> m_samples;  // of the present phase
    std::optional<Stop> m_stop;
    QString m_failure;
};

}  // namespace boresight
