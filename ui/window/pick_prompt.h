// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/messages/station_status.h"
#include "ui/kit/prompt_bar.h"
#include "ui/link/direction_question.h"

#include <optional>

// The direction that was picked on the sky, with Go here: the second act, which moves the mount. Says why the mount may
// not go there.
namespace boresight::ui {

class CommandButton;

class PickPrompt : public PromptBar
{
    Q_OBJECT

public:
    PickPrompt(RequestDesk& desk, QWidget* parent);

    void pick(const SkyPointing& direction);
    void withdraw();
    void goTo(const SkyPointing& direction);  // picked and asked for at once
    void showStatus(const StationStatus& status);

Q_SIGNALS:
    void picked(const std::optional<boresight::SkyPointing>& direction);  // empty: nothing is

private:
    void go();
    void showVerdict();
    void block();

    CommandButton* m_goHere;
    DirectionQuestion m_question;
    std::optional<SkyPointing> m_picked;
    QString m_whyNoMotion;  // to any direction
    QString m_forbidden;    // as shown
};

}  // namespace boresight::ui
