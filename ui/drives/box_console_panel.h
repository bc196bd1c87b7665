// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/messages/station_status.h"

#include <QWidget>

class QLineEdit;
class QPlainTextEdit;

// A line that the operator types to the control box, and the answers of the box. The typed line stays until the station
// has accepted it. Above it the offsets of the sensor of the box, if the box reports them. Gui thread.
namespace boresight::ui {

class CommandButton;
class ProfileDraft;
class RequestDesk;
class SensorOffsetsRow;
class ValueLabel;

class BoxConsolePanel : public QWidget
{
    Q_OBJECT

public:
    BoxConsolePanel(ProfileDraft& draft, RequestDesk& desk, QWidget* parent = nullptr);

    void showStatus(const StationStatus& status);

private:
    void build();
    void send();

    QPlainTextEdit* m_answers;
    QLineEdit* m_line;
    ValueLabel* m_notice;
    SensorOffsetsRow* m_offsets;
    CommandButton* m_send;
    QStringList m_shown;
};

}  // namespace boresight::ui
