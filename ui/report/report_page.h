// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"
#include "core/pass_report/pass_summary.h"
#include "core/pass_report/pass_trace.h"
#include "core/pass_report/report_table.h"
#include "core/recording/recording.h"

#include <QPainter>
#include <QSizeF>
#include <QString>

#include <span>
#include <vector>

// A page with one recorded pass, or with two that are compared: sky, numbers, error and torque over time, events. Any
// thread with a QGuiApplication.
namespace boresight::ui {

inline constexpr std::size_t kMostReportPasses = 2;
inline constexpr QSizeF kPaperSize{2100.0, 2970.0};  // A4 in 0.1 mm

struct ReportPage
{
    std::vector<pass_report::PassSummary> passes;
    std::vector<pass_report::PassTrace> traces;
    std::vector<pass_report::ReportRow> table;
    std::vector<std::vector<recording::Event>> events;  // of each pass, with those that matter most
    std::size_t moreEvents = 0;                         // without the lines of clients
};

// One recording, or two. The error names the recording that has no ticks.
[[nodiscard]] Result<ReportPage> reportPageOf(std::span<const recording::Recording> recordings);

// "Half of the beam: 1.25°". Empty: the beam widths are unknown or differ.
[[nodiscard]] QString halfBeamText(const ReportPage& page);
// The top of the chart of the error in degrees. Larger values, as on the way to the target, are cut.
[[nodiscard]] double errorChartTop(const ReportPage& page);

// Draws in units of 0.1 mm.
void drawReportPage(QPainter& painter, const ReportPage& page);

}  // namespace boresight::ui
