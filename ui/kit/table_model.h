// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAbstractTableModel>
#include <QStringList>

// What the tables of the window have in common: a column for each of the words above them, in their order, and no row
// that lies in another.
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
    [[nodiscard]] virtual std::size_t rows() const = 0;  // that the views have been told of
    void changeCells();                                  // any may have changed
    void setHeadings(const QStringList& headings);       // the columns are others if there are more or fewer

private:
    QStringList m_headings;
};

}  // namespace boresight::ui
