// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/messages/station_status.h"

#include <QWidget>

class QDoubleSpinBox;
class QLineEdit;

// A landmark as a known direction: the operator has centred it, and types its true direction.
namespace boresight::ui {

class CommandButton;
class RequestDesk;
class ValueLabel;

class LandmarkBox : public QWidget
{
    Q_OBJECT

public:
    LandmarkBox(RequestDesk& desk, ValueLabel& notice, QWidget* parent = nullptr);

    void showStatus(const StationStatus& status);

private:
    void build();
    void describe();
    [[nodiscard]] bool isTold() const;
    void take();

    StationStatus m_status;

    QDoubleSpinBox* m_azimuth;
    QDoubleSpinBox* m_elevation;
    QLineEdit* m_label;
    ValueLabel* m_state;
    CommandButton* m_take;
};

}  // namespace boresight::ui
