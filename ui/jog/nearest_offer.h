// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/kit/command_button.h"
#include "ui/link/direction_question.h"

// Beside the refusal of a direction: one press goes to the nearest allowed direction instead. The station has computed
// it. Hidden while there is none. Gui thread.
namespace boresight::ui {

class NearestOffer : public CommandButton
{
    Q_OBJECT

public:
    NearestOffer(RequestDesk& desk, ValueLabel& notice, QWidget* parent = nullptr);

    void offerFor(const SkyPointing& refusedDirection);
    void drop();

private:
    void show();

    DirectionQuestion m_question;
};

}  // namespace boresight::ui
