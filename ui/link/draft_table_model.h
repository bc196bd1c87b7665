// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"
#include "core/profile/setting.h"
#include "ui/kit/table_model.h"
#include "ui/link/profile_draft.h"

// A list of the draft as a table that is edited cell by cell. An invalid text is refused with the reason and changes
// nothing. Problems found by the live check are in the tooltip of their row. The rows follow the draft, whatever
// changes it.
namespace boresight::ui {

class DraftTableModel : public TableModel
{
    Q_OBJECT

public:
    DraftTableModel(ProfileDraft& draft, const QStringList& headings, QObject* parent);

    [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
    [[nodiscard]] Qt::ItemFlags flags(const QModelIndex& index) const override;
    bool setData(const QModelIndex& index, const QVariant& value, int role) override;

Q_SIGNALS:
    void refused(const QString& reason);  // empty: the last text was accepted

protected:
    [[nodiscard]] const profile::Profile& edited() const { return m_draft.edited(); }
    [[nodiscard]] std::size_t rows() const override { return m_rows; }
    [[nodiscard]] virtual std::size_t rowsOfDraft() const = 0;
    [[nodiscard]] virtual QString text(int row, int column) const = 0;
    [[nodiscard]] virtual Result<> put(profile::Profile& profile, int row, int column, const QString& text) const = 0;
    [[nodiscard]] virtual std::string key(int row) const = 0;  // the key in the live check

private:
    void followDraft();

    ProfileDraft& m_draft;
    std::size_t m_rows = 0;
};

// The contents of the cells of such a table, a column for each setting of a row.
[[nodiscard]] QString cellText(const profile::SettingValue& value);
// The number in a cell. Degrees may be written with the degree sign, as in tables of other programs.
[[nodiscard]] Result<double> numberOfCell(QString text);
[[nodiscard]] std::string rowKey(std::string_view list, int row);

template <class Row>
[[nodiscard]] QString cellText(std::span<const profile::SettingOf<Row>> columns, const Row& row, int column)
{
    return cellText(columns[static_cast<std::size_t>(column)].get(row));
}

template <class Row>
[[nodiscard]] Result<> putCell(std::span<const profile::SettingOf<Row>> columns, Row& row, int column,
                               const QString& text)
{
    const profile::SettingOf<Row>& setting = columns[static_cast<std::size_t>(column)];
    if (setting.type == profile::SettingType::Text) {
        return setting.set(row, text.toStdString());
    }
    return numberOfCell(text).and_then([&](double number) { return setting.set(row, number); });
}

}  // namespace boresight::ui
