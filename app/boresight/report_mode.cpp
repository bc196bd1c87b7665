// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/boresight/report_mode.h"

#include "app/log_output.h"
#include "core/pass_report/pass_summary.h"
#include "core/recording/record_reader.h"
#include "ui/kit/language.h"
#include "ui/report/report_output.h"

#include <QGuiApplication>

#include <optional>
#include <string_view>
#include <vector>

namespace boresight::app {

namespace {

constexpr int kReportDone = 0;
constexpr int kReportWrong = 1;
constexpr int kReportUsage = 2;

constexpr std::string_view kReportOption = "--report";

struct ReportOrder
{
    QStringList recordings;
    QString out;
};

// The arguments after "--report".
std::optional<ReportOrder> readOrder(const QStringList& arguments)
{
    ReportOrder order;
    for (qsizetype i = 0; i < arguments.size(); ++i) {
        if (arguments[i] == QStringLiteral("--out") && i + 1 < arguments.size() && order.out.isEmpty()) {
            order.out = arguments[++i];
        } else {
            order.recordings << arguments[i];
        }
    }
    const auto files = static_cast<std::size_t>(order.recordings.size());
    return !order.out.isEmpty() && files >= 1 && files <= ui::kMostReportPasses ? std::optional(order) : std::nullopt;
}

void complainOfReport(const QString& text)
{
    printError(QStringLiteral("boresight --report: %1").arg(text));
}

Result<recording::Recording> loadWithTicks(const QString& path)
{
    Result<recording::Recording> recording = recording::loadRecording(path);
    if (recording && recording->ticks.empty()) {
        return failure(ErrorCode::NotAvailable,
                       QStringLiteral("%1: %2").arg(path, pass_report::summaryOf(*recording).error().text));
    }
    return recording;
}

}  // namespace

bool asksForReport(int argc, char** argv)
{
    return argc > 1 && argv[1] == kReportOption;
}

int runReport(int argc, char** argv)
{
    qputenv("QT_QPA_PLATFORM", "offscreen");
    const QGuiApplication application(argc, argv);
    const ui::Translation translation({});
    const std::optional<ReportOrder> order = readOrder(QCoreApplication::arguments().sliced(2));
    if (!order) {
        complainOfReport(QStringLiteral("usage: boresight --report FILE [FILE2] --out report.pdf|report.png"));
        return kReportUsage;
    }
    std::vector<recording::Recording> recordings;
    int status = kReportDone;
    for (const QString& path : order->recordings) {
        Result<recording::Recording> recording = loadWithTicks(path);
        if (!recording) {
            complainOfReport(recording.error().text);
            return kReportWrong;
        }
        for (const QString& problem : recording->problems) {
            complainOfReport(QStringLiteral("%1: %2").arg(path, problem));
            status = kReportWrong;
        }
        recordings.push_back(std::move(*recording));
    }
    if (const Result<> written = ui::writeReport(recordings, order->out); !written) {
        complainOfReport(written.error().text);
        return kReportWrong;
    }
    return status;
}

}  // namespace boresight::app
