// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/messages/protocol_line.h"
#include "core/messages/station_status.h"

#include <QStackedWidget>

// The page Clients: the list of clients, and in its place on request the protocol log. Gui thread.
namespace boresight::ui {

class ClientsPanel;
class ProfileDraft;
class ProtocolLogPage;
class RequestDesk;

class ClientsPages : public QStackedWidget
{
    Q_OBJECT

public:
    ClientsPages(ProfileDraft& draft, RequestDesk& desk, QWidget* parent = nullptr);

    void showStatus(const StationStatus& status);
    void append(const ProtocolLines& lines);  // of the protocol log; null: none

private:
    ClientsPanel* m_clients;
    ProtocolLogPage* m_log;
};

}  // namespace boresight::ui
