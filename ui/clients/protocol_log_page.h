// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/messages/station_status.h"
#include "ui/clients/protocol_log_model.h"

#include <QWidget>

class QComboBox;

// The lines of all clients as they were received, what the station understood, and its answers. The log is off at the
// start of a station: the button begins it. Lines can be filtered by client, copied, and saved to a file. Gui thread.
namespace boresight::ui {

class CommandButton;
class LinesView;
class RequestDesk;
class ValueLabel;

class ProtocolLogPage : public QWidget
{
    Q_OBJECT

public:
    explicit ProtocolLogPage(RequestDesk& desk, QWidget* parent = nullptr);

    void showStatus(const StationStatus& status);
    void append(const std::vector<ProtocolLine>& lines);

    [[nodiscard]] const ProtocolLogFilter& shown() const { return *m_filter; }

Q_SIGNALS:
    void closed();  // the list of clients is wanted

private:
    void addClients();
    void offer(const ProtocolLine& line);
    void showState();

    ProtocolLogModel* m_model;
    ProtocolLogFilter* m_filter;
    LinesView* m_view;
    CommandButton* m_switch;
    ValueLabel* m_state;
    QComboBox* m_client;
    bool m_on = false;
};

}  // namespace boresight::ui
