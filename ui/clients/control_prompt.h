// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/messages/station_status.h"
#include "ui/kit/press_guard.h"
#include "ui/kit/prompt_bar.h"

#include <set>

// Shown over the plot with every panel: a client keeps asking for motions while another one has control. Allow gives it
// control. Ignore applies while it stays connected.
namespace boresight::ui {

class CommandButton;
class RequestDesk;

class ControlPrompt : public PromptBar
{
    Q_OBJECT

public:
    ControlPrompt(RequestDesk& desk, QWidget* parent);

    void showStatus(const StationStatus& status);

private:
    void ignore();

    CommandButton* m_give;
    std::uint64_t m_asking = 0;  // the client in the text
    std::set<std::uint64_t> m_ignored;
    PressGuard m_guard{this};  // after the prompt has come, or names another client
};

}  // namespace boresight::ui
