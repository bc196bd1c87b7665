// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/pass_report/report_table.h"

#include "core/base/numbers.h"
#include "core/base/text.h"
#include "core/units/direction_text.h"
#include "core/units/duration_text.h"

#include <QDateTime>
#include <QTimeZone>

#include <algorithm>
#include <functional>

namespace boresight::pass_report {

namespace {

QDateTime dateTimeOf(UtcTime utc)
{
    const auto since = std::chrono::duration_cast<std::chrono::milliseconds>(utc.time_since_epoch());
    return QDateTime::fromMSecsSinceEpoch(since.count(), QTimeZone::utc());
}

QString fixedText(double value, int decimals)
{
    return toQString(formatFixed(value, decimals));
}

QString dash()
{
    return QStringLiteral("–");
}

QString errorText(const Angle& error)
{
    return degreesText(error, 3);
}

QString secondsText(Seconds time)
{
    return QStringLiteral("%1 s").arg(fixedText(time.count(), 1));
}

QString lossText(const std::optional<double>& loss)
{
    return loss ? QStringLiteral("−%1 dB").arg(fixedText(*loss, 2)) : Text::tr("beyond the main lobe");
}

bool hasBeam(const PassSummary& pass)
{
    return pass.header.beamWidth > Angle();
}

QString errorWithLoss(const PassSummary& pass, const Angle& error, const std::optional<double>& loss)
{
    return hasBeam(pass) ? QStringLiteral("%1, %2").arg(errorText(error), lossText(loss)) : errorText(error);
}

QString extremeText(const std::optional<Extreme>& extreme, const QString& unit)
{
    if (!extreme) {
        return dash();
    }
    const QString value = QStringLiteral("%1 %2").arg(fixedText(extreme->value, 2), unit);
    return extreme->position
               ? Text::tr("%1 at %2, %3").arg(value, degreesText(*extreme->position), clockText(extreme->utc))
               : QStringLiteral("%1, %2").arg(value, clockText(extreme->utc));
}

QString wayText(plan::PlanWay way)
{
    switch (way) {
        case plan::PlanWay::Direct:
            return Text::tr("direct");
        case plan::PlanWay::OverTheTop:
            return Text::tr("over the top");
        case plan::PlanWay::ThroughTheZenith:
            return Text::tr("through the zenith");
        case plan::PlanWay::OtherWayRound:
            return Text::tr("the other way round");
        case plan::PlanWay::WaitsAtTheEnd:
            return Text::tr("waits at the cable end");
        case plan::PlanWay::Unwraps:
            return Text::tr("unwraps the cable");
    }
    return dash();
}

QString trackedByText(const PassSummary& pass)
{
    return pass.header.client.isEmpty() ? Text::tr("Boresight") : pass.header.client;
}

QString offText(const std::optional<Angle>& off)
{
    return off ? errorText(*off) : dash();
}

QString lostText(const PassSummary& pass)
{
    return Text::tr("%1, %2 without ticks").arg(pass.lostTicks).arg(secondsText(pass.withoutTicks));
}

QString eventCounts(const PassSummary& pass)
{
    return QStringLiteral("%1 / %2").arg(pass.alarms).arg(pass.warnings);
}

class TableOfReport
{
public:
    using ValueOf = std::function<QString(const PassSummary&)>;

    explicit TableOfReport(std::span<const PassSummary> passes) : m_passes(passes) {}

    void head(const QString& label) { m_rows.push_back({.label = label}); }
    void row(const QString& label, const ValueOf& valueOf)
    {
        ReportRow row{.label = label};
        for (const PassSummary& pass : m_passes) {
            row.values << valueOf(pass);
        }
        m_rows.push_back(row);
    }
    // A value of the error or of the plan. A pass without it has a dash.
    template <class Part>
    void rowOf(const QString& label, std::optional<Part> PassSummary::*part,
               const std::function<QString(const PassSummary&, const Part&)>& valueOf)
    {
        row(label, [&](const PassSummary& pass) { return pass.*part ? valueOf(pass, *(pass.*part)) : dash(); });
    }
    [[nodiscard]] bool any(const std::function<bool(const PassSummary&)>& has) const
    {
        return std::ranges::any_of(m_passes, has);
    }
    [[nodiscard]] std::vector<ReportRow> rows() const { return m_rows; }

private:
    std::span<const PassSummary> m_passes;
    std::vector<ReportRow> m_rows;
};

void addPass(TableOfReport& table)
{
    table.head(Text::tr("Pass"));
    table.row(Text::tr("Tracked by"), trackedByText);
    table.row(Text::tr("Recorded"), [](const PassSummary& pass) { return durationText(pass.to - pass.from); });
    table.row(Text::tr("Highest point"),
              [](const PassSummary& pass) { return pass.highest ? beamText(*pass.highest) : dash(); });
    table.row(Text::tr("On target after"), [](const PassSummary& pass) {
        return pass.untilOnTarget ? secondsText(*pass.untilOnTarget) : Text::tr("never");
    });
    if (table.any([](const PassSummary& pass) { return pass.wind.has_value(); })) {
        table.row(Text::tr("Strongest wind"), [](const PassSummary& pass) {
            return pass.wind ? QStringLiteral("%1 m/s").arg(fixedText(*pass.wind, 1)) : dash();
        });
    }
}

void addError(TableOfReport& table)
{
    const auto error = [&table](const QString& label, Angle ErrorSummary::*value) {
        table.rowOf<ErrorSummary>(label, &PassSummary::error, [value](const PassSummary&, const ErrorSummary& one) {
            return errorText(one.*value);
        });
    };
    table.head(Text::tr("Pointing error"));
    table.row(Text::tr("Beam width"),
              [](const PassSummary& pass) { return hasBeam(pass) ? degreesText(pass.header.beamWidth, 2) : dash(); });
    error(Text::tr("RMS"), &ErrorSummary::rms);
    error(Text::tr("Median"), &ErrorSummary::median);
    error(Text::tr("95 % of the time"), &ErrorSummary::most95);
    table.rowOf<ErrorSummary>(
        Text::tr("Peak"), &PassSummary::error,
        [](const PassSummary& pass, const ErrorSummary& one) { return errorWithLoss(pass, one.peak, one.peakLoss); });
    table.rowOf<ErrorSummary>(
        Text::tr("Peak at"), &PassSummary::error, [](const PassSummary&, const ErrorSummary& one) {
            const QString time = clockText(one.peakAt);
            return one.peakTarget ? QStringLiteral("%1, %2").arg(time, beamText(*one.peakTarget)) : time;
        });
    table.rowOf<ErrorSummary>(
        Text::tr("Beyond half of the beam"), &PassSummary::error, [](const PassSummary&, const ErrorSummary& one) {
            return one.beyond ? Text::tr("%1 of %2").arg(secondsText(*one.beyond), secondsText(one.counted)) : dash();
        });
}

void addPlan(TableOfReport& table)
{
    if (!table.any([](const PassSummary& pass) { return pass.plan.has_value(); })) {
        return;
    }
    const auto plan = [&table](const QString& label,
                               const std::function<QString(const PassSummary&, const PlanSummary&)>& valueOf) {
        table.rowOf<PlanSummary>(label, &PassSummary::plan, valueOf);
    };
    table.head(Text::tr("Plan"));
    plan(Text::tr("Way"), [](const PassSummary&, const PlanSummary& one) { return wayText(one.way); });
    plan(Text::tr("Expected RMS"),
         [](const PassSummary&, const PlanSummary& one) { return errorText(one.forecast.rms); });
    plan(Text::tr("Expected peak"), [](const PassSummary& pass, const PlanSummary& one) {
        return errorWithLoss(pass, one.forecast.peak, one.forecast.peakLoss);
    });
    plan(Text::tr("Expected beyond"),
         [](const PassSummary&, const PlanSummary& one) { return secondsText(one.forecast.beyond); });
    plan(Text::tr("Hidden by the limits"),
         [](const PassSummary&, const PlanSummary& one) { return secondsText(one.forecast.hidden); });
    plan(Text::tr("Azimuth off the plan"),
         [](const PassSummary&, const PlanSummary& one) { return offText(one.azimuthOff); });
    plan(Text::tr("Elevation off the plan"),
         [](const PassSummary&, const PlanSummary& one) { return offText(one.elevationOff); });
}

void addAxis(TableOfReport& table, Axis axis, const QString& name)
{
    table.head(name);
    table.row(Text::tr("Largest torque"),
              [axis](const PassSummary& pass) { return extremeText(pass.axis(axis).torque, QStringLiteral("Nm")); });
    table.row(Text::tr("Mean torque"), [axis](const PassSummary& pass) {
        const std::optional<double>& mean = pass.axis(axis).meanTorque;
        return mean ? QStringLiteral("%1 Nm").arg(fixedText(*mean, 2)) : dash();
    });
    table.row(Text::tr("Highest speed"),
              [axis](const PassSummary& pass) { return extremeText(pass.axis(axis).rate, QStringLiteral("°/s")); });
}

void addRecording(TableOfReport& table)
{
    table.head(Text::tr("Recording"));
    table.row(Text::tr("Ticks"), [](const PassSummary& pass) { return QString::number(pass.ticks); });
    table.row(Text::tr("Lost ticks"), lostText);
    table.row(Text::tr("Alarms / warnings"), eventCounts);
    table.row(Text::tr("Motions begun"), [](const PassSummary& pass) { return QString::number(pass.motions); });
}

}  // namespace

std::vector<ReportRow> tableOf(std::span<const PassSummary> passes)
{
    TableOfReport table(passes);
    addPass(table);
    addError(table);
    addPlan(table);
    addAxis(table, Axis::Azimuth, Text::tr("Azimuth"));
    addAxis(table, Axis::Elevation, Text::tr("Elevation"));
    addRecording(table);
    return table.rows();
}

QString targetText(const recording::Header& header)
{
    const QString target = header.target.isEmpty() ? Text::tr("unknown target") : header.target;
    return header.number ? QStringLiteral("%1 (%2)").arg(target).arg(*header.number) : target;
}

QString stationText(const recording::Header& header)
{
    const QString mount = header.mount.isEmpty() ? Text::tr("unnamed mount") : header.mount;
    return header.isSimulated ? Text::tr("%1, simulated").arg(mount) : mount;
}

QString spanText(UtcTime from, UtcTime to)
{
    const QDateTime first = dateTimeOf(from);
    const QDateTime last = dateTimeOf(to);
    const QString whole = QStringLiteral("yyyy-MM-dd HH:mm:ss");
    return Text::tr("%1 to %2 UTC")
        .arg(first.toString(whole), last.toString(first.date() == last.date() ? QStringLiteral("HH:mm:ss") : whole));
}

QString clockText(UtcTime utc)
{
    return dateTimeOf(utc).toString(QStringLiteral("HH:mm:ss"));
}

QString cautionText(const PassSummary& pass)
{
    QStringList cautions;
    if (pass.damages > 0) {
        cautions << Text::tr("Parts of the file could not be read: %1.").arg(pass.damages);
    }
    if (!pass.hasEnd) {
        cautions << Text::tr("The recording ended without an orderly end.");
    }
    return cautions.join(QLatin1Char(' '));
}

}  // namespace boresight::pass_report
