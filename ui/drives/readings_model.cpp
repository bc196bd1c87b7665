// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/drives/readings_model.h"

#include "core/base/numbers.h"
#include "core/base/text.h"
#include "ui/kit/axes.h"
#include "ui/kit/format.h"
#include "ui/kit/theme.h"

#include <QColor>

#include <iterator>

namespace boresight::ui {

namespace {

struct ReadingRow
{
    const char* name;
    const char* unit;
};

// In the order of readingsOf().
constexpr ReadingRow kReadingRows[] = {
    {QT_TRANSLATE_NOOP("boresight::ui::ReadingsModel", "Position of the axis"), "°"},
    {QT_TRANSLATE_NOOP("boresight::ui::ReadingsModel", "Position of the drive"),
     QT_TRANSLATE_NOOP("boresight::ui::ReadingsModel", "turns")},
    {QT_TRANSLATE_NOOP("boresight::ui::ReadingsModel", "Velocity of the axis"), "°/s"},
    {QT_TRANSLATE_NOOP("boresight::ui::ReadingsModel", "Velocity of the drive"),
     QT_TRANSLATE_NOOP("boresight::ui::ReadingsModel", "turns/s")},
    {QT_TRANSLATE_NOOP("boresight::ui::ReadingsModel", "Torque"), "Nm"},
    {QT_TRANSLATE_NOOP("boresight::ui::ReadingsModel", "Current q"), "A"},
    {QT_TRANSLATE_NOOP("boresight::ui::ReadingsModel", "Current d"), "A"},
    {QT_TRANSLATE_NOOP("boresight::ui::ReadingsModel", "Electrical power"), "W"},
    {QT_TRANSLATE_NOOP("boresight::ui::ReadingsModel", "Supply voltage"), "V"},
    {QT_TRANSLATE_NOOP("boresight::ui::ReadingsModel", "Board temperature"), "°C"},
    {QT_TRANSLATE_NOOP("boresight::ui::ReadingsModel", "Motor temperature"), "°C"},
    {QT_TRANSLATE_NOOP("boresight::ui::ReadingsModel", "Mode"), ""},
    {QT_TRANSLATE_NOOP("boresight::ui::ReadingsModel", "Fault"), ""},
    {QT_TRANSLATE_NOOP("boresight::ui::ReadingsModel", "Age of the reply"), "s"},
    {QT_TRANSLATE_NOOP("boresight::ui::ReadingsModel", "Frames sent"), ""},
    {QT_TRANSLATE_NOOP("boresight::ui::ReadingsModel", "Replies lost"), ""},
};
constexpr int kAgeRow = 13;

QString figures(const std::optional<double>& value, int decimals)
{
    return value ? toQString(formatFixed(*value, decimals)) : QString();
}

// `axis` belongs to the drive. A board that is only watched has none.
QStringList textsOf(const DriveReadings& drive, const AxisStatus& axis)
{
    const auto degrees = [](const auto& angle) { return angle ? std::optional(angle->degrees()) : std::nullopt; };
    QStringList values{figures(degrees(axis.actual), 2),
                       figures(drive.motorTurns, 5),
                       figures(degrees(axis.rate), 2),
                       figures(drive.motorTurnsPerSecond, 5),
                       figures(drive.torque, 2),
                       figures(drive.qCurrent, 1),
                       figures(drive.dCurrent, 1),
                       figures(drive.power, 1),
                       figures(drive.busVoltage, 1),
                       figures(drive.boardTemperature, 1),
                       figures(drive.motorTemperature, 1),
                       drive.mode,
                       drive.fault};
    if (freshness(drive.age) == Freshness::NoData) {
        values.fill(QString());
    }
    values << figures(drive.age ? std::optional(Seconds(*drive.age).count()) : std::nullopt, 2);
    const bool counted = drive.sent > 0;
    values << (counted ? QString::number(drive.sent) : QString())
           << (counted ? QString::number(drive.sent - drive.answered) : QString());
    return values;
}

QString unitOf(int row)
{
    const char* const unit = kReadingRows[row].unit;
    return *unit == '\0' ? QString() : ReadingsModel::tr(unit);
}

QString nameOf(int row)
{
    return ReadingsModel::tr(kReadingRows[row].name);
}

QString quoted(QString field)
{
    field.replace(QLatin1Char('"'), QStringLiteral("\"\""));
    return QLatin1Char('"') + field + QLatin1Char('"');
}

QString csvLine(const QStringList& fields)
{
    QStringList line;
    for (const QString& field : fields) {
        line << quoted(field);
    }
    return line.join(QLatin1Char(',')) + QLatin1Char('\n');
}

}  // namespace

ReadingsModel::ReadingsModel(QObject* parent) : TableModel({}, parent)
{
    show(m_status);
}

std::size_t ReadingsModel::rows() const
{
    return std::size(kReadingRows);
}

void ReadingsModel::show(const StationStatus& status)
{
    m_status = status;
    m_names.clear();
    m_values.clear();
    for (const Axis axis : kAxes) {
        m_names << name(axis);
        m_values.push_back(textsOf(driveOf(status, axis).readings, axisOf(status, axis)));
    }
    for (const WatchedDrive& board : drivesOf(m_status).watched) {
        m_names << board.name;
        m_values.push_back(textsOf(board.readings, {}));
    }
    setHeadings(QStringList{QString()} + m_names);
    changeCells();
}

const DriveReadings& ReadingsModel::reported(int column) const
{
    return column < FirstWatched ? driveOf(m_status, kAxes[static_cast<std::size_t>(column - Azimuth)]).readings
                                 : drivesOf(m_status).watched[static_cast<std::size_t>(column - FirstWatched)].readings;
}

QString ReadingsModel::shown(int row, int column) const
{
    if (column == Quantity) {
        const QString unit = unitOf(row);
        return unit.isEmpty() ? nameOf(row) : tr("%1 (%2)").arg(nameOf(row), unit);
    }
    const QString& value = m_values[static_cast<std::size_t>(column - Azimuth)][row];
    return value.isEmpty() ? QStringLiteral("—") : value;
}

QColor ReadingsModel::colour(const QModelIndex& index) const
{
    const Theme& theme = currentTheme();
    if (index.column() == Quantity) {
        return theme.secondary;
    }
    const auto& age = reported(index.column()).age;
    switch (freshness(age)) {
        case Freshness::Live:
            return theme.text;
        case Freshness::Late:
            return index.row() == kAgeRow ? theme.warning : theme.secondary;
        case Freshness::NoData:
            break;
    }
    return index.row() == kAgeRow && age ? theme.warning : theme.secondary;
}

QVariant ReadingsModel::data(const QModelIndex& index, int role) const
{
    if (!index.isValid()) {
        return {};
    }
    switch (role) {
        case Qt::DisplayRole:
        case Qt::ToolTipRole:
            return shown(index.row(), index.column());
        case Qt::ForegroundRole:
            return colour(index);
        case Qt::FontRole:
            return index.column() == Quantity ? fonts::label() : fonts::small();  // so that digits do not move
        case Qt::TextAlignmentRole:
            return int(Qt::AlignVCenter | (index.column() == Quantity ? Qt::AlignLeft : Qt::AlignRight));
        default:
            return {};
    }
}

QString ReadingsModel::tabbed() const
{
    QString text = (QStringList{dateText(m_status.utc)} + m_names).join(u'\t') + u'\n';
    for (int row = 0; row < rowCount(); ++row) {
        QStringList line;
        for (int column = 0; column < columnCount(); ++column) {
            line << shown(row, column);
        }
        text += line.join(u'\t') + u'\n';
    }
    return text;
}

QString ReadingsModel::csv() const
{
    const DrivesStatus& drives = drivesOf(m_status);
    const auto id = [](const DriveStatus& drive) { return drive.id > 0 ? QString::number(drive.id) : QString(); };
    QString text = csvLine(QStringList{tr("UTC"), tr("Quantity"), tr("Unit")} + m_names);
    const QString time = dateText(m_status.utc);
    QStringList ids{time, tr("Id"), QString(), id(drives.azimuth), id(drives.elevation)};
    QStringList uuids{time, tr("UUID"), QString(), drives.azimuth.identity.uuid, drives.elevation.identity.uuid};
    for (const WatchedDrive& board : drives.watched) {
        ids << QString::number(board.id);
        uuids << QString();
    }
    text += csvLine(ids) + csvLine(uuids);
    for (int row = 0; row < rowCount(); ++row) {
        QStringList line{time, nameOf(row), unitOf(row)};
        for (const QStringList& values : m_values) {
            line << values[row];
        }
        text += csvLine(line);
    }
    return text;
}

}  // namespace boresight::ui

#include "moc_readings_model.cpp"
