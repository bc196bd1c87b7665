// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/messages/sensor_status.h"

#include <QWidget>

#include <optional>

// Two needles seen from above, with the values as they are read: the axis angle of the azimuth (solid, ●) and the
// heading of the sensor (dashed, △). A calibration finds the angle between them. Neither is a true direction, so the
// rim has numbers and no letters.
namespace boresight::ui {

class CompassDial : public QWidget
{
    Q_OBJECT

public:
    explicit CompassDial(QWidget* parent = nullptr);

    void showNeedles(const std::optional<Angle>& axis, const std::optional<orientation::SensorHeading>& sensor);

    [[nodiscard]] const std::optional<Angle>& axis() const { return m_axis; }
    [[nodiscard]] const std::optional<orientation::SensorHeading>& sensor() const { return m_sensor; }

    [[nodiscard]] QSize sizeHint() const override { return {150, 150}; }
    [[nodiscard]] QSize minimumSizeHint() const override { return {110, 110}; }

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    std::optional<Angle> m_axis;
    std::optional<orientation::SensorHeading> m_sensor;
};

}  // namespace boresight::ui
