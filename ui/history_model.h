// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/station/calibration_status.h"

#include <QAbstractTableModel>

#include <vector>

// What was applied to this mount, newest first: what of it is in force has a shape, and so has what was found with
// another drive or elsewhere.
namespace boresight::ui {

class HistoryModel : public QAbstractTableModel
{
    Q_OBJECT

public:
    enum Column
    {
        When,
        Title,
        Place,
        ColumnCount
    };

    using QAbstractTableModel::QAbstractTableModel;

    void show(const std::vector<CalibrationHistoryEntry>& entries);

    [[nodiscard]] const CalibrationHistoryEntry& entry(int row) const
    {
        return m_entries.at(static_cast<std::size_t>(row));
    }

    [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
    [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

private:
    std::vector<CalibrationHistoryEntry> m_entries;
};

}  // namespace boresight::ui
