// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/messages/station_status.h"

#include <QWidget>

class QScrollArea;

// What stands above the tabs: the alarm card while there is one, the readouts of the axes, the antenna in use where
// there are several, the readout of the sensor. Its height depends on the window and the number of antennas alone, so
// that tabs and buttons stay where the operator's hand is. There is room for an alarm of usual length: it takes it from
// the readouts, which get smaller. A longer one scrolls. Gui thread.
namespace boresight::ui {

class AlarmCard;
class AntennaRow;
class AxisReadout;
class RequestDesk;
class SensorReadout;

class ColumnHead : public QWidget
{
    Q_OBJECT

public:
    ColumnHead(AlarmCard& alarms, RequestDesk& desk, QWidget* parent = nullptr);

    void showStatus(const StationStatus& status);
    void setRoom(QSize window);

    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void arrange();
    [[nodiscard]] int heightOfAlarm() const;

    AlarmCard& m_alarms;
    QScrollArea* m_alarmRoom;
    AxisReadout* m_axes;
    AntennaRow* m_antenna;
    SensorReadout* m_sensor;
    QSize m_window;
};

}  // namespace boresight::ui
