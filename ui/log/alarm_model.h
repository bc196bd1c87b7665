// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/messages/station_status.h"
#include "ui/kit/table_model.h"

#include <QSortFilterProxyModel>

#include <optional>
#include <vector>

// Every alarm since the window opened: those that the station still lists, and a history of limited length of those
// that ended. An alarm is identified by its number and its beginning, because a new station counts from 1 again. Alarms
// of the window itself have no number, and are identified by their name. Gui thread.
namespace boresight::ui {

struct SeenAlarm
{
    Alarm alarm;
    std::optional<UtcTime> ended;
    std::optional<std::size_t> place;  // index in the station's list, while it is active or waits to be acknowledged
};

class AlarmModel : public TableModel
{
    Q_OBJECT

public:
    enum Column
    {
        Time,
        State,
        Acknowledged,
        What
    };

    explicit AlarmModel(QObject* parent = nullptr);

    // True if a new active alarm is worse than an advisory.
    bool take(const StationStatus& status);

    [[nodiscard]] const SeenAlarm& seen(int row) const { return m_seen[static_cast<std::size_t>(row)]; }

    [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;

protected:
    [[nodiscard]] std::size_t rows() const override { return m_seen.size(); }

private:
    [[nodiscard]] QString cell(const SeenAlarm& seen, int column) const;
    void follow(const StationStatus& status, bool newStation);
    bool add(const StationStatus& status);
    void change(std::size_t row, const SeenAlarm& now);
    void dropEldest();

    std::vector<SeenAlarm> m_seen;  // in the order of their arrival
    std::uint64_t m_tick = 0;
};

// Alarms that need attention first, in the order of the station. Then the history, the newest first.
class AlarmOrder : public QSortFilterProxyModel
{
    Q_OBJECT

public:
    using QSortFilterProxyModel::QSortFilterProxyModel;

protected:
    [[nodiscard]] bool lessThan(const QModelIndex& left, const QModelIndex& right) const override;
};

}  // namespace boresight::ui
