// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/messages/station_status.h"
#include "ui/window/alarm_card.h"
#include "ui/window/axis_readout.h"

#include <QWidget>

// The part above the tabs: the alarm card while there is one, the readouts of the axes, the antenna in use if there are
// several, the wind if it is read, and the readout of the sensor. Tabs and buttons do not move: an alarm takes its room
// from the readouts, which get smaller. The longest alarms leave out a sentence. Gui thread.
namespace boresight::ui {

class AntennaRow;
class RequestDesk;
class SensorReadout;
class WindReadout;

class ColumnHead : public QWidget
{
    Q_OBJECT

public:
    ColumnHead(AlarmCard& alarms, RequestDesk& desk, QWidget* parent = nullptr);

    void showStatus(const StationStatus& status);
    void setRoom(QSize window);

Q_SIGNALS:
    void antennasWanted();  // opens the page where they are edited

private:
    struct Arrangement
    {
        Numerals numerals;
        bool sensor;
        AlarmForm alarm = AlarmForm::Lines;
    };

    // The alarm and the window for which the letters were chosen.
    struct Tried
    {
        QString alarm;
        QSize window;
        friend bool operator==(const Tried&, const Tried&) = default;
    };

    void arrange();
    [[nodiscard]] Arrangement mostCompleteArrangement();
    [[nodiscard]] int heightOfAlarm(AlarmForm form) const;

    AlarmCard& m_alarms;
    AxisReadout* m_axes;
    AntennaRow* m_antenna;
    SensorReadout* m_sensor;
    WindReadout* m_wind;
    QSize m_window;
    Tried m_tried;
};

}  // namespace boresight::ui
