// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/night/schedule_json.h"

#include <QDateTime>
#include <QJsonArray>
#include <QJsonDocument>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace boresight {
namespace {

constexpr std::size_t kMostRows = 100;
constexpr double kTenths = 10.0;
constexpr double kThousandths = 1000.0;

QString utcSecondText(UtcTime utc)
{
    const auto ms = std::chrono::round<std::chrono::milliseconds>(utc.time_since_epoch());
    return QDateTime::fromMSecsSinceEpoch(ms.count(), Qt::UTC).toString(QStringLiteral("yyyy-MM-ddTHH:mm:ssZ"));
}

double roundedTo(double value, double parts)
{
    return std::round(value * parts) / parts;
}

QString reasonWord(schedule::Reason reason)
{
    constexpr std::array kWords{"priority", "longer", "earlier", "number"};
    return QLatin1String(kWords.at(static_cast<std::size_t>(reason)));
}

QString endWord(schedule::PassEnd end)
{
    constexpr std::array kWords{"done", "manual", "fault", "refused", "interrupted", "running"};
    return QLatin1String(kWords.at(static_cast<std::size_t>(end)));
}

QString momentWord(schedule::Moment moment)
{
    constexpr std::array kWords{"before_aos", "aos", "los", "fault"};
    return QLatin1String(kWords.at(static_cast<std::size_t>(moment)));
}

QJsonObject passObject(const schedule::WatchedPass& one)
{
    return {{QStringLiteral("norad"), qint64{one.number}},
            {QStringLiteral("name"), one.name},
            {QStringLiteral("priority"), one.priority},
            {QStringLiteral("aos_utc"), utcSecondText(one.rises())},
            {QStringLiteral("los_utc"), utcSecondText(one.sets())},
            {QStringLiteral("max_el"), roundedTo(one.pass.tca.direction.elevation.degrees(), kTenths)},
            {QStringLiteral("part"), one.rest.has_value()}};
}

QJsonArray restsArray(const std::vector<passes::Stretch>& rests)
{
    QJsonArray all;
    for (const passes::Stretch& rest : rests) {
        all.append(QJsonObject{{QStringLiteral("from_utc"), utcSecondText(rest.from)},
                               {QStringLiteral("to_utc"), utcSecondText(rest.to)}});
    }
    return all;
}

QJsonObject conflictObject(const schedule::Conflict& one)
{
    return {{QStringLiteral("left_out"), passObject(one.leftOut)},
            {QStringLiteral("chosen"), passObject(one.chosen)},
            {QStringLiteral("by"), reasonWord(one.reason)},
            {QStringLiteral("overlap"), one.overlaps},
            {QStringLiteral("tracked"), restsArray(one.rests)}};
}

QJsonValue errorValue(const std::optional<Angle>& error)
{
    return error ? QJsonValue(roundedTo(error->degrees(), kThousandths)) : QJsonValue();
}

QJsonObject recordObject(const schedule::PassRecord& pass)
{
    return {{QStringLiteral("norad"), qint64{pass.number}},
            {QStringLiteral("name"), pass.name},
            {QStringLiteral("aos_utc"), utcSecondText(pass.aos)},
            {QStringLiteral("los_utc"), utcSecondText(pass.los)},
            {QStringLiteral("tracked_s"), roundedTo(pass.tracked.count(), kTenths)},
            {QStringLiteral("within_1db_s"), roundedTo(pass.within1dB.count(), kTenths)},
            {QStringLiteral("within_3db_s"), roundedTo(pass.within3dB.count(), kTenths)},
            {QStringLiteral("rms_deg"), errorValue(pass.rmsError)},
            {QStringLiteral("peak_deg"), errorValue(pass.peakError)},
            {QStringLiteral("end"), endWord(pass.end)},
            {QStringLiteral("why"), pass.why}};
}

// The report with its last passes only.
QJsonObject reportObject(const schedule::NightReport& report)
{
    QJsonArray passes;
    const std::size_t count = report.passes.size();
    for (std::size_t i = count - std::min(kMostRows, count); i < count; ++i) {
        passes.append(recordObject(report.passes[i]));
    }
    return {{QStringLiteral("done"), report.done()},
            {QStringLiteral("interventions"), report.interventions},
            {QStringLiteral("faults"), report.faults},
            {QStringLiteral("passes"), passes}};
}

QJsonObject nightObject(const RehearsedNight& night)
{
    QJsonArray remarks;
    for (const RehearsedNight::Remark& remark : night.remarks) {
        remarks.append(
            QJsonObject{{QStringLiteral("utc"), utcSecondText(remark.utc)}, {QStringLiteral("text"), remark.text}});
    }
    return {{QStringLiteral("from_utc"), utcSecondText(night.from)},
            {QStringLiteral("to_utc"), utcSecondText(night.to)},
            {QStringLiteral("planned"), qint64(night.plan.chosen.size())},
            {QStringLiteral("conflicts"), qint64(night.plan.conflicts.size())},
            {QStringLiteral("hidden"), qint64(night.plan.hidden.size())},
            {QStringLiteral("axis_from_deg"), roundedTo(night.leastAzimuth.degrees(), kTenths)},
            {QStringLiteral("axis_to_deg"), roundedTo(night.mostAzimuth.degrees(), kTenths)},
            {QStringLiteral("disarmed"), night.disarmed},
            {QStringLiteral("report"), reportObject(night.report)},
            {QStringLiteral("remarks"), remarks}};
}

QByteArray jsonLine(const QJsonObject& object)
{
    return QJsonDocument(object).toJson(QJsonDocument::Compact);
}

}  // namespace

QByteArray planJson(const ScheduleStatus& status)
{
    QJsonArray chosen;
    for (std::size_t i = 0; i < std::min(kMostRows, status.plan.chosen.size()); ++i) {
        chosen.append(passObject(status.plan.chosen[i]));
    }
    QJsonArray conflicts;
    for (std::size_t i = 0; i < std::min(kMostRows, status.plan.conflicts.size()); ++i) {
        conflicts.append(conflictObject(status.plan.conflicts[i]));
    }
    QJsonArray hidden;
    for (std::size_t i = 0; i < std::min(kMostRows, status.plan.hidden.size()); ++i) {
        hidden.append(passObject(status.plan.hidden[i]));
    }
    return jsonLine({{QStringLiteral("armed"), status.armed},
                     {QStringLiteral("why"), status.why},
                     {QStringLiteral("tracked"), status.tracked ? QJsonValue(qint64{*status.tracked}) : QJsonValue()},
                     {QStringLiteral("passes"), chosen},
                     {QStringLiteral("conflicts"), conflicts},
                     {QStringLiteral("hidden"), hidden}});
}

QByteArray reportJson(const schedule::NightReport& report)
{
    return jsonLine(reportObject(report));
}

QByteArray rehearsalJson(const RehearsalStatus& status)
{
    return jsonLine({{QStringLiteral("progress"), status.progress ? QJsonValue(*status.progress) : QJsonValue()},
                     {QStringLiteral("problem"), status.problem},
                     {QStringLiteral("night"), status.night ? QJsonValue(nightObject(*status.night)) : QJsonValue()}});
}

QJsonObject momentObject(const schedule::PassMoment& moment, const QString& mount, bool simulated)
{
    const QJsonObject pass = moment.pass ? passObject(*moment.pass) : QJsonObject();
    const auto ofPass = [&pass](const char* key) {
        const QJsonValue value = pass.value(QLatin1String(key));
        return value.isUndefined() ? QJsonValue() : value;
    };
    QJsonObject all{{QStringLiteral("event"), momentWord(moment.moment)},
                    {QStringLiteral("utc"), utcSecondText(moment.utc)},
                    {QStringLiteral("mount"), mount},
                    {QStringLiteral("simulated"), simulated},
                    {QStringLiteral("satellite"), ofPass("name")},
                    {QStringLiteral("end"),
                     moment.moment == schedule::Moment::Los ? QJsonValue(endWord(moment.end)) : QJsonValue()},
                    {QStringLiteral("why"), moment.why.isEmpty() ? QJsonValue() : QJsonValue(moment.why)}};
    for (const char* const key : {"norad", "priority", "aos_utc", "los_utc", "max_el"}) {
        all.insert(QLatin1String(key), ofPass(key));
    }
    return all;
}

}  // namespace boresight
