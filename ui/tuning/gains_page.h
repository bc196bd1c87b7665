// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/kit/asking_panel.h"

class QDoubleSpinBox;
class QTableView;

// The gains of the drive of one axis: read, one changed within its bounds, put back, stored.
namespace boresight::ui {

class GainsModel;

class GainsPage : public AskingPanel
{
    Q_OBJECT

public:
    explicit GainsPage(RequestDesk& desk, QWidget* parent = nullptr);

    void setAxis(Axis axis);
    void showStatus(const StationStatus& status);

private:
    void build();
    QTableView* makeTable();
    void showSelected();
    void showButtons();
    void write();
    void store();
    [[nodiscard]] std::optional<Gain> selected() const;
    [[nodiscard]] const DriveGains& gains() const;

    StationStatus m_status;
    Axis m_axis = Axis::Azimuth;
    GainsModel* m_model;
    QTableView* m_table;
    ValueLabel* m_state;
    ValueLabel* m_reason;
    ValueLabel* m_notice;
    QDoubleSpinBox* m_value;
    CommandButton* m_read;
    CommandButton* m_write;
    CommandButton* m_putBack;
    CommandButton* m_store;
};

}  // namespace boresight::ui
