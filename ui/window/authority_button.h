// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/messages/station_status.h"
#include "ui/kit/command_button.h"

// Takes control from the clients, and hands it back to them. Gui thread.
namespace boresight::ui {

class AuthorityButton : public CommandButton
{
    Q_OBJECT

public:
    AuthorityButton(RequestDesk& desk, ValueLabel& notice, QWidget* parent = nullptr);

    void showStatus(const StationStatus& status);

private:
    Authority m_control = Authority::Clients;
};

}  // namespace boresight::ui
