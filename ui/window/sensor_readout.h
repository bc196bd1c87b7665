// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/messages/sensor_status.h"

#include <QWidget>

// What the orientation sensor says, below the axes: its true direction, how old that is, how far it is from the axes,
// and how well it is calibrated. Not there without a sensor.
namespace boresight::ui {

class CalibrationBars;
class ValueLabel;

class SensorReadout : public QWidget
{
    Q_OBJECT

public:
    explicit SensorReadout(QWidget* parent = nullptr);

    void showStatus(const SensorStatus& sensor);

private:
    ValueLabel* m_direction;
    ValueLabel* m_age;
    ValueLabel* m_detail;
    CalibrationBars* m_bars;
};

}  // namespace boresight::ui
