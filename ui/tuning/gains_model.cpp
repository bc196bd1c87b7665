// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tuning/gains_model.h"

#include "ui/tuning/tuning_words.h"

#include <QFont>

namespace boresight::ui {

namespace {

QString valueText(const std::optional<double>& value)
{
    return value ? gainText(*value) : QStringLiteral("---");
}

}  // namespace

GainsModel::GainsModel(QObject* parent) : TableModel({tr("Gain"), tr("Found"), tr("Now"), tr("Range")}, parent) {}

void GainsModel::show(const DriveGains& gains)
{
    if (gains.lines == m_lines) {
        return;
    }
    if (gains.lines.size() != m_lines.size()) {
        beginResetModel();
        m_lines = gains.lines;
        endResetModel();
        return;
    }
    m_lines = gains.lines;
    changeCells();
}

QVariant GainsModel::data(const QModelIndex& index, int role) const
{
    if (!index.isValid() || static_cast<std::size_t>(index.row()) >= m_lines.size()) {
        return {};
    }
    const GainLine& line = m_lines[static_cast<std::size_t>(index.row())];
    const bool changed = line.value && line.first && !isSameGain(*line.value, *line.first);
    switch (role) {
        case Qt::DisplayRole:
            switch (index.column()) {
                case Name:
                    return gainName(static_cast<Gain>(index.row()));
                case Found:
                    return valueText(line.first);
                case Now:
                    return valueText(line.value) + (changed ? QStringLiteral(" ●") : QString());
                default:
                    return line.value ? QStringLiteral("%1…%2").arg(gainText(line.least), gainText(line.most))
                                      : QString();
            }
        case Qt::ToolTipRole:
            return QStringLiteral("%1, %2\n%3").arg(line.key, line.unit, line.bounds);
        case Qt::TextAlignmentRole:
            return index.column() == Name ? QVariant() : QVariant(Qt::AlignRight | Qt::AlignVCenter);
        default:
            return {};
    }
}

}  // namespace boresight::ui

#include "moc_gains_model.cpp"
