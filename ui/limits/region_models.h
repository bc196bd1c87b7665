// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/link/draft_table_model.h"

// The two lists of the region as tables, with a column for each setting of a row.
namespace boresight::ui {

class HorizonModel : public DraftTableModel
{
    Q_OBJECT

public:
    HorizonModel(ProfileDraft& draft, QObject* parent);

protected:
    [[nodiscard]] std::size_t rowsOfDraft() const override;
    [[nodiscard]] QString text(int row, int column) const override;
    [[nodiscard]] Result<> put(profile::Profile& profile, int row, int column, const QString& text) const override;
    [[nodiscard]] std::string key(int row) const override;
};

class KeepOutModel : public DraftTableModel
{
    Q_OBJECT

public:
    KeepOutModel(ProfileDraft& draft, QObject* parent);

protected:
    [[nodiscard]] std::size_t rowsOfDraft() const override;
    [[nodiscard]] QString text(int row, int column) const override;
    [[nodiscard]] Result<> put(profile::Profile& profile, int row, int column, const QString& text) const override;
    [[nodiscard]] std::string key(int row) const override;
};

}  // namespace boresight::ui
