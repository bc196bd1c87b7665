// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAbstractTableModel>
#include <QStringList>

// The common part of the tables in the window: one column for each heading, in their order, and no nested rows.
namespace boresight::ui {

class TableModel : public QAbstractTableModel
{
    Q_OBJECT

public:
    explicit TableModel(const QStringList& headings, QObject* parent = nullptr);

    [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const final;
    [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const final;
    [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

protected:
    [[nodiscard]] virtual std::size_t rows() const = 0;  // the number that the views know
    void changeCells();                                  // any cell may have changed
    void setHeadings(const QStringList& headings);       // columns are added or removed to match

private:
    QStringList m_headings;
};

}  // namespace boresight::ui
