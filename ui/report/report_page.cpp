// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/report/report_page.h"

#include "core/base/text.h"
#include "core/units/degrees_text.h"
#include "ui/report/paper_text.h"
#include "ui/report/report_chart.h"
#include "ui/report/report_sky.h"

#include <QTextOption>

#include <algorithm>
#include <cmath>

namespace boresight::ui {

namespace {

using pass_report::PassSummary;
using pass_report::PassTrace;
using pass_report::ReportRow;
using pass_report::TraceLine;

constexpr std::size_t kTraceColumns = 800;
constexpr std::size_t kMostEventLines = 8;

constexpr qreal kPaperMargin = 150.0;
constexpr qreal kSheetWidth = 1800.0;
constexpr qreal kTextLine = 40.0;
constexpr qreal kSkyWidth = 860.0;
constexpr qreal kSkyWidthOfPair = 760.0;  // the table of two passes is wider
constexpr qreal kMiddleHeight = 1130.0;   // sky, and the table beside it
constexpr qreal kReportGap = 24.0;

QString nameOfPass(std::size_t i)
{
    return QString(QChar(u'A' + static_cast<char16_t>(i)));
}

// Title, and two lines for each pass. Returns the height.
qreal drawTitle(QPainter& painter, qreal top, const ReportPage& page)
{
    const bool isPair = page.passes.size() > 1;
    const qreal titleHeight = 80.0;
    drawPaperText(painter, {kPaperMargin, top, kSheetWidth, titleHeight},
                  {.text = isPair ? Text::tr("Two passes compared") : Text::tr("Report of a pass"),
                   .size = kTitleLetters,
                   .isBold = true});
    qreal y = top + titleHeight;
    for (std::size_t i = 0; i < page.passes.size(); ++i) {
        const PassSummary& pass = page.passes[i];
        const QString head =
            Text::tr("%1, station %2").arg(pass_report::targetText(pass.header), pass_report::stationText(pass.header));
        drawPaperText(painter, {kPaperMargin, y, kSheetWidth, kTextLine},
                      {.text = isPair ? QStringLiteral("%1: %2").arg(nameOfPass(i), head) : head,
                       .size = kTableLetters + 5,
                       .colour = isPair ? kPassInk[i] : kInk,
                       .isBold = true});
        y += kTextLine;
        const QString caution = pass_report::cautionText(pass);
        drawPaperText(
            painter, {kPaperMargin, y, kSheetWidth * 0.55, kTextLine},
            {.text = QStringLiteral("%1, %2").arg(pass_report::spanText(pass.from, pass.to), pass.header.program)});
        drawPaperText(painter, {kPaperMargin + kSheetWidth * 0.56, y, kSheetWidth * 0.44, kTextLine},
                      {.text = caution, .colour = kBoundInk, .alignment = Qt::AlignRight | Qt::AlignVCenter});
        y += kTextLine;
    }
    return y - top;
}

void drawTableRow(QPainter& painter, const QRectF& room, const ReportRow& row, qreal labelWidth)
{
    if (row.isHeading()) {
        drawPaperText(painter, room, {.text = row.label, .isBold = true});
        painter.setPen(paperPen(kPaperGrid, 2.0));
        painter.drawLine(room.bottomLeft(), room.bottomRight());
        return;
    }
    drawPaperText(painter, {room.left(), room.top(), labelWidth - 10.0, room.height()},
                  {.text = row.label, .colour = kFaintInk});
    const qreal width = (room.width() - labelWidth) / static_cast<qreal>(row.values.size());
    for (qsizetype i = 0; i < row.values.size(); ++i) {
        drawPaperText(
            painter,
            {room.left() + labelWidth + width * static_cast<qreal>(i), room.top(), width - 10.0, room.height()},
            {.text = row.values[i], .colour = row.values.size() > 1 ? kPassInk.at(static_cast<std::size_t>(i)) : kInk});
    }
}

void drawReportTable(QPainter& painter, const QRectF& room, const ReportPage& page)
{
    constexpr qreal kRow = 36.0;
    const qreal height = std::min(kRow, room.height() / static_cast<qreal>(page.table.size()));
    const qreal labelWidth = page.passes.size() > 1 ? 300.0 : 360.0;
    qreal y = room.top();
    for (const ReportRow& row : page.table) {
        drawTableRow(painter, {room.left(), y, room.width(), height}, row, labelWidth);
        y += height;
    }
}

void drawNotes(QPainter& painter, const QRectF& room)
{
    QTextOption wrapped(Qt::AlignLeft | Qt::AlignBottom);
    wrapped.setWrapMode(QTextOption::WordWrap);
    painter.setFont(paperFont(kSmallLetters - 1));
    painter.setPen(kFaintInk);
    painter.drawText(
        room,
        Text::tr(
            "The error is the angle between the beam and the target. It counts after the first second "
            "on target. On target is within half of the beam width. The parts that the limits hide by the "
            "plan do not count. The circle marks the beginning. A torque has its mean as a dark line, and its least "
            "and largest values as a light band."),
        wrapped);
}

Seconds spanOf(const ReportPage& page)
{
    Seconds span{};
    for (const PassSummary& pass : page.passes) {
        span = std::max(span, Seconds(pass.to - pass.from));
    }
    return span;
}

QString minutesText(Seconds since)
{
    const long seconds = std::lround(since.count());
    return QStringLiteral("%1:%2").arg(seconds / 60).arg(seconds % 60, 2, 10, QLatin1Char('0'));
}

// One pass has the time of day. Two have the time since the begin of each.
std::function<QString(Seconds)> timeTextOf(const ReportPage& page)
{
    if (page.passes.size() > 1) {
        return minutesText;
    }
    return [from = page.passes.front().from](Seconds since) {
        return pass_report::clockText(std::chrono::round<std::chrono::seconds>(from + since));
    };
}

// The time of day at which a chart with this time begins.
Seconds phaseOf(const ReportPage& page)
{
    const Seconds since = page.passes.front().from.time_since_epoch();
    return page.passes.size() > 1 ? Seconds(0.0) : Seconds(std::fmod(since.count(), 86'400.0));
}

template <class LineOf>
ReportChart chartOf(const ReportPage& page, const QString& title, const LineOf& lineOf)
{
    ReportChart chart{.title = title, .span = spanOf(page), .phase = phaseOf(page)};
    bool isEmpty = true;
    for (std::size_t i = 0; i < page.traces.size(); ++i) {
        chart.lines.push_back({.points = lineOf(page.traces[i]), .colour = kPassInk.at(i)});
        isEmpty = isEmpty && chart.lines.back().points.empty();
    }
    if (isEmpty) {
        chart.title = Text::tr("%1: not recorded").arg(title);
    }
    return chart;
}

ReportChart errorChart(const ReportPage& page)
{
    ReportChart chart =
        chartOf(page, Text::tr("Pointing error (°)"), [](const PassTrace& trace) { return trace.error; });
    chart.largest = errorChartTop(page);
    chart.boundText = halfBeamText(page);
    if (!chart.boundText.isEmpty()) {
        chart.bound = 0.5 * page.passes.front().header.beamWidth.degrees();
    }
    return chart;
}

ReportChart torqueChart(const ReportPage& page, Axis axis)
{
    ReportChart chart =
        chartOf(page, axis == Axis::Azimuth ? Text::tr("Azimuth torque (Nm)") : Text::tr("Elevation torque (Nm)"),
                [axis](const PassTrace& trace) { return trace.torque[index(axis)]; });
    for (std::size_t i = 0; i < chart.lines.size(); ++i) {
        ReportChart::Line& line = chart.lines[i];
        line.isBand = true;
        line.mean = page.traces[i].meanTorque[index(axis)];
    }
    double least = 0.0;
    double largest = 0.0;
    for (const ReportChart::Line& line : chart.lines) {
        for (const auto& piece : line.points) {
            for (const pass_report::TracePoint& point : piece) {
                least = std::min(least, point.value);
                largest = std::max(largest, point.value);
            }
        }
    }
    const double room = std::max(0.08 * (largest - least), 0.01);
    chart.least = least < 0.0 ? least - room : 0.0;
    chart.largest = largest > 0.0 || least == 0.0 ? largest + room : 0.0;
    return chart;
}

QString levelText(const recording::Event& event)
{
    if (event.level == recording::EventLevel::Alarm) {
        return Text::tr("ALARM");
    }
    if (event.level == recording::EventLevel::Warning) {
        return Text::tr("WARNING");
    }
    return event.kind == recording::EventKind::MotionStart ? Text::tr("motion") : QString();
}

QString sentenceOf(const recording::Event& event)
{
    const QString text = event.text.simplified();
    return event.source.isEmpty() ? text : QStringLiteral("%1: %2").arg(event.source, text);
}

void drawEventLine(QPainter& painter, const QRectF& room, const recording::Event& event, const QColor& colour)
{
    const qreal timeWidth = 150.0;
    const qreal levelWidth = 180.0;
    drawPaperText(painter, {room.left(), room.top(), timeWidth, room.height()},
                  {.text = pass_report::clockText(event.utc), .size = kSmallLetters, .colour = colour});
    drawPaperText(painter, {room.left() + timeWidth, room.top(), levelWidth - 10.0, room.height()},
                  {.text = levelText(event),
                   .size = kSmallLetters,
                   .colour = event.level == recording::EventLevel::Alarm ? kBoundInk : kInk,
                   .isBold = event.level != recording::EventLevel::Advisory});
    drawPaperText(painter, room.adjusted(timeWidth + levelWidth, 0.0, 0.0, 0.0),
                  {.text = sentenceOf(event), .size = kSmallLetters});
}

void drawEvents(QPainter& painter, const QRectF& room, const ReportPage& page)
{
    const qreal line = 33.0;
    QRectF here(room.left(), room.top(), room.width(), line);
    const auto next = [&] { here.translate(0.0, line); };
    const bool isEmpty = std::ranges::all_of(page.events, [](const auto& events) { return events.empty(); });
    drawPaperText(
        painter, here,
        {.text = isEmpty               ? Text::tr("Events: none")
                 : page.moreEvents > 0 ? Text::tr("Events. The recording has further ones: %1").arg(page.moreEvents)
                                       : Text::tr("Events"),
         .isBold = true});
    next();
    for (std::size_t i = 0; i < page.events.size(); ++i) {
        for (const recording::Event& event : page.events[i]) {
            drawEventLine(painter, here, event, page.events.size() > 1 ? kPassInk.at(i) : kFaintInk);
            next();
        }
    }
}

}  // namespace

Result<ReportPage> reportPageOf(std::span<const recording::Recording> recordings)
{
    if (recordings.empty() || recordings.size() > kMostReportPasses) {
        return failure(ErrorCode::InvalidInput, Text::tr("A report is of one recording or of two."));
    }
    ReportPage page;
    for (const recording::Recording& recording : recordings) {
        const Result<PassSummary> summary = pass_report::summaryOf(recording);
        if (!summary) {
            return failure(summary.error().code, QStringLiteral("%1: %2").arg(pass_report::targetText(recording.header),
                                                                              summary.error().text));
        }
        page.passes.push_back(*summary);
        page.traces.push_back(pass_report::traceOf(recording, kTraceColumns));
        page.events.push_back(pass_report::importantEvents(recording, kMostEventLines / recordings.size()));
        page.moreEvents +=
            pass_report::importantEvents(recording, recording.events.size()).size() - page.events.back().size();
    }
    page.table = pass_report::tableOf(page.passes);
    return page;
}

QString halfBeamText(const ReportPage& page)
{
    const Angle width = page.passes.front().header.beamWidth;
    const bool isSame =
        std::ranges::all_of(page.passes, [width](const PassSummary& pass) { return pass.header.beamWidth == width; });
    return isSame && width > Angle() ? Text::tr("Half of the beam: %1").arg(degreesText(0.5 * width, 2)) : QString();
}

double errorChartTop(const ReportPage& page)
{
    constexpr double kRoom = 1.15;
    constexpr double kFar = 5.0;  // times the peak: the line of the half beam would leave no height for the error
    double peak = 0.0;
    for (const PassSummary& pass : page.passes) {
        peak = std::max(peak, pass.error ? pass.error->peak.degrees() : 0.0);
    }
    const double half = 0.5 * page.passes.front().header.beamWidth.degrees();
    const double top = half <= kFar * peak || peak <= 0.0 ? std::max(peak, half) : peak;
    return top > 0.0 ? kRoom * top : 1.0;
}

void drawReportPage(QPainter& painter, const ReportPage& page)
{
    painter.fillRect(QRectF(QPointF(), kPaperSize), Qt::white);
    painter.setRenderHint(QPainter::Antialiasing);
    qreal y = 110.0;
    y += drawTitle(painter, y, page) + kReportGap;
    const qreal skyWidth = page.passes.size() > 1 ? kSkyWidthOfPair : kSkyWidth;
    const qreal skyHeight = skyWidth + kTextLine;
    drawReportSky(painter, {kPaperMargin, y, skyWidth, skyHeight}, page.traces);
    drawNotes(painter, {kPaperMargin, y + skyHeight + 10.0, skyWidth - 20.0, kMiddleHeight - skyHeight - 10.0});
    const qreal right = kPaperMargin + skyWidth + 30.0;
    drawReportTable(painter, {right, y, kPaperMargin + kSheetWidth - right, kMiddleHeight}, page);
    y += kMiddleHeight + kReportGap;
    const qreal bottom = kPaperSize.height() - 100.0;
    const qreal eventsHeight = 33.0 * static_cast<qreal>(kMostEventLines + 1);
    const qreal charts = bottom - eventsHeight - kReportGap - y;
    const auto draw = [&](double share, ReportChart chart, bool isLast) {
        if (isLast) {
            chart.timeText = timeTextOf(page);
        }
        drawReportChart(painter, {kPaperMargin, y, kSheetWidth, charts * share - 10.0}, chart);
        y += charts * share;
    };
    draw(0.4, errorChart(page), false);
    draw(0.285, torqueChart(page, Axis::Azimuth), false);
    draw(0.315, torqueChart(page, Axis::Elevation), true);
    drawEvents(painter, {kPaperMargin, y + kReportGap, kSheetWidth, eventsHeight}, page);
}

}  // namespace boresight::ui
