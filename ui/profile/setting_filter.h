// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QSortFilterProxyModel>

// The lines of a SettingTree that contain all words of a search, or only those that are changed, waiting or wrong, with
// their groups. The title of a group finds the whole group.
namespace boresight::ui {

class SettingFilter : public QSortFilterProxyModel
{
    Q_OBJECT

public:
    explicit SettingFilter(QObject* parent = nullptr);

    void setText(const QString& text);
    void setChangedOnly(bool on);
    [[nodiscard]] bool isSelective() const { return m_changedOnly || !m_words.isEmpty(); }

protected:
    [[nodiscard]] bool filterAcceptsRow(int row, const QModelIndex& parent) const override;

private:
    QStringList m_words;
    bool m_changedOnly = false;
};

}  // namespace boresight::ui
