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

// What the tuning desk tells the screen: what runs, where a run would move, and what the runs have measured. One
// immutable snapshot, made again when something changed. Sentences are translated; angles of the axes are mechanical.
namespace boresight {

enum class TuningRun
{
    Step,
    Ramp,
    Sweep,
    Backlash
};

inline constexpr std::array kTuningRuns{TuningRun::Step, TuningRun::Ramp, TuningRun::Sweep, TuningRun::Backlash};

// Where a run will move, told before it starts.
struct TuningPlan
{
    Angle from;  // it begins and ends here
    Angle to;    // the farthest place
    Seconds duration{0.0};
    QString text;      // both, in a sentence
    QString obstacle;  // why it has not the room; empty: it has
};

struct TuningResult
{
    Axis axis = Axis::Azimuth;
    TuningRun run = TuningRun::Step;
    UtcTime when{};
    // The gains of the drive in force meanwhile, in their own order; empty: not read.
    std::vector<std::optional<double>> gains{};
    bool asFound = true;                          // they are those that were found first
    std::optional<response::StepFigures> step{};  // the worse of both ways, in each figure
    std::optional<response::RampFigures> ramp{};  // the same
    std::vector<response::SweepPoint> sweep{};
    std::optional<response::BacklashFigures> backlash{};
    bool good = false;                        // nothing needs to be tuned for it
    QStringList verdict{};                    // in plain words, one fact a sentence
    std::vector<response::Sample> samples{};  // of the whole run
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
    Axis axis = Axis::Azimuth;  // of the run
    double done = 0.0;          // 0…1
    Seconds left{0.0};
    std::optional<TuningOutcome> outcome;                             // of the last run; empty before the first
    std::array<std::array<TuningPlan, kTuningRuns.size()>, 2> plans;  // by axis and run
    // Of each axis and run the newest with the gains as found and the newest with others: before and after.
    std::vector<TuningResult> results;
};

}  // namespace boresight
