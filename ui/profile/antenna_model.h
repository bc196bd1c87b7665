// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/link/draft_table_model.h"

// The antennas of the draft as a table. The first row is the main antenna. Only its beam width, that of the mount, can
// be edited: the offsets of the other antennas are relative to it. Gui thread.
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

// Adds an antenna at the end, with a unique name, the beam width of the main one and no offsets.
void addAntenna(profile::Profile& profile);
// The satellites of this antenna then use the antenna that is chosen by hand. Returns their number.
std::size_t removeAntenna(profile::Profile& profile, std::size_t index);

}  // namespace boresight::ui
