// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/passes/schedule_table.h"

#include "ui/kit/format.h"

#include <algorithm>
#include <chrono>
#include <cmath>

namespace boresight::ui {

namespace {

// A new search finds the beginning of the same pass at most this much earlier or later.
constexpr std::chrono::minutes kFoundAgain{2};

const schedule::PassRecord* recordOf(const schedule::NightReport& report, const schedule::WatchedPass& pass)
{
    const auto found = std::ranges::find_if(report.passes, [&](const schedule::PassRecord& one) {
        return one.number == pass.number && std::chrono::abs(one.aos - pass.rises()) < kFoundAgain;
    });
    return found == report.passes.end() ? nullptr : &*found;
}

// The result of the rehearsal for this pass.
QString rehearsedText(const RehearsedNight* rehearsed, const schedule::WatchedPass& pass)
{
    const schedule::PassRecord* const record = rehearsed != nullptr ? recordOf(rehearsed->report, pass) : nullptr;
    if (record == nullptr) {
        return {};
    }
    if (record->end != schedule::PassEnd::Set) {
        return ScheduleTable::tr(", rehearsed: lost, %1").arg(record->why);
    }
    const double whole = std::max(record->tracked.count(), 1.0);
    return ScheduleTable::tr(", rehearsed: %1 %").arg(std::floor(record->within3dB.count() / whole * 100.0));
}

QString rehearsedDetails(const RehearsedNight* rehearsed, const schedule::WatchedPass& pass)
{
    const schedule::PassRecord* const record = rehearsed != nullptr ? recordOf(rehearsed->report, pass) : nullptr;
    return record == nullptr ? QString()
                             : ScheduleTable::tr("Rehearsed: within 3 dB for %1 of %2 s")
                                   .arg(std::lround(record->within3dB.count()))
                                   .arg(std::lround(record->tracked.count()));
}

QString reasonText(const schedule::Conflict& conflict)
{
    const QString what = conflict.rests.empty() ? ScheduleTable::tr("left out") : ScheduleTable::tr("tracked in part");
    const QString& name = conflict.chosen.name;
    if (!conflict.overlaps) {
        return ScheduleTable::tr("%1, too close to %2").arg(what, name);
    }
    switch (conflict.reason) {
        case schedule::Reason::Priority:
            return ScheduleTable::tr("%1, %2 is more important").arg(what, name);
        case schedule::Reason::Longer:
            return ScheduleTable::tr("%1, %2 is up longer").arg(what, name);
        case schedule::Reason::Earlier:
            return ScheduleTable::tr("%1, %2 rises first").arg(what, name);
        case schedule::Reason::LowerNumber:
            break;
    }
    return ScheduleTable::tr("%1, %2 has the lower catalogue number").arg(what, name);
}

QString comingText(const schedule::WatchedPass& pass, UtcTime now)
{
    const Seconds wait = pass.begins() - now;
    const QString when = wait > Seconds(0.0) ? ScheduleTable::tr("in %1").arg(waitText(wait)) : ScheduleTable::tr("up");
    return pass.rest ? ScheduleTable::tr("%1, part of the pass").arg(when) : when;
}

QString errorText(const schedule::PassRecord& record)
{
    return record.rmsError && record.peakError ? ScheduleTable::tr("Error: %1 rms\nLargest error: %2")
                                                     .arg(angleText(*record.rmsError), angleText(*record.peakError))
           : record.tracked > Seconds(0.0) ? ScheduleTable::tr("The beam was never on target.")
                                           : ScheduleTable::tr("Nothing was measured.");
}

QString endText(const schedule::PassRecord& record)
{
    switch (record.end) {
        case schedule::PassEnd::Running:
            return ScheduleTable::tr("tracked now");
        case schedule::PassEnd::Set:
            return record.rmsError ? ScheduleTable::tr("tracked, error %1 rms").arg(angleText(*record.rmsError))
                   : record.tracked > Seconds(0.0) ? ScheduleTable::tr("lost: the beam was never on target")
                                                   : ScheduleTable::tr("nothing was measured");
        case schedule::PassEnd::Interrupted:
            return ScheduleTable::tr("interrupted: %1").arg(record.why);
        case schedule::PassEnd::Manual:
        case schedule::PassEnd::Fault:
        case schedule::PassEnd::Refused:
            break;
    }
    return ScheduleTable::tr("lost: %1").arg(record.why);
}

}  // namespace

ScheduleTable::ScheduleTable(QObject* parent)
    : TableModel({tr("Begins (UTC)"), tr("Ends"), tr("Satellite"), tr("Highest"), tr("What")}, parent)
{}

ScheduleTable::Row ScheduleTable::rowOf(const schedule::PassRecord& record)
{
    const auto seconds = [](Seconds time) { return QString::number(std::lround(time.count())); };
    return {.begins = record.aos,
            .ends = record.los,
            .satellite = record.name,
            .highest = {},
            .what = endText(record),
            .details = tr("%1\nMeasured: %2 s\nWithin 1 dB: %3 s\nWithin 3 dB: %4 s\n%5")
                           .arg(endText(record), seconds(record.tracked), seconds(record.within1dB),
                                seconds(record.within3dB), errorText(record))};
}

ScheduleTable::Row ScheduleTable::rowOf(const schedule::WatchedPass& pass, const QString& what)
{
    return {.begins = pass.begins(),
            .ends = pass.ends(),
            .satellite = pass.name,
            .highest = angleText(pass.pass.tca.direction.elevation, 0),
            .what = what,
            .details = {}};
}

ScheduleTable::Row ScheduleTable::rowOf(const RehearsedNight::Remark& remark)
{
    return {.begins = remark.utc,
            .ends = remark.utc,
            .satellite = {},
            .highest = {},
            .what = tr("rehearsed: %1").arg(remark.text),
            .details = {}};
}

std::vector<ScheduleTable::Row> ScheduleTable::rowsOf(const ScheduleStatus& schedule, const RehearsedNight* rehearsed,
                                                      UtcTime now)
{
    std::vector<Row> rows;
    for (const schedule::PassRecord& record : schedule.report.passes) {
        rows.push_back(rowOf(record));
    }
    const auto isToCome = [&](const schedule::WatchedPass& pass) {
        return pass.ends() > now && recordOf(schedule.report, pass) == nullptr;
    };
    for (const schedule::WatchedPass& pass : schedule.plan.chosen) {
        if (isToCome(pass)) {
            rows.push_back(rowOf(pass, comingText(pass, now) + rehearsedText(rehearsed, pass)));
            rows.back().details = rehearsedDetails(rehearsed, pass);
        }
    }
    for (const schedule::WatchedPass& pass : schedule.plan.hidden) {
        if (isToCome(pass)) {
            rows.push_back(rowOf(pass, tr("left out, the limits hide it")));
        }
    }
    for (const schedule::Conflict& conflict : schedule.plan.conflicts) {
        if (isToCome(conflict.leftOut)) {
            rows.push_back(rowOf(conflict.leftOut, reasonText(conflict)));
        }
    }
    if (rehearsed != nullptr) {
        for (const RehearsedNight::Remark& remark : rehearsed->remarks) {
            if (remark.utc > now) {
                rows.push_back(rowOf(remark));
            }
        }
    }
    std::ranges::stable_sort(rows, {}, &Row::begins);
    return rows;
}

// The selection and the scroll position stay while only the texts of rows change.
void ScheduleTable::show(const ScheduleStatus& schedule, const RehearsedNight* rehearsed, UtcTime now)
{
    std::vector<Row> rows = rowsOf(schedule, rehearsed, now);
    if (rows.size() != m_rows.size()) {
        beginResetModel();
        m_rows = std::move(rows);
        endResetModel();
    } else if (rows != m_rows) {
        m_rows = std::move(rows);
        changeCells();
    }
}

QVariant ScheduleTable::data(const QModelIndex& index, int role) const
{
    const Row& row = m_rows[std::size_t(index.row())];
    if (role == Qt::TextAlignmentRole && index.column() == Highest) {
        return QVariant(Qt::AlignRight | Qt::AlignVCenter);
    }
    if (role == Qt::ToolTipRole) {
        return row.details.isEmpty() ? row.what : row.details;
    }
    if (role != Qt::DisplayRole) {
        return {};
    }
    switch (index.column()) {
        case Begins:
            return clockText(row.begins);
        case Ends:
            return clockText(row.ends);
        case Satellite:
            return row.satellite;
        case Highest:
            return row.highest;
        default:
            return row.what;
    }
}

}  // namespace boresight::ui

#include "moc_schedule_table.cpp"
