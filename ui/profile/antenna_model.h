// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/link/draft_table_model.h"

// The antennas of the draft as a table. The first row is the main antenna. Only its beam width is to be edited, which
// is the one of the mount: the other antennas are measured from it. Gui thread.
namespace boresight::ui {

class AntennaModel : public DraftTableModel
{
    Q_OBJECT

public:
    enum Column
    {
        Name,
        BeamWidth,
        Across,
        Up
    };

    AntennaModel(ProfileDraft& draft, QObject* parent);

    [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
    [[nodiscard]] Qt::ItemFlags flags(const QModelIndex& index) const override;

protected:
    [[nodiscard]] std::size_t rowsOfDraft() const override;
    [[nodiscard]] QString text(int row, int column) const override;
    [[nodiscard]] Result<> put(profile::Profile& profile, int row, int column, const QString& text) const override;
    [[nodiscard]] std::string key(int row) const override;
};

// Behind the others, with a name of its own, as wide as the main one and without offsets.
void addAntenna(profile::Profile& profile);
// The satellites that had this one then have the antenna that is chosen by hand. Says how many these are.
std::size_t removeAntenna(profile::Profile& profile, std::size_t index);

}  // namespace boresight::ui
