// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/station/station_status.h"

#include <QWidget>

class QDoubleSpinBox;
class QLineEdit;

// The peak of the received power as a known direction: the mount scans across the body that is followed, along both
// axes, and waits at each place for the power that is typed here, or that comes from a receiver.
namespace boresight::ui {

class CommandButton;
class RequestDesk;
class RunLine;
class ValueLabel;

class ScanBox : public QWidget
{
    Q_OBJECT

public:
    ScanBox(RequestDesk& desk, ValueLabel& notice, QWidget* parent = nullptr);

    void showStatus(const StationStatus& status);

    [[nodiscard]] ephemeris::Body body() const { return m_body; }

private:
    void build();
    void startOrEnd();
    void give();

    ephemeris::Body m_body = ephemeris::Body::Sun;
    bool m_running = false;
    ValueLabel& m_notice;
    QDoubleSpinBox* m_width;
    QLineEdit* m_power;
    RunLine* m_run;
    ValueLabel* m_line;
    CommandButton* m_start;
    CommandButton* m_give;
};

}  // namespace boresight::ui
