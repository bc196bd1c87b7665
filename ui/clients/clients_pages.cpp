// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/clients/clients_pages.h"

#include "ui/clients/clients_panel.h"
#include "ui/clients/protocol_log_page.h"
#include "ui/kit/page_room.h"

namespace boresight::ui {

ClientsPages::ClientsPages(ProfileDraft& draft, RequestDesk& desk, QWidget* parent)
    : QStackedWidget(parent), m_clients(new ClientsPanel(draft, desk, this)), m_log(new ProtocolLogPage(desk, this))
{
    addWidget(m_clients);
    addWidget(m_log);
    keepHeightOfShownPage(*this);
    connect(m_clients, &ClientsPanel::protocolLogWanted, this, [this] {
        setCurrentWidget(m_log);
        m_log->setFocus();
    });
    connect(m_log, &ProtocolLogPage::closed, this, [this] {
        setCurrentWidget(m_clients);
        m_clients->focusProtocolLog();
    });
}

void ClientsPages::showStatus(const StationStatus& status)
{
    m_clients->showStatus(status);
    m_log->showStatus(status);
}

void ClientsPages::append(const ProtocolLines& lines)
{
    if (lines) {
        m_log->append(*lines);
    }
}

}  // namespace boresight::ui

#include "moc_clients_pages.cpp"
