// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/protection_model.h"

#include "ui/axes.h"
#include "ui/drives_permission.h"
#include "ui/symbol.h"

#include <QCoreApplication>
#include <QIcon>
#include <QPainter>
#include <QPixmap>

#include <algorithm>

namespace boresight::ui {

namespace {

using survey::ProtectionLine;

struct Label
{
    const char* key;
    const char* text;
};

// What the drives' settings are called by people; the keys are those of the moteus firmware.
constexpr Label kLabels[] = {
    {"id.id", QT_TRANSLATE_NOOP("ProtectionModel", "Bus address")},
    {"servopos.position_min", QT_TRANSLATE_NOOP("ProtectionModel", "Lowest position")},
    {"servopos.position_max", QT_TRANSLATE_NOOP("ProtectionModel", "Highest position")},
    {"servo.default_timeout_s", QT_TRANSLATE_NOOP("ProtectionModel", "Watchdog time")},
    {"servo.timeout_mode", QT_TRANSLATE_NOOP("ProtectionModel", "When not fed")},
    {"servo.timeout_max_torque_Nm", QT_TRANSLATE_NOOP("ProtectionModel", "Torque not fed")},
    {"servo.max_current_A", QT_TRANSLATE_NOOP("ProtectionModel", "Max. current")},
    {"servo.max_power_W", QT_TRANSLATE_NOOP("ProtectionModel", "Max. power")},
    {"servo.max_voltage", QT_TRANSLATE_NOOP("ProtectionModel", "Max. supply")},
    {"servo.max_velocity", QT_TRANSLATE_NOOP("ProtectionModel", "Max. speed")},
    {"servo.default_velocity_limit", QT_TRANSLATE_NOOP("ProtectionModel", "Speed limit")},
    {"servo.default_accel_limit", QT_TRANSLATE_NOOP("ProtectionModel", "Accel. limit")},
    {"servo.fault_position_error", QT_TRANSLATE_NOOP("ProtectionModel", "Following error")},
    {"servo.max_position_slip", QT_TRANSLATE_NOOP("ProtectionModel", "Position slip")},
    {"motor_position.rotor_to_output_ratio", QT_TRANSLATE_NOOP("ProtectionModel", "Gear ratio")},
};

QString labelOf(const QString& key)
{
    const auto* const label = std::find_if(std::begin(kLabels), std::end(kLabels),
                                           [&key](const Label& one) { return key == QLatin1String(one.key); });
    return label == std::end(kLabels) ? key : ProtectionModel::tr(label->text);
}

struct Shown
{
    QString word;
    Tone tone = Tone::Normal;
    Symbol symbol = Symbol::None;
};

Shown shown(survey::Verdict verdict)
{
    switch (verdict) {
        case survey::Verdict::Right:
            return {ProtectionModel::tr("right")};
        case survey::Verdict::Advised:
            return {ProtectionModel::tr("advised"), Tone::Advisory, Symbol::Advisory};
        case survey::Verdict::Dangerous:
            return {ProtectionModel::tr("dangerous"), Tone::Alarm, Symbol::Alarm};
        case survey::Verdict::Unread:
            break;
    }
    return {ProtectionModel::tr("unread"), Tone::Secondary};
}

// A setting that is not read yet may be anything: it weighs more than one that is right.
survey::Verdict worse(survey::Verdict a, survey::Verdict b)
{
    const auto weight = [](survey::Verdict verdict) {
        return verdict == survey::Verdict::Right ? -1 : static_cast<int>(verdict);
    };
    return weight(a) > weight(b) ? a : b;
}

QPixmap picture(Symbol symbol, const QColor& colour)
{
    constexpr int kSize = 12;    // px
    constexpr int kDensity = 2;  // sharp at 200 %
    QPixmap pixmap(kSize * kDensity, kSize * kDensity);
    pixmap.setDevicePixelRatio(kDensity);
    pixmap.fill(Qt::transparent);
    QPainter painter(&pixmap);
    drawSymbol(painter, symbol, QRectF(1, 1, kSize - 2, kSize - 2), colour);
    return pixmap;
}

QVariant decoration(const Shown& shown)
{
    if (shown.symbol == Symbol::None) {
        return {};
    }
    QIcon icon(picture(shown.symbol, currentTheme().colour(shown.tone)));
    icon.addPixmap(picture(shown.symbol, currentTheme().plotGround), QIcon::Selected);
    return icon;
}

}  // namespace

void ProtectionModel::show(const DrivesStatus& drives)
{
    if (m_lines[0] == drives.azimuth.protections && m_lines[1] == drives.elevation.protections) {
        return;
    }
    m_lines = {drives.azimuth.protections, drives.elevation.protections};
    std::vector<Row> rows = arranged();
    if (rows.size() == m_rows.size()) {  // values come one by one while the drives are read: the selection stays
        m_rows = std::move(rows);
        Q_EMIT dataChanged(index(0, 0), index(rowCount() - 1, ColumnCount - 1));
    } else {
        beginResetModel();
        m_rows = std::move(rows);
        endResetModel();
    }
}

std::vector<ProtectionModel::Row> ProtectionModel::arranged() const
{
    std::vector<Row> rows;
    for (const Axis axis : kAxes) {
        for (const ProtectionLine& line : m_lines[axisIndex(axis)]) {
            rowFor(axis, line, rows).found[axisIndex(axis)] = line;
        }
    }
    for (Row& row : rows) {
        row.label = labelOf(row.key);
        for (const Axis axis : kAxes) {
            const bool alone = !row.found[1 - axisIndex(axis)];
            row.label += alone ? QLatin1Char(' ') + shortName(axis) : QString();
        }
    }
    return rows;
}

// The axes share a row where they want the same; else the second stands below the first.
ProtectionModel::Row& ProtectionModel::rowFor(Axis axis, const ProtectionLine& line, std::vector<Row>& rows)
{
    const auto sameKey = [&line](const Row& row) { return row.key == line.key; };
    const auto same = std::find_if(rows.begin(), rows.end(), [&](const Row& row) {
        return sameKey(row) && row.wanted == line.wanted && !row.found[axisIndex(axis)];
    });
    if (same != rows.end()) {
        return *same;
    }
    const auto first = std::find_if(rows.begin(), rows.end(), sameKey);
    return *rows.insert(first == rows.end() ? first : std::next(first),
                        Row{.label = {}, .key = line.key, .wanted = line.wanted, .found = {}});
}

int ProtectionModel::count(survey::Verdict verdict) const
{
    std::ptrdiff_t count = 0;
    for (const auto& lines : m_lines) {
        count += std::count_if(lines.begin(), lines.end(),
                               [verdict](const ProtectionLine& line) { return line.verdict == verdict; });
    }
    return static_cast<int>(count);
}

QString ProtectionModel::reason(int row) const
{
    const auto& found = m_rows[static_cast<std::size_t>(row)].found;
    if (!found[0] || !found[1] || found[0]->reason == found[1]->reason) {
        return found[0] ? found[0]->reason : found[1]->reason;
    }
    QStringList reasons;
    for (const Axis axis : kAxes) {
        if (const QString& text = found[axisIndex(axis)]->reason; !text.isEmpty()) {
            reasons << tr("%1: %2").arg(shortName(axis), text);
        }
    }
    return reasons.join(QLatin1Char('\n'));
}

QString ProtectionModel::changes() const
{
    QStringList lines;
    for (const Axis axis : kAxes) {
        for (const ProtectionLine& line : m_lines[axisIndex(axis)]) {
            if (differs(line)) {
                lines << tr("%1  %2: %3 → %4").arg(shortName(axis), line.key, line.found, line.wanted);
            }
        }
    }
    return lines.join(QLatin1Char('\n'));
}

int ProtectionModel::rowCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : static_cast<int>(m_rows.size());
}

int ProtectionModel::columnCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : ColumnCount;
}

QString ProtectionModel::text(const Row& row, int column) const
{
    switch (column) {
        case Setting:
            return row.label;
        case Wanted:
            return row.wanted;
        case FoundAzimuth:
            return row.found[0] ? row.found[0]->found : QString();
        case FoundElevation:
            return row.found[1] ? row.found[1]->found : QString();
        default:
            return {};
    }
}

// The verdict a cell shows, if it shows one.
std::optional<survey::Verdict> ProtectionModel::verdictIn(const Row& row, int column) const
{
    const auto& [azimuth, elevation] = row.found;
    const auto of = [](const auto& line) { return line ? std::optional(line->verdict) : std::nullopt; };
    switch (column) {
        case FoundAzimuth:
            return of(azimuth);
        case FoundElevation:
            return of(elevation);
        case Verdict:
            return azimuth && elevation ? worse(azimuth->verdict, elevation->verdict)
                                        : of(azimuth ? azimuth : elevation);
        default:
            return std::nullopt;
    }
}

QVariant ProtectionModel::data(const QModelIndex& index, int role) const
{
    if (!index.isValid()) {
        return {};
    }
    const Row& row = m_rows[static_cast<std::size_t>(index.row())];
    const auto verdict = verdictIn(row, index.column());
    const Shown look = verdict ? shown(*verdict) : Shown{};
    switch (role) {
        case Qt::DisplayRole:
            return index.column() == Verdict ? look.word : text(row, index.column());
        case Qt::DecorationRole:
            return decoration(look);
        case Qt::ForegroundRole:
            return currentTheme().colour(look.tone);
        case Qt::ToolTipRole:
            return index.column() == Setting ? row.key : QVariant(data(index, Qt::DisplayRole));
        default:
            return {};
    }
}

QVariant ProtectionModel::headerData(int section, Qt::Orientation orientation, int role) const
{
    if (orientation != Qt::Horizontal || role != Qt::DisplayRole) {
        return {};
    }
    switch (section) {
        case Setting:
            return tr("Setting");
        case Wanted:
            return tr("Wanted");
        case FoundAzimuth:
            return tr("Found AZ");
        case FoundElevation:
            return tr("Found EL");
        default:
            return tr("Verdict");
    }
}

}  // namespace boresight::ui
