// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/kit/asking_panel.h"

// The control box of a rotator: the offsets of its sensor, a line that the operator types to it with its answers, and
// its home run. Each part is shown only if the rotator has it. The typed line stays until the station has accepted it.
// Gui thread.
namespace boresight::ui {

class ProfileDraft;
class SensorOffsetsRow;

class BoxConsolePanel : public AskingPanel
{
    Q_OBJECT

public:
    BoxConsolePanel(ProfileDraft& draft, RequestDesk& desk, QWidget* parent = nullptr);

    void showStatus(const StationStatus& status);

private:
    void build();
    void send();
    void askForHomeRun();

    StationStatus m_status;
    QWidget* m_console;  // the typed line and the answers
    QPlainTextEdit* m_answers;
    QLineEdit* m_line;
    ValueLabel* m_notice;
    SensorOffsetsRow* m_offsets;
    CommandButton* m_send;
    CommandButton* m_homeRun;
    QStringList m_shown;
};

}  // namespace boresight::ui
