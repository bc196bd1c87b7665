// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/messages/station_status.h"

#include <QWidget>

// The report of the orientation sensor, below the axes: its true direction, its age, the difference from the axes, and
// its calibration. Hidden without a sensor, and while an alarm needs its room. Gui thread.
namespace boresight::ui {

class CalibrationBars;
class ValueLabel;

class SensorReadout : public QWidget
{
    Q_OBJECT

public:
    explicit SensorReadout(QWidget* parent = nullptr);

    void showStatus(const SensorStatus& sensor, const BrokerStatus& broker = {});
    void setRoom(bool has);  // whether there is room for it
    [[nodiscard]] bool isConfigured() const { return m_isConfigured; }

private:
    ValueLabel* m_direction;
    ValueLabel* m_age;
    ValueLabel* m_detail;
    CalibrationBars* m_bars;
    bool m_isConfigured = false;
    bool m_hasRoom = true;
};

}  // namespace boresight::ui
