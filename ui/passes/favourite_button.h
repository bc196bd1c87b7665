// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/elements/satellite_mark.h"
#include "ui/kit/command_button.h"

#include <optional>

// Makes a satellite a favourite of the profile, or removes it from the favourites. Gui thread.
namespace boresight::ui {

class ProfileDraft;

class FavouriteButton : public CommandButton
{
    Q_OBJECT

public:
    FavouriteButton(ProfileDraft& draft, RequestDesk& desk, ValueLabel& notice, QWidget* parent = nullptr);

    // Empty: no satellite is selected.
    void show(const std::optional<int>& satellite, const orbit::SatelliteMarks& marks);
    void toggle(int satellite);  // works for any satellite, not only the selected one

private:
    ProfileDraft& m_draft;
    std::optional<int> m_satellite;
};

}  // namespace boresight::ui
