// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/messages/sensor_status.h"

#include <QWidget>

#include <array>
#include <optional>

// How sure the sensor is of itself: four bars of three, for its fusion, gyro, accelerometer and magnetometer. The
// tooltip over each tells how to raise it. The words carry it too: nothing depends on colour.
namespace boresight::ui {

class CalibrationBars : public QWidget
{
    Q_OBJECT

public:
    explicit CalibrationBars(QWidget* parent = nullptr);

    void showCalibration(const std::optional<orientation::Calibration>& calibration);

    [[nodiscard]] QSize sizeHint() const override;
    [[nodiscard]] QSize minimumSizeHint() const override { return sizeHint(); }

protected:
    void paintEvent(QPaintEvent* event) override;
    bool event(QEvent* event) override;

private:
    [[nodiscard]] int partWidth() const;
    [[nodiscard]] int nameWidth() const;
    void drawPart(QPainter& painter, int part) const;

    std::optional<std::array<int, 4>> m_digits;
};

}  // namespace boresight::ui
