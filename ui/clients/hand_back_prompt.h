// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/messages/station_status.h"
#include "ui/kit/prompt_bar.h"

// Shown over the plot after an act of the operator that took control from clients which still want it: one press hands
// it back. Dismiss applies until control is taken again.
namespace boresight::ui {

class CommandButton;
class RequestDesk;

class HandBackPrompt : public PromptBar
{
    Q_OBJECT

public:
    HandBackPrompt(RequestDesk& desk, QWidget* parent);

    void showStatus(const StationStatus& status);

private:
    void dismiss();

    CommandButton* m_handBack;
    bool m_dismissed = false;
};

}  // namespace boresight::ui
