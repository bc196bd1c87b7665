// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/kit/prompt_bar.h"

// Asks whether to close the window while the mount moves, and then reports that the closing is in progress.
namespace boresight::ui {

class ClosePrompt : public PromptBar
{
    Q_OBJECT

public:
    explicit ClosePrompt(QWidget* parent);

    void ask();
    void confirm();   // also without a question before
    void withdraw();  // the mount stands still, so the question is not needed any more

Q_SIGNALS:
    void confirmed();

private:
    bool m_confirmed = false;
};

}  // namespace boresight::ui
