// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/messages/sensor_status.h"

#include <QWidget>

#include <array>
#include <optional>

// The calibration levels of the sensor, 0 to 3: four bars for its fusion, gyro, accelerometer and magnetometer. The
// tooltip over each says how to raise it. The levels are also in words, so nothing depends on colour.
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
