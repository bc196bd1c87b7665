// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/charts/strip_frame.h"

#include <QCoreApplication>
#include <QStringList>

#include <cmath>

namespace boresight::ui {

namespace {

class StripTexts
{
    Q_DECLARE_TR_FUNCTIONS(StripTexts)
};

// Parts of the beam width that are drawn beside the error. The widest that fits is used. An error of a tenth of the
// half-power width costs 0.1 dB, half the width costs 3 dB.
constexpr double kBeamShares[] = {50.0, 10.0, 1.0};  // percent

Trace trace(const QString& word, TraceLine line, const PeakRing& ring, const ChartSpan& span)
{
    const std::int64_t first = span.firstColumn();
    Trace trace{.word = word, .line = line, .columns = ring.columns(span.grid, first, first + span.grid.columns)};
    if (!span.cursor) {
        trace.value = ring.at(span.newestBin);
        return trace;
    }
    const std::int64_t column = first + *span.cursor;
    trace.value = ring.range(span.grid.firstBin(column), span.grid.firstBin(column + 1));
    if (!trace.value) {  // there are more pixels than values
        trace.value = ring.at(span.grid.firstBin(column));
    }
    return trace;
}

std::vector<Trace> tracesOf(const TelemetryStore& store, Strip strip, const ChartChoice& choice, const ChartSpan& span)
{
    const auto of = [&](const QString& word, TraceLine line, Channel channel) {
        return trace(word, line, store.ring(choice.axis, channel), span);
    };
    if (strip == Strip::Position) {
        return {of(StripTexts::tr("commanded"), TraceLine::Band, Channel::Commanded),
                of(StripTexts::tr("actual"), TraceLine::Line, Channel::Actual)};
    }
    if (strip == Strip::Error) {
        return {of(StripTexts::tr("commanded − actual"), TraceLine::Line, Channel::Error)};
    }
    switch (choice.quantity) {
        case DriveQuantity::Torque:
            return {of({}, TraceLine::Line, Channel::Torque)};
        case DriveQuantity::Current:
            return {of({}, TraceLine::Line, Channel::Current)};
        case DriveQuantity::Voltage:
            return {of({}, TraceLine::Line, Channel::Voltage)};
        case DriveQuantity::Temperature:
            break;
    }
    return {of(StripTexts::tr("motor"), TraceLine::Band, Channel::MotorTemperature),
            of(StripTexts::tr("board"), TraceLine::Line, Channel::BoardTemperature)};
}

std::vector<ReferenceLine> referencesOf(Strip strip, const ChartChoice& choice, const ChartLimits& chart)
{
    if (strip == Strip::Position) {
        return {};
    }
    std::vector<ReferenceLine> lines;
    if (strip == Strip::Error) {
        for (const double share : kBeamShares) {
            const double level = chart.beamWidth.degrees() * share / 100.0;
            lines.push_back({level, StripTexts::tr("%1 % of the beam").arg(share)});
            lines.push_back({-level, {}});
        }
        return lines;
    }
    const profile::Profile& profile = *chart.profile;
    const profile::SupervisionSettings& limits = profile.supervision;
    const profile::AxisSettings& axis = choice.axis == Axis::Azimuth ? profile.azimuth : profile.elevation;
    switch (choice.quantity) {
        case DriveQuantity::Torque:
            return {{axis.maxTorque, StripTexts::tr("greatest")}, {-axis.maxTorque, {}}};
        case DriveQuantity::Current:
            return {};
        case DriveQuantity::Voltage:
            return {{limits.supplyLow, StripTexts::tr("low")}, {limits.supplyHigh, StripTexts::tr("high")}};
        case DriveQuantity::Temperature:
            break;
    }
    return {{limits.boardHot, StripTexts::tr("board hot")}, {limits.motorHot, StripTexts::tr("motor hot")}};
}

}  // namespace

std::optional<SteadyTime> ChartSpan::cursorTime() const
{
    if (!cursor) {
        return std::nullopt;
    }
    const std::int64_t column = firstColumn() + *cursor;
    return TelemetryStore::timeOf((grid.firstBin(column) + grid.firstBin(column + 1)) / 2);
}

ChartSpan spanOf(std::chrono::seconds window, int columns, SteadyTime newest, std::optional<int> cursor)
{
    return {.grid = {.bins = window / TelemetryStore::kBin, .columns = std::max(1, columns)},
            .newestBin = TelemetryStore::binOf(newest),
            .cursor = cursor && *cursor < columns ? cursor : std::nullopt};
}

StripForm formOf(Strip strip, DriveQuantity quantity)
{
    if (strip == Strip::Position) {
        return {.title = StripTexts::tr("Position"), .unit = QStringLiteral("°"), .decimals = 2, .leastSpan = 1.0};
    }
    if (strip == Strip::Error) {
        return {.title = StripTexts::tr("Error"),
                .unit = QStringLiteral("°"),
                .decimals = 3,
                .leastSpan = 0.1,
                .scale = ScaleForm::AroundZero};
    }
    switch (quantity) {
        case DriveQuantity::Torque:
            return {.title = name(quantity), .unit = QStringLiteral(" Nm"), .decimals = 2, .leastSpan = 0.5};
        case DriveQuantity::Current:
            return {.title = name(quantity), .unit = QStringLiteral(" A"), .decimals = 2, .leastSpan = 1.0};
        case DriveQuantity::Voltage:
            return {.title = name(quantity), .unit = QStringLiteral(" V"), .decimals = 1, .leastSpan = 2.0};
        case DriveQuantity::Temperature:
            break;
    }
    return {.title = name(quantity), .unit = QStringLiteral(" °C"), .decimals = 1, .leastSpan = 5.0};
}

StripFrame frameOf(const TelemetryStore& store, Strip strip, const ChartChoice& choice, const ChartSpan& span,
                   const ChartLimits& limits)
{
    return {.firstColumn = span.firstColumn(),
            .columns = span.grid.columns,
            .traces = tracesOf(store, strip, choice, span),
            .references = referencesOf(strip, choice, limits),
            .cursor = span.cursor};
}

QString name(DriveQuantity quantity)
{
    switch (quantity) {
        case DriveQuantity::Torque:
            return StripTexts::tr("Torque");
        case DriveQuantity::Current:
            return StripTexts::tr("q current");
        case DriveQuantity::Voltage:
            return StripTexts::tr("Voltage");
        case DriveQuantity::Temperature:
            break;
    }
    return StripTexts::tr("Temperature");
}

QString valueText(const std::optional<PeakRange>& value, int decimals)
{
    if (!value) {
        return QStringLiteral("–");
    }
    const auto text = [decimals](float number) {
        QString written = QString::number(static_cast<double>(number), 'f', decimals);
        return written.toDouble() == 0.0 ? QString::number(0.0, 'f', decimals) : written;  // no "-0.00"
    };
    const QString least = text(value->min);
    const QString greatest = text(value->max);
    return least == greatest ? least : least + QStringLiteral("…") + greatest;
}

QString describe(const StripForm& form, const StripFrame& frame)
{
    QStringList parts;
    for (const Trace& trace : frame.traces) {
        std::optional<PeakRange> whole;
        for (const PeakColumn& column : trace.columns) {
            whole = whole.value_or(column.range);
            whole->include(column.range);
        }
        if (whole) {
            parts << StripTexts::tr("%1 %2%3, range %4%3")
                         .arg(trace.word, valueText(trace.value, form.decimals), form.unit,
                              valueText(whole, form.decimals))
                         .trimmed();
        }
    }
    return StripTexts::tr("%1: %2").arg(form.title,
                                        parts.isEmpty() ? StripTexts::tr("no data") : parts.join(QStringLiteral("; ")));
}

}  // namespace boresight::ui
