// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/station/station_status.h"

#include <QAbstractTableModel>

#include <optional>
#include <vector>

// The connections of the rotctld server as a table, in the order in which they came. What a client may do is a word,
// and what wants to be looked at has a shape.
namespace boresight::ui {

class ClientModel : public QAbstractTableModel
{
    Q_OBJECT

public:
    enum Column
    {
        Address,
        Program,
        Rate,
        LastCommand,
        Role,
        ColumnCount
    };

    using QAbstractTableModel::QAbstractTableModel;

    void show(const std::vector<ClientStatus>& clients);

    [[nodiscard]] const ClientStatus& client(int row) const { return m_clients.at(static_cast<std::size_t>(row)); }
    [[nodiscard]] std::optional<int> rowOf(std::uint64_t id) const;

    [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
    [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

private:
    std::vector<ClientStatus> m_clients;
};

[[nodiscard]] QString roleWord(const ClientStatus& client);
[[nodiscard]] QStringList roleWords();  // all there are

}  // namespace boresight::ui
