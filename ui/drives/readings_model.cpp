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

QStringList readingsOf(const StationStatus& status, Axis which)
{
    const DriveReadings& drive = driveOf(status, which).readings;
    const AxisStatus& axis = axisOf(status, which);
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

ReadingsModel::ReadingsModel(QObject* parent)
    : TableModel({QString(), name(Axis::Azimuth), name(Axis::Elevation)}, parent)
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
    for (const Axis axis : kAxes) {
        m_values[axisIndex(axis)] = readingsOf(status, axis);
    }
    changeCells();
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
    const auto& age = driveOf(m_status, kAxes[static_cast<std::size_t>(index.column() - Azimuth)]).readings.age;
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
            return index.column() == Quantity ? fonts::label() : fonts::small();  // digits do not dance
        case Qt::TextAlignmentRole:
            return int(Qt::AlignVCenter | (index.column() == Quantity ? Qt::AlignLeft : Qt::AlignRight));
        default:
            return {};
    }
}

QString ReadingsModel::tabbed() const
{
    QString text = QStringList{dateText(m_status.utc), name(Axis::Azimuth), name(Axis::Elevation)}.join(u'\t') + u'\n';
    for (int row = 0; row < rowCount(); ++row) {
        text += QStringList{shown(row, Quantity), shown(row, Azimuth), shown(row, Elevation)}.join(u'\t') + u'\n';
    }
    return text;
}

QString ReadingsModel::csv() const
{
    const DrivesStatus& drives = drivesOf(m_status);
    const auto id = [](const DriveStatus& drive) { return drive.id > 0 ? QString::number(drive.id) : QString(); };
    QString text = csvLine({tr("UTC"), tr("Quantity"), tr("Unit"), name(Axis::Azimuth), name(Axis::Elevation)});
    const QString time = dateText(m_status.utc);
    text += csvLine({time, tr("Id"), QString(), id(drives.azimuth), id(drives.elevation)});
    text += csvLine({time, tr("UUID"), QString(), drives.azimuth.identity.uuid, drives.elevation.identity.uuid});
    for (int row = 0; row < rowCount(); ++row) {
        text += csvLine({time, nameOf(row), unitOf(row), m_values[0][row], m_values[1][row]});
    }
    return text;
}

}  // namespace boresight::ui

#include "moc_readings_model.cpp"
