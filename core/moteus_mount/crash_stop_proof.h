// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"
#include "core/base/result.h"
#include "core/units/sky.h"

#include <QString>

#include <chrono>
#include <optional>
#include <vector>

// The crash-stop test. For one axis after the other: moves the axis at a low speed, sends its drive no more commands,
// and measures where and when the axis stands still. It never commands a drive. Each tick it returns one action, and
// its owner carries out the action. Pure: time and the readings of the drive are passed in. Mechanical angles.
namespace boresight {

class CrashStopProof
{
public:
    struct Measured  // the axis under test, by the last reply of its drive
    {
        SteadyTime received{};
        Angle angle;
        bool settled = false;  // the recovery is over: the drive is commanded again and stands still, or is off
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
        Starve,   // send its drive no more commands
        Recover,  // clear the time-out of the drive, then hold the axis again
        Wait,
        Finish,  // end(): see result()
    };

    // Prepares the test of `axes`. If the travel of an axis leaves too little room, the result is an error with the
    // reason.
    static Result<CrashStopProof> prepare(AngularRate rate, const AxisPosition& from, const TravelRange& azimuth,
                                          const TravelRange& elevation, AxisSet axes = kAxes);

    [[nodiscard]] Action step(SteadyTime now, const Measured& measured);

    [[nodiscard]] Axis axis() const { return m_axes.front(); }
    [[nodiscard]] bool runningUp() const { return m_phase == Phase::RunningUp; }
    [[nodiscard]] AngularRate rate() const { return axis() == Axis::Azimuth ? m_azimuthRate : m_elevationRate; }
    // The measured stop of an axis. Returned once.
    [[nodiscard]] std::optional<Stop> takeStop();
    // Why the test failed. Empty while it has not failed.
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
    AxisSet m_axes;  // the axis under test, then those that follow
    Phase m_phase = Phase::RunningUp;
    std::optional<SteadyTime> m_phaseSince;
    std::vector<Sample> m_samples;  // of the current phase
    std::optional<Stop> m_stop;
    QString m_failure;
};

}  // namespace boresight
