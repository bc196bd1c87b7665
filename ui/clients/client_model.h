// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/messages/station_status.h"
#include "ui/kit/table_model.h"

#include <optional>
#include <vector>

// The connections of the rotctld server as a table, in the order of their arrival. The permission of a client is a
// word, and anything that needs attention has a symbol.
namespace boresight::ui {

class ClientModel : public TableModel
{
    Q_OBJECT

public:
    enum Column
    {
        Address,
        Program,
        Rate,
        LastCommand,
        Role
    };

    explicit ClientModel(QObject* parent = nullptr);

    void show(const std::vector<ClientStatus>& clients);

    [[nodiscard]] const ClientStatus& client(int row) const { return m_clients.at(static_cast<std::size_t>(row)); }
    [[nodiscard]] std::optional<int> rowOf(std::uint64_t id) const;

    [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;

protected:
    [[nodiscard]] std::size_t rows() const override { return m_clients.size(); }

private:
    std::vector<ClientStatus> m_clients;
};

[[nodiscard]] QString roleWord(const ClientStatus& client);
// How many odd commands the client sent, and what an odd command is. Empty if it sent none.
[[nodiscard]] QString oddHelp(const ClientStatus& client);
[[nodiscard]] QStringList roleWords();  // all possible words

}  // namespace boresight::ui
