// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/charts/telemetry_store.h"

#include <QByteArray>

#include <limits>

// The last minutes of a TelemetryStore as values of their own, so that a worker can write them down, and the table they
// become: a line for each bin in which something came, times in UTC, columns with axis, quantity and unit.
namespace boresight::ui {

struct TelemetryExcerpt
{
    // Of azimuth, then elevation, by Channel. Of a bin's values the one farthest from zero; not a number: none came.
    using Row = std::array<float, 2 * TelemetryStore::kChannels>;

    UtcTime begin{};  // of the first row; then one each kBin
    std::vector<Row> rows;
};

// Up to `now`, at which it is `utc`. Gui thread; five minutes take some milliseconds.
[[nodiscard]] TelemetryExcerpt takeExcerpt(const TelemetryStore& store, std::chrono::seconds length, SteadyTime now,
                                           UtcTime utc);
[[nodiscard]] QByteArray toCsv(const TelemetryExcerpt& excerpt);

}  // namespace boresight::ui
