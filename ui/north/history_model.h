// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/messages/calibration_status.h"
#include "ui/kit/table_model.h"

#include <vector>

// The calibrations applied to this mount, newest first. The one in effect has a symbol, and so have those found with
// another drive or at another site.
namespace boresight::ui {

class HistoryModel : public TableModel
{
    Q_OBJECT

public:
    enum Column
    {
        When,
        Title,
        Place
    };

    explicit HistoryModel(QObject* parent = nullptr);

    void show(const std::vector<CalibrationHistoryEntry>& entries);

    [[nodiscard]] const CalibrationHistoryEntry& entry(int row) const
    {
        return m_entries.at(static_cast<std::size_t>(row));
    }

    [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;

protected:
    [[nodiscard]] std::size_t rows() const override { return m_entries.size(); }

private:
    std::vector<CalibrationHistoryEntry> m_entries;
};

}  // namespace boresight::ui
