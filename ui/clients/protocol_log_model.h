// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/messages/protocol_line.h"
#include "ui/kit/table_model.h"

#include <QSortFilterProxyModel>

#include <cstdint>
#include <deque>

// The protocol log as a table of limited length, oldest line first, and the filter for it. The text of a line is made
// when it is shown. Gui thread.
namespace boresight::ui {

class ProtocolLogModel : public TableModel
{
    Q_OBJECT

public:
    static constexpr std::size_t kMostLines = 2000;

    enum Column
    {
        Time,
        Client,
        Line,
        Understood,
        Answer
    };

    explicit ProtocolLogModel(QObject* parent = nullptr);

    // Lines of a new station, which counts from 1 again, replace all lines.
    void append(const std::vector<ProtocolLine>& lines);
    [[nodiscard]] const ProtocolLine& line(int row) const { return m_lines[static_cast<std::size_t>(row)]; }
    // The lines that were logged before the first one here.
    [[nodiscard]] std::uint64_t dropped() const { return m_lines.empty() ? 0 : m_last - m_lines.size(); }

    [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;

protected:
    [[nodiscard]] std::size_t rows() const override { return m_lines.size(); }

private:
    void replace(const std::vector<ProtocolLine>& lines);
    void dropEldest();

    std::deque<ProtocolLine> m_lines;
    std::uint64_t m_last = 0;  // the number of the newest line
};

class ProtocolLogFilter : public QSortFilterProxyModel
{
    Q_OBJECT

public:
    using QSortFilterProxyModel::QSortFilterProxyModel;

    void setClient(std::uint64_t id);  // shows only its lines; 0: of all clients

protected:
    [[nodiscard]] bool filterAcceptsRow(int row, const QModelIndex& parent) const override;

private:
    std::uint64_t m_client = 0;
};

// A client by its port: "rotctld :51234".
[[nodiscard]] QString shortClient(const QString& client);

}  // namespace boresight::ui
