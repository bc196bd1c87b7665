// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/station/calibration_status.h"

#include <QAbstractTableModel>

#include <vector>

// The terms of the pointing model as a table: what is in force, what is proposed and how well it is known, and whether
// the points support it.
namespace boresight::ui {

class TermModel : public QAbstractTableModel
{
    Q_OBJECT

public:
    enum Column
    {
        Name,
        Present,
        Proposed,
        Sigma,
        On,
        ColumnCount
    };

    using QAbstractTableModel::QAbstractTableModel;

    // Of the proposal if there is one, else of the fit, else only what is in force.
    void show(const CalibrationStatus& calibration);

    [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
    [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

private:
    struct Row
    {
        QString name;
        Angle present;
        std::optional<Angle> proposed;
        std::optional<Angle> sigma;
        bool isOn = false;

        bool operator==(const Row&) const = default;
    };

    [[nodiscard]] static std::vector<Row> rowsOf(const CalibrationStatus& calibration);
    [[nodiscard]] static QString cell(const Row& row, int column);

    std::vector<Row> m_rows;
};

}  // namespace boresight::ui
