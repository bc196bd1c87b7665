// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/kit/asking_panel.h"

#include <array>

class QTableView;

// The safety settings of the drives: wanted and found values, with the reason for the selected line. Buttons to read
// them again, to write the differences, and to switch the drives off, which writing requires.
// Below them the state of the end switches, if the profile has some.
namespace boresight::ui {

class ProtectionModel;

class ProtectionPanel : public AskingPanel
{
    Q_OBJECT

public:
    explicit ProtectionPanel(RequestDesk& desk, QWidget* parent = nullptr);
    // For the guide, which has less room: reading and writing only.
    void hideSwitches();

    void showStatus(const StationStatus& status);

private:
    void build();
    QTableView* makeTable();
    void showDriveCheck(const StationStatus& status);
    void showReason();
    void showSwitches();
    void fix();
    void setGear();
    void switchOff();
    void switchOff(Axis axis);

    StationStatus m_status;
    ProtectionModel* m_model;
    QTableView* m_table;
    ValueLabel* m_driveCheck;
    ValueLabel* m_reason;
    ValueLabel* m_switches;  // the end switches of the profile
    ValueLabel* m_notice;
    CommandButton* m_read;
    CommandButton* m_fix;
    CommandButton* m_gear;  // only if the gear ratio differs
    CommandButton* m_switchOff;
    std::array<CommandButton*, 2> m_switchAxisOff;
};

}  // namespace boresight::ui
