// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/charts/telemetry_store.h"

#include <QByteArray>

#include <limits>

// The last minutes of a TelemetryStore as separate values, so that a worker can write them, and the table made of them:
// a line for each bin with a value, times in UTC, columns with axis, quantity and unit.
namespace boresight::ui {

struct TelemetryExcerpt
{
    // Azimuth first, then elevation, by Channel. The value of a bin that is farthest from zero, or not a number if
    // there was none.
    using Row = std::array<float, 2 * TelemetryStore::kChannels>;

    UtcTime begin{};  // the time of the first row; the next rows follow every kBin
    std::vector<Row> rows;
};

// Up to `now`, when the UTC is `utc`. Gui thread. Five minutes of data take some milliseconds.
[[nodiscard]] TelemetryExcerpt takeExcerpt(const TelemetryStore& store, std::chrono::seconds length, SteadyTime now,
                                           UtcTime utc);
[[nodiscard]] QByteArray toCsv(const TelemetryExcerpt& excerpt);

}  // namespace boresight::ui
