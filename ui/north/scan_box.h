// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/messages/station_status.h"

#include <QWidget>

class QDoubleSpinBox;
class QLineEdit;

// The peak of the received power as a known direction: the mount scans across the body that is followed, along both
// axes, and waits at each place for the power that is typed here, or that comes from a receiver. The width that is
// offered is twice the beam of the profile; what was found is told and shown below.
namespace boresight::ui {

class CommandButton;
class RequestDesk;
class RunLine;
class ScanPlot;
class ValueLabel;

class ScanBox : public QWidget
{
    Q_OBJECT

public:
    ScanBox(RequestDesk& desk, ValueLabel& notice, QWidget* parent = nullptr);

    // To be scanned next.
    void setBody(ephemeris::Body body) { m_wanted = body; }
    void showStatus(const StationStatus& status);

    [[nodiscard]] ephemeris::Body body() const { return m_body; }

private:
    void build();
    void offerWidth(const StationStatus& status);
    void showFound(const CalibrationStatus& calibration);
    void startOrEnd();
    void give();

    ephemeris::Body m_wanted = ephemeris::Body::Sun;
    ephemeris::Body m_body = ephemeris::Body::Sun;  // that is scanned, or would be
    bool m_running = false;
    bool m_isTyped = false;  // the width: it stays
    ValueLabel& m_notice;
    QDoubleSpinBox* m_width;
    QLineEdit* m_power;
    RunLine* m_run;
    ValueLabel* m_line;
    ValueLabel* m_found;
    ScanPlot* m_plot;
    CommandButton* m_start;
    CommandButton* m_give;
};

}  // namespace boresight::ui
