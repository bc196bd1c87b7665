// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/messages/drive_gains.h"
#include "ui/kit/table_model.h"

#include <vector>

// The gains of one drive: the value first found, the value in effect, and the permitted range.
namespace boresight::ui {

class GainsModel : public TableModel
{
    Q_OBJECT

public:
    enum Column
    {
        Name,
        Found,
        Now,
        Range
    };

    explicit GainsModel(QObject* parent = nullptr);

    void show(const DriveGains& gains);
    [[nodiscard]] const std::vector<GainLine>& lines() const { return m_lines; }

    [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;

protected:
    [[nodiscard]] std::size_t rows() const override { return m_lines.size(); }

private:
    std::vector<GainLine> m_lines;
};

}  // namespace boresight::ui
