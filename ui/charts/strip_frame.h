// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/profile/profile.h"
#include "ui/charts/strip_scale.h"
#include "ui/charts/telemetry_store.h"

#include <QString>

#include <chrono>
#include <memory>
#include <optional>
#include <vector>

// The present contents of a strip as plain values, taken from the store for the chosen axis and time. StripChart paints
// them. Pure. A column is one pixel of the screen, counted from the start of time. The last column is the present.
namespace boresight::ui {

enum class Strip
{
    Position,
    Error,
    Drive
};

// The quantity in the strip of the drive.
enum class DriveQuantity
{
    Torque,
    Current,
    Voltage,
    Temperature
};

enum class TraceLine
{
    Line,
    Band  // broad and pale, below the line
};

struct Trace
{
    QString word;
    TraceLine line = TraceLine::Line;
    std::vector<PeakColumn> columns;
    std::optional<PeakRange> value;  // at the cursor, otherwise the newest value
};

// A level with a meaning: a limit, or a part of the beam width.
struct ReferenceLine
{
    double value = 0.0;
    QString text;
};

struct StripFrame
{
    std::int64_t firstColumn = 0;
    std::int64_t columns = 1;
    std::vector<Trace> traces;
    std::vector<ReferenceLine> references;
    std::optional<int> cursor;  // columns from the left
};

// The part that does not change while the same contents are shown.
struct StripForm
{
    QString title;
    QString unit;
    int decimals = 2;
    double leastSpan = 1.0;
    ScaleForm scale = ScaleForm::Free;
};

struct ChartChoice
{
    Axis axis = Axis::Azimuth;
    std::chrono::seconds window{60};
    DriveQuantity quantity = DriveQuantity::Torque;
};

// The part of the time that is shown: `columns` wide, the newest at the right end.
struct ChartSpan
{
    PeakGrid grid;
    std::int64_t newestBin = 0;
    std::optional<int> cursor;  // columns from the left

    [[nodiscard]] std::int64_t firstColumn() const { return grid.columnOf(newestBin) + 1 - grid.columns; }
    // The time in the middle of the column under the cursor.
    [[nodiscard]] std::optional<SteadyTime> cursorTime() const;
};

[[nodiscard]] ChartSpan spanOf(std::chrono::seconds window, int columns, SteadyTime newest, std::optional<int> cursor);
[[nodiscard]] StripForm formOf(Strip strip, DriveQuantity quantity);
// The values for the reference lines.
struct ChartLimits
{
    std::shared_ptr<const profile::Profile> profile = std::make_shared<const profile::Profile>();
    Angle beamWidth = Angle::fromDegrees(10.0);  // of the antenna in use
};
[[nodiscard]] StripFrame frameOf(const TelemetryStore& store, Strip strip, const ChartChoice& choice,
                                 const ChartSpan& span, const ChartLimits& limits);
[[nodiscard]] QString name(DriveQuantity quantity);
// "12.30", or "12.10…12.50" for a column with a range, or "–" without a value.
[[nodiscard]] QString valueText(const std::optional<PeakRange>& value, int decimals);
// In words, for screen readers: "Position: commanded 12.30°, in between 10.00…12.30°; actual …".
[[nodiscard]] QString describe(const StripForm& form, const StripFrame& frame);

}  // namespace boresight::ui
