// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/station/calibration_status.h"

#include <QAbstractTableModel>

#include <vector>

// The calibration points as a table, with what the model in force and the fit leave of each. On the sky, in degrees.
namespace boresight::ui {

class PointModel : public QAbstractTableModel
{
    Q_OBJECT

public:
    enum Column
    {
        Label,
        Time,
        Before,
        After,
        LeftOut,
        ColumnCount
    };

    using QAbstractTableModel::QAbstractTableModel;

    void show(const std::vector<PointStatus>& points);

    [[nodiscard]] const PointStatus& point(int row) const { return m_points.at(static_cast<std::size_t>(row)); }

    [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
    [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

private:
    std::vector<PointStatus> m_points;
};

}  // namespace boresight::ui
