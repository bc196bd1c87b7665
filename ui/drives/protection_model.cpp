// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/drives/protection_model.h"

#include "ui/kit/axes.h"
#include "ui/kit/symbol.h"

#include <QCoreApplication>
#include <QIcon>
#include <QPainter>
#include <QPixmap>

#include <algorithm>

namespace boresight::ui {

namespace {

struct ShownLine
{
    QString word;
    Tone tone = Tone::Normal;
    Symbol symbol = Symbol::None;
};

ShownLine shown(Verdict verdict)
{
    switch (verdict) {
        case Verdict::Right:
            return {ProtectionModel::tr("OK")};
        case Verdict::Advised:
            return {ProtectionModel::tr("advised"), Tone::Advisory, Symbol::Advisory};
        case Verdict::Dangerous:
            return {ProtectionModel::tr("unsafe"), Tone::Alarm, Symbol::Alarm};
        case Verdict::Unread:
            break;
    }
    return {ProtectionModel::tr("unread"), Tone::Secondary};
}

// A setting that is not read yet may have any value, so it is more important than one that is right.
int weight(Verdict verdict)
{
    return verdict == Verdict::Right ? -1 : static_cast<int>(verdict);
}

Verdict worse(Verdict a, Verdict b)
{
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

QVariant decoration(const ShownLine& shown)
{
    if (shown.symbol == Symbol::None) {
        return {};
    }
    QIcon icon(picture(shown.symbol, currentTheme().colour(shown.tone)));
    icon.addPixmap(picture(shown.symbol, currentTheme().plotGround), QIcon::Selected);
    return icon;
}

}  // namespace

ProtectionModel::ProtectionModel(QObject* parent)
    : TableModel({tr("Setting"), tr("Wanted"), tr("Found AZ"), tr("Found EL"), tr("Result")}, parent)
{}

void ProtectionModel::show(const DrivesStatus& drives)
{
    if (m_lines[0] == drives.azimuth.protections && m_lines[1] == drives.elevation.protections) {
        return;
    }
    m_lines = {drives.azimuth.protections, drives.elevation.protections};
    std::vector<Row> rows = arranged();
    if (rows.size() == m_rows.size()) {
        reorder(std::move(rows));
    } else {
        beginResetModel();
        m_rows = std::move(rows);
        endResetModel();
    }
}

// Values arrive one by one while the drives are read, and the lines change their places. The selection follows its
// line.
void ProtectionModel::reorder(std::vector<Row> rows)
{
    Q_EMIT layoutAboutToBeChanged();
    const QModelIndexList before = persistentIndexList();
    QModelIndexList after;
    for (const QModelIndex& old : before) {
        const Row& wanted = m_rows[static_cast<std::size_t>(old.row())];
        const auto found = std::find_if(rows.begin(), rows.end(), [&wanted](const Row& row) {
            return row.key == wanted.key && row.wanted == wanted.wanted;
        });
        after << (found == rows.end() ? QModelIndex() : index(static_cast<int>(found - rows.begin()), old.column()));
    }
    m_rows = std::move(rows);
    changePersistentIndexList(before, after);
    Q_EMIT layoutChanged();
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
        for (const Axis axis : kAxes) {
            const bool alone = !row.found[1 - axisIndex(axis)];
            row.label += alone ? QLatin1Char(' ') + shortName(axis) : QString();
        }
    }
    // Settings to be corrected are above those that are right.
    std::stable_sort(rows.begin(), rows.end(),
                     [](const Row& a, const Row& b) { return weight(verdictOf(a)) > weight(verdictOf(b)); });
    return rows;
}

// The axes share a row if they want the same value. Otherwise the second axis is below the first.
ProtectionModel::Row& ProtectionModel::rowFor(Axis axis, const ProtectionLine& line, std::vector<Row>& rows)
{
    const QString& label = line.name;
    const auto sameLabel = [&label](const Row& row) { return row.label == label; };
    const auto same = std::find_if(rows.begin(), rows.end(), [&](const Row& row) {
        return sameLabel(row) && row.key == line.key && row.wanted == line.wanted && !row.found[axisIndex(axis)];
    });
    if (same != rows.end()) {
        return *same;
    }
    const auto first = std::find_if(rows.begin(), rows.end(), sameLabel);
    return *rows.insert(
        first == rows.end() ? first : std::next(first),
        Row{.label = label, .key = line.key, .wanted = line.wanted, .wantedBrief = line.wantedBrief, .found = {}});
}

int ProtectionModel::count(boresight::Verdict verdict) const
{
    std::ptrdiff_t count = 0;
    for (const auto& lines : m_lines) {
        count += std::count_if(lines.begin(), lines.end(),
                               [verdict](const ProtectionLine& line) { return line.verdict == verdict; });
    }
    return static_cast<int>(count);
}

QString ProtectionModel::explanation(int row) const
{
    const Row& one = m_rows[static_cast<std::size_t>(row)];
    QStringList found;
    QStringList reasons;
    for (const Axis axis : kAxes) {
        if (const auto& line = one.found[axisIndex(axis)]) {
            found << shortName(axis) + QLatin1Char(' ') + (line->found.isEmpty() ? tr("unread") : line->foundBrief);
            reasons << line->reason;
        }
    }
    reasons.removeDuplicates();
    return tr("%1: wanted %2, found %3.\n%4")
        .arg(one.label, one.wantedBrief, found.join(QStringLiteral(", ")), reasons.join(QStringLiteral(" / ")));
}

QStringList ProtectionModel::changes() const
{
    QStringList lines;
    for (const Axis axis : kAxes) {
        for (const ProtectionLine& line : m_lines[axisIndex(axis)]) {
            if (!line.fix.isEmpty()) {
                lines << tr("%1  %2: %3 → %4").arg(shortName(axis), line.name, line.found, line.fix);
            }
        }
    }
    return lines;
}

QStringList ProtectionModel::leftAlone() const
{
    QStringList lines;
    for (const Axis axis : kAxes) {
        for (const ProtectionLine& line : m_lines[axisIndex(axis)]) {
            if (differs(line) && line.fix.isEmpty()) {
                lines << tr("%1  %2 (%3): %4, wanted %5")
                             .arg(shortName(axis), line.name, line.key, line.found, line.wanted);
            }
        }
    }
    return lines;
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

// There is room for a few characters. The complete text is in the tooltip.
QString ProtectionModel::briefText(const Row& row, int column) const
{
    switch (column) {
        case Wanted:
            return row.wantedBrief;
        case FoundAzimuth:
            return row.found[0] ? row.found[0]->foundBrief : QString();
        case FoundElevation:
            return row.found[1] ? row.found[1]->foundBrief : QString();
        default:
            return text(row, column);
    }
}

Verdict ProtectionModel::verdictOf(const Row& row)
{
    const auto& [azimuth, elevation] = row.found;
    return azimuth && elevation ? worse(azimuth->verdict, elevation->verdict)
                                : (azimuth ? azimuth : elevation)->verdict;
}

// The verdict shown in a cell, if any.
std::optional<Verdict> ProtectionModel::verdictIn(const Row& row, int column) const
{
    const auto of = [](const auto& line) { return line ? std::optional(line->verdict) : std::nullopt; };
    switch (column) {
        case FoundAzimuth:
            return of(row.found[0]);
        case FoundElevation:
            return of(row.found[1]);
        case Verdict:
            return verdictOf(row);
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
    const ShownLine look = verdict ? shown(*verdict) : ShownLine{};
    switch (role) {
        case Qt::DisplayRole:
            return index.column() == Verdict ? look.word : briefText(row, index.column());
        case Qt::DecorationRole:
            return decoration(look);
        case Qt::ForegroundRole:
            return currentTheme().colour(look.tone);
        case Qt::ToolTipRole:
            return index.column() == Setting ? row.key : text(row, index.column());
        default:
            return {};
    }
}

}  // namespace boresight::ui

#include "moc_protection_model.cpp"
