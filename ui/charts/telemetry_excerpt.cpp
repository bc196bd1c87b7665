// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/charts/telemetry_excerpt.h"

#include "ui/kit/axes.h"

#include <QDateTime>

#include <algorithm>
#include <cmath>

namespace boresight::ui {

namespace {

constexpr float kNone = std::numeric_limits<float>::quiet_NaN();
constexpr const char* kColumns[] = {"commanded_deg", "actual_deg", "error_deg", "torque_nm",
                                    "current_a",     "voltage_v",  "board_c",   "motor_c"};
static_assert(std::size(kColumns) == TelemetryStore::kChannels);

float farthest(const std::optional<PeakRange>& range)
{
    if (!range) {
        return kNone;
    }
    return std::abs(range->min) > std::abs(range->max) ? range->min : range->max;
}

QByteArray header()
{
    QByteArray line("utc");
    for (const char* const axis : {"azimuth", "elevation"}) {
        for (const char* const column : kColumns) {
            line += QByteArray(",") + axis + '_' + column;
        }
    }
    return line + '\n';
}

}  // namespace

TelemetryExcerpt takeExcerpt(const TelemetryStore& store, std::chrono::seconds length, SteadyTime now, UtcTime utc)
{
    const std::int64_t end = TelemetryStore::binOf(now) + 1;
    const std::int64_t first = end - length / TelemetryStore::kBin;
    TelemetryExcerpt excerpt;
    excerpt.begin = utc + std::chrono::duration_cast<UtcTime::duration>(TelemetryStore::timeOf(first) - now);
    excerpt.rows.resize(static_cast<std::size_t>(end - first));
    for (const Axis axis : kAxes) {
        for (std::size_t channel = 0; channel < TelemetryStore::kChannels; ++channel) {
            const PeakRing& ring = store.ring(axis, static_cast<Channel>(channel));
            const std::size_t column = axisIndex(axis) * TelemetryStore::kChannels + channel;
            for (std::int64_t bin = first; bin < end; ++bin) {
                excerpt.rows[static_cast<std::size_t>(bin - first)][column] = farthest(ring.range(bin, bin + 1));
            }
        }
    }
    return excerpt;
}

QByteArray toCsv(const TelemetryExcerpt& excerpt)
{
    QByteArray csv = header();
    UtcTime time = excerpt.begin;
    for (const TelemetryExcerpt::Row& row : excerpt.rows) {
        if (std::ranges::any_of(row, [](float value) { return !std::isnan(value); })) {
            const auto sinceEpoch = std::chrono::duration_cast<std::chrono::milliseconds>(time.time_since_epoch());
            csv += QDateTime::fromMSecsSinceEpoch(sinceEpoch.count(), Qt::UTC).toString(Qt::ISODateWithMs).toLatin1();
            for (const float value : row) {
                csv += std::isnan(value) ? QByteArray(",") : ',' + QByteArray::number(double(value), 'f', 3);
            }
            csv += '\n';
        }
        time += TelemetryStore::kBin;
    }
    return csv;
}

}  // namespace boresight::ui
