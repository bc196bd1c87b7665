// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/schedule/watch_entry.h"
#include "ui/kit/command_button.h"

#include <cstdint>
#include <optional>
#include <vector>

// Adds a satellite to the watch list of the profile, or removes it. Gui thread.
namespace boresight::ui {

class ProfileDraft;

class WatchButton : public CommandButton
{
    Q_OBJECT

public:
    WatchButton(ProfileDraft& draft, RequestDesk& desk, ValueLabel& notice, QWidget* parent = nullptr);

    // Empty: no satellite is selected.
    void show(const std::optional<std::int64_t>& satellite, const std::vector<schedule::WatchEntry>& watched);

private:
    void watchOrNot();

    ProfileDraft& m_draft;
    std::optional<int> m_satellite;
};

}  // namespace boresight::ui
