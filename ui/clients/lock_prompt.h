// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/messages/station_status.h"
#include "ui/kit/press_guard.h"
#include "ui/kit/prompt_bar.h"

// Shown over the plot with every panel: Boresight recognised the target that a client tracks, and offers to track it
// from its own orbit. A target that was declined is not offered to this client again.
namespace boresight::ui {

class CommandButton;
class RequestDesk;

class LockPrompt : public PromptBar
{
    Q_OBJECT

public:
    LockPrompt(RequestDesk& desk, QWidget* parent);

    void showStatus(const StationStatus& status);

private:
    CommandButton* m_track;
    CommandButton* m_decline;
    RecognisedTarget m_offered;  // in the text
    PressGuard m_guard{this};    // after the prompt has come, or names another target
};

}  // namespace boresight::ui
