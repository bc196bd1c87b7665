// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/messages/rehearsal_status.h"
#include "core/messages/schedule_status.h"
#include "ui/kit/table_model.h"

#include <memory>
#include <vector>

// The night as a table in the order of time: passes that are over and how they went, the one that is tracked, those to
// come with how they were rehearsed, those that are left out with the reason, and the warnings of the rehearsal. Gui
// thread.
namespace boresight::ui {

class ScheduleTable : public TableModel
{
    Q_OBJECT

public:
    enum Column
    {
        Begins,
        Ends,
        Satellite,
        Highest,
        What
    };

    explicit ScheduleTable(QObject* parent = nullptr);

    // Without a rehearsal: nullptr.
    void show(const ScheduleStatus& schedule, const RehearsedNight* rehearsed, UtcTime now);

    [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;

protected:
    [[nodiscard]] std::size_t rows() const override { return m_rows.size(); }

private:
    struct Row
    {
        UtcTime begins{};
        UtcTime ends{};
        QString satellite;
        QString highest;
        QString what;
        QString details;  // empty: `what` says all

        bool operator==(const Row&) const = default;
    };

    [[nodiscard]] static Row rowOf(const schedule::PassRecord& record);
    [[nodiscard]] static Row rowOf(const schedule::WatchedPass& pass, const QString& what);
    [[nodiscard]] static Row rowOf(const RehearsedNight::Remark& remark);
    [[nodiscard]] static std::vector<Row> rowsOf(const ScheduleStatus& schedule, const RehearsedNight* rehearsed,
                                                 UtcTime now);

    std::vector<Row> m_rows;
};

}  // namespace boresight::ui
