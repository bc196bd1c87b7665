// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/kit/asking_panel.h"

class QDoubleSpinBox;
class QTableView;

// The gains of the drive of one axis: read all, change one within its bounds, restore, store.
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
    void load(const GainLine& line);
    void write();
    void putBack();
    void store();
    void askAboutFilter(const QString& act, const Request& request, Action action);
    [[nodiscard]] const GainLine* selected() const;
    [[nodiscard]] bool isEdited() const;
    [[nodiscard]] const DriveGains& gains() const;

    // The source of the value in the box, and the value shown at that time.
    struct Loaded
    {
        Axis axis;
        int row;
        GainLine line;
        double offered;
    };

    StationStatus m_status;
    Axis m_axis = Axis::Azimuth;
    std::optional<Loaded> m_loaded;
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
