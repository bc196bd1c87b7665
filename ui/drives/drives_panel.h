// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/kit/asking_panel.h"

#include <array>

class QDoubleSpinBox;

// The drives: their identity, whether they are fit to move the mount, releasing the bus to other tools, and the
// crash-stop test.
namespace boresight::ui {

class DrivesPanel : public AskingPanel
{
    Q_OBJECT

public:
    explicit DrivesPanel(RequestDesk& desk, QWidget* parent = nullptr);

    void showStatus(const StationStatus& status);

private:
    struct Identity  // of one drive
    {
        ValueLabel* id = nullptr;
        ValueLabel* uuid = nullptr;
        ValueLabel* firmware = nullptr;
        ValueLabel* registerMap = nullptr;
        ValueLabel* turn = nullptr;
    };

    void build();
    QWidget* makeIdentities();
    QWidget* makeProof();
    void showDrive(Axis axis);
    void showProof();
    void release();
    void prove();

    StationStatus m_status;
    std::array<Identity, 2> m_identities;       // by axis
    std::array<ValueLabel*, 2> m_crashStops{};  // by axis
    ValueLabel* m_unknownBoards;
    ValueLabel* m_driveCheck;
    ValueLabel* m_arming;
    ValueLabel* m_proof;
    ValueLabel* m_notice;
    QDoubleSpinBox* m_rate;
    CommandButton* m_release;
    CommandButton* m_run;
};

}  // namespace boresight::ui
