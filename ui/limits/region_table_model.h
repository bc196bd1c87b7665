// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"
#include "ui/kit/table_model.h"
#include "ui/link/profile_draft.h"

// A list of the region in the draft as a table that is edited cell by cell. A text that is no value is refused with the
// reason and changes nothing; what the live check finds stands in the tooltip of its row. The rows are those of the
// draft, whoever changes it.
namespace boresight::ui {

class RegionTableModel : public TableModel
{
    Q_OBJECT

public:
    RegionTableModel(ProfileDraft& draft, const QStringList& headings, QObject* parent);

    [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
    [[nodiscard]] Qt::ItemFlags flags(const QModelIndex& index) const override;
    bool setData(const QModelIndex& index, const QVariant& value, int role) override;

Q_SIGNALS:
    void refused(const QString& reason);  // empty: the last text was taken

protected:
    [[nodiscard]] const pointing::Region& region() const { return m_draft.edited().limits; }
    [[nodiscard]] std::size_t rows() const override { return m_rows; }
    [[nodiscard]] virtual std::size_t rowsOfDraft() const = 0;
    [[nodiscard]] virtual QString text(int row, int column) const = 0;
    [[nodiscard]] virtual Result<> put(pointing::Region& region, int row, int column, const QString& text) const = 0;
    [[nodiscard]] virtual std::string key(int row) const = 0;  // as the live check names it

private:
    void followDraft();

    ProfileDraft& m_draft;
    std::size_t m_rows = 0;
};

}  // namespace boresight::ui
