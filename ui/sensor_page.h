// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/station/station_status.h"

#include <QWidget>

// Step 1 of finding north: the sensor's own opinion, from an average while the mount stands still. Good to some
// degrees; what the needle's own deviation does is only seen by a swing.
namespace boresight::ui {

class CommandButton;
class CompassDial;
class RequestDesk;
class RunLine;
class SensorLevels;
class ValueLabel;

class SensorPage : public QWidget
{
    Q_OBJECT

public:
    explicit SensorPage(RequestDesk& desk, QWidget* parent = nullptr);

    void showStatus(const StationStatus& status);

private:
    void build();
    void showNeedles(const StationStatus& status);
    void measureOrEnd();

    bool m_running = false;
    CompassDial* m_dial;
    SensorLevels* m_levels;
    ValueLabel* m_sensor;
    ValueLabel* m_axis;
    ValueLabel* m_difference;
    ValueLabel* m_declination;
    ValueLabel* m_offset;
    RunLine* m_run;
    ValueLabel* m_notice;
    CommandButton* m_measure;
};

}  // namespace boresight::ui
