// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/messages/station_status.h"
#include "ui/kit/prompt_bar.h"
#include "ui/link/direction_question.h"

#include <optional>

// The direction that was picked on the sky, with the button Go here, the second step, which moves the mount. If the
// mount may not go there it gives the reason.
namespace boresight::ui {

class CommandButton;

class PickPrompt : public PromptBar
{
    Q_OBJECT

public:
    PickPrompt(RequestDesk& desk, QWidget* parent);

    void pick(const SkyPointing& direction);
    void withdraw();
    void goTo(const SkyPointing& direction);  // picks the direction and requests the motion at once
    void showStatus(const StationStatus& status);

Q_SIGNALS:
    void picked(const std::optional<boresight::SkyPointing>& direction);  // empty: no direction is picked

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
