// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/link/draft_table_model.h"

#include "core/base/numbers.h"
#include "ui/kit/theme.h"

#include <cmath>

namespace boresight::ui {

namespace {
constexpr int kCellDecimals = 1;  // decimals of a number, unless it has more
}

QString cellText(const profile::SettingValue& value)
{
    if (const auto* const number = std::get_if<double>(&value)) {
        const bool round = std::abs(*number * 10.0 - std::round(*number * 10.0)) < 1e-6;
        return QString::fromStdString(formatFixed(*number, round ? kCellDecimals : 3));
    }
    const auto* const text = std::get_if<std::string>(&value);
    return text != nullptr ? QString::fromStdString(*text) : QString();
}

Result<double> numberOfCell(QString text)
{
    text.remove(QStringLiteral("°"));
    const auto number = parseFinite(text.trimmed().toStdString());
    if (!number) {
        return failure(ErrorCode::InvalidInput,
                       DraftTableModel::tr("\"%1\" is not a number (decimal point, e.g. 113.5)").arg(text));
    }
    return *number;
}

std::string rowKey(std::string_view list, int row)
{
    return std::string(list) + '[' + std::to_string(row + 1) + ']';
}

DraftTableModel::DraftTableModel(ProfileDraft& draft, const QStringList& headings, QObject* parent)
    : TableModel(headings, parent), m_draft(draft)
{
    connect(&m_draft, &ProfileDraft::changed, this, &DraftTableModel::followDraft);
}

void DraftTableModel::followDraft()
{
    const std::size_t now = rowsOfDraft();
    if (now > m_rows) {
        beginInsertRows({}, rowCount(), static_cast<int>(now) - 1);
        m_rows = now;
        endInsertRows();
    } else if (now < m_rows) {
        beginRemoveRows({}, static_cast<int>(now), rowCount() - 1);
        m_rows = now;
        endRemoveRows();
    }
    changeCells();
}

Qt::ItemFlags DraftTableModel::flags(const QModelIndex& index) const
{
    return TableModel::flags(index) | Qt::ItemIsEditable;
}

QVariant DraftTableModel::data(const QModelIndex& index, int role) const
{
    if (!index.isValid() || index.row() >= rowCount()) {
        return {};
    }
    switch (role) {
        case Qt::DisplayRole:
        case Qt::EditRole:
            return text(index.row(), index.column());
        case Qt::ToolTipRole: {
            const QString problem = m_draft.problem(key(index.row()));
            return problem.isEmpty() ? text(index.row(), index.column()) : problem;  // a long name does not fit
        }
        case Qt::ForegroundRole:
            return m_draft.problem(key(index.row())).isEmpty() ? QVariant() : QBrush(currentTheme().warning);
        default:
            return {};
    }
}

bool DraftTableModel::setData(const QModelIndex& index, const QVariant& value, int role)
{
    if (role != Qt::EditRole || !index.isValid() || index.row() >= rowCount()) {
        return false;
    }
    profile::Profile edited = m_draft.edited();
    const Result<> taken = put(edited, index.row(), index.column(), value.toString().trimmed());
    Q_EMIT refused(taken ? QString() : taken.error().text);
    if (taken) {
        m_draft.edit([&edited](profile::Profile& profile) { profile = edited; });
    }
    return taken.has_value();
}

}  // namespace boresight::ui

#include "moc_draft_table_model.cpp"
