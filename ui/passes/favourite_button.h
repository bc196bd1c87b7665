// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/elements/satellite_mark.h"
#include "ui/kit/command_button.h"

#include <optional>

// Makes a satellite a favourite of the profile, or takes its star away. Gui thread.
namespace boresight::ui {

class ProfileDraft;

class FavouriteButton : public CommandButton
{
    Q_OBJECT

public:
    FavouriteButton(ProfileDraft& draft, RequestDesk& desk, ValueLabel& notice, QWidget* parent = nullptr);

    // Empty: none is selected.
    void show(const std::optional<int>& satellite, const orbit::SatelliteMarks& marks);
    void toggle(int satellite);  // any, as if it were selected and the button pressed

private:
    ProfileDraft& m_draft;
    std::optional<int> m_satellite;
};

}  // namespace boresight::ui
