// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/pass_report/pass_summary.h"

#include <QString>
#include <QStringList>

#include <span>
#include <vector>

// The words of a report. Pure, any thread.
namespace boresight::pass_report {

struct ReportRow
{
    QString label;
    QStringList values;  // one for each pass; empty: the row is a heading

    [[nodiscard]] bool isHeading() const { return values.isEmpty(); }
    bool operator==(const ReportRow&) const = default;
};

// The numbers of one pass, or of several passes side by side.
[[nodiscard]] std::vector<ReportRow> tableOf(std::span<const PassSummary> passes);

// "NOAA 19 (33591)".
[[nodiscard]] QString targetText(const recording::Header& header);
// "Roof, simulated".
[[nodiscard]] QString stationText(const recording::Header& header);
// "2026-11-30 14:00:00 to 14:12:05 UTC".
[[nodiscard]] QString spanText(UtcTime from, UtcTime to);
// "14:00:05".
[[nodiscard]] QString clockText(UtcTime utc);
// What a reader must know before the numbers: parts of the file are missing. Empty: nothing.
[[nodiscard]] QString cautionText(const PassSummary& pass);

}  // namespace boresight::pass_report
