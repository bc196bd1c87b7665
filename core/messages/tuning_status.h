// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"
#include "core/response/backlash.h"
#include "core/response/ramp_response.h"
#include "core/response/samples.h"
#include "core/response/step_response.h"
#include "core/response/sweep_response.h"
#include "core/units/sky.h"

#include <QString>
#include <QStringList>

#include <array>
#include <optional>
#include <vector>

// The report of the tuning desk to the screen: the present run, the planned motion of each run, and the results. An
// immutable snapshot, replaced when something has changed. Sentences are translated. Angles of the axes are mechanical.
namespace boresight {

enum class TuningRun
{
    Step,
    Ramp,
    Sweep,
    Backlash
};

inline constexpr std::array kTuningRuns{TuningRun::Step, TuningRun::Ramp, TuningRun::Sweep, TuningRun::Backlash};

// The motion of a run, reported before the run starts.
struct TuningPlan
{
    Angle from;  // where the run begins and ends
    Angle to;    // the place farthest from `from`
    Seconds duration{0.0};
    QString text;      // the motion and its duration, as a sentence
    QString obstacle;  // why the axis has not enough free travel; empty: it has
};

struct TuningResult
{
    Axis axis = Axis::Azimuth;
    TuningRun run = TuningRun::Step;
    UtcTime when{};
    // The gains of the drive during the run, in the order of DriveGains. Empty: they could not be read.
    std::vector<std::optional<double>> gains{};
    bool asFound = true;                          // the gains are those that Boresight found first
    std::optional<response::StepFigures> step{};  // each figure is the worse one of both directions
    std::optional<response::RampFigures> ramp{};  // as in `step`
    std::vector<response::SweepPoint> sweep{};
    std::optional<response::BacklashFigures> backlash{};
    bool good = false;                        // the axis needs no tuning for this result
    QStringList verdict{};                    // in plain words, one fact a sentence
    std::vector<response::Sample> samples{};  // of the whole run, thinned
};

// How a run ended.
struct TuningOutcome
{
    Axis axis = Axis::Azimuth;
    TuningRun run = TuningRun::Step;
    QString text;
    bool failed = false;
};

struct TuningStatus
{
    std::optional<TuningRun> running;
    Axis axis = Axis::Azimuth;  // axis of the run
    double done = 0.0;          // progress of the run, 0…1
    Seconds left{0.0};
    std::optional<TuningOutcome> outcome;                             // of the last run; empty before the first run
    std::array<std::array<TuningPlan, kTuningRuns.size()>, 2> plans;  // by axis and run
    // For each axis and run: the newest result with the gains as found, and the newest with changed gains.
    std::vector<TuningResult> results;
};

}  // namespace boresight
