// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/messages/rehearsal_status.h"
#include "core/messages/schedule_status.h"
#include "ui/kit/table_model.h"

#include <memory>
#include <vector>

// The night as a table in the order of time: past passes with their result, the tracked pass, coming passes with the
// result of the rehearsal, omitted passes with the reason, and the warnings of the rehearsal. Gui thread.
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

    // `rehearsed` is null without a rehearsal.
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
        QString details;  // empty: `what` is complete

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
