// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/messages/station_status.h"

#include <QWidget>

class QDoubleSpinBox;
class QLineEdit;

// The peak of the received power as a known direction. The mount scans across the tracked body along both axes, and
// waits at each place for the power, which is typed here or comes from a receiver. The proposed width is twice the beam
// width of the profile. The result is reported and shown below.
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

    // The body of the next scan.
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
    ephemeris::Body m_body = ephemeris::Body::Sun;  // the body of the present or next scan
    bool m_running = false;
    bool m_isTyped = false;  // the width was typed, so it stays
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
