// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/messages/station_status.h"
#include "ui/kit/table_model.h"

#include <vector>

// The readings of both drives: a row for each quantity with its unit, a column for each axis and for each board that is
// only watched. Old numbers are dimmed, and disappear when there is no data. The age of the reply and the lost replies
// are always shown.
namespace boresight::ui {

class ReadingsModel : public TableModel
{
    Q_OBJECT

public:
    enum Column
    {
        Quantity,
        Azimuth,
        Elevation,
        FirstWatched
    };

    explicit ReadingsModel(QObject* parent = nullptr);

    void show(const StationStatus& status);

    // As shown, with the time of the status.
    [[nodiscard]] QString tabbed() const;
    // The same for programs: quantity and unit in separate columns, an empty field for a value that is not reported,
    // and the ids of the boards.
    [[nodiscard]] QString csv() const;

    [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;

protected:
    [[nodiscard]] std::size_t rows() const override;

private:
    [[nodiscard]] QString shown(int row, int column) const;
    [[nodiscard]] const DriveReadings& reported(int column) const;
    [[nodiscard]] QColor colour(const QModelIndex& index) const;

    StationStatus m_status;
    QStringList m_names;                // of the columns with values
    std::vector<QStringList> m_values;  // of these, in the order of the rows; empty: not reported
};

}  // namespace boresight::ui
