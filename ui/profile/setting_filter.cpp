// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/profile/setting_filter.h"

#include "ui/profile/setting_tree.h"

#include <algorithm>

namespace boresight::ui {

SettingFilter::SettingFilter(QObject* parent) : QSortFilterProxyModel(parent)
{
    setRecursiveFilteringEnabled(true);
}

void SettingFilter::setText(const QString& text)
{
    m_words = text.split(QLatin1Char(' '), Qt::SkipEmptyParts);
    invalidateFilter();
}

void SettingFilter::setChangedOnly(bool on)
{
    m_changedOnly = on;
    invalidateFilter();
}

bool SettingFilter::filterAcceptsRow(int row, const QModelIndex& parent) const
{
    if (!parent.isValid()) {
        return !isSelective();  // otherwise a group is shown only for its lines
    }
    const QModelIndex line = sourceModel()->index(row, 0, parent);
    const QString sought = line.data(SettingTree::SearchRole).toString() + QLatin1Char(' ') +
                           parent.data(SettingTree::SearchRole).toString();
    const bool hasWords = std::all_of(m_words.begin(), m_words.end(), [&sought](const QString& word) {
        return sought.contains(word, Qt::CaseInsensitive);
    });
    return hasWords && (!m_changedOnly || line.data(SettingTree::ChangedRole).toBool());
}

}  // namespace boresight::ui

#include "moc_setting_filter.cpp"
