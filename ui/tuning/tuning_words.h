// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/messages/station_status.h"

#include <QString>

#include <optional>
#include <vector>

// How runs, gains and figures of the tuning are called, and which step of the first tuning is next. Pure.
namespace boresight::ui {

[[nodiscard]] QString runName(TuningRun run);  // "Step"
[[nodiscard]] QString gainName(Gain gain);     // "Stiffness kp"
[[nodiscard]] QString gainText(double value);  // six digits at most

struct Figure
{
    QString name;
    QString value;

    bool operator==(const Figure&) const = default;
};

// In the same order for each result of a kind.
[[nodiscard]] std::vector<Figure> figuresOf(const TuningResult& result);

struct BeforeAndAfter
{
    const TuningResult* before = nullptr;  // with the gains as they were found
    const TuningResult* after = nullptr;   // with others
};
[[nodiscard]] BeforeAndAfter resultsOf(const TuningStatus& tuning, Axis axis, TuningRun run);

// What counts for the axis as it is: the newest with the gains in force, or while they are not read the newest of all.
// Empty: to be measured.
[[nodiscard]] const TuningResult* resultInForce(const StationStatus& status, Axis axis, TuningRun run);

// The first tuning of an axis: read the gains, step, ramp, swings, verdict. Where it is follows from what is there.
struct FirstTuning
{
    QString text;
    bool reads = false;            // next: read the gains
    std::optional<TuningRun> run;  // next: this one. Neither: it is done
};
[[nodiscard]] FirstTuning firstTuning(const StationStatus& status, Axis axis);

}  // namespace boresight::ui
