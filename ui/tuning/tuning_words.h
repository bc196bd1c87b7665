// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/messages/station_status.h"

#include <QString>

#include <optional>
#include <vector>

// The names of the runs, gains and figures of the tuning, and the next step of the first tuning. Pure.
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

// In the same order for each result of the same kind.
[[nodiscard]] std::vector<Figure> figuresOf(const TuningResult& result);

struct BeforeAndAfter
{
    const TuningResult* before = nullptr;  // with the gains as first found
    const TuningResult* after = nullptr;   // with other gains
};
[[nodiscard]] BeforeAndAfter resultsOf(const TuningStatus& tuning, Axis axis, TuningRun run);

// The result that applies to the present state of the axis: the newest with the gains in effect, or while the gains are
// not read the newest of all. Empty: to be measured.
[[nodiscard]] const TuningResult* resultInForce(const StationStatus& status, Axis axis, TuningRun run);

// The first tuning of an axis: read the gains, step, ramp, sweep, verdict. The next step follows from the existing
// results.
struct FirstTuning
{
    QString text;
    bool reads = false;            // next step: read the gains
    std::optional<TuningRun> run;  // next step: this run. Without both the tuning is done
};
[[nodiscard]] FirstTuning firstTuning(const StationStatus& status, Axis axis);

}  // namespace boresight::ui
