// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/messages/sensor_status.h"

#include <QWidget>

#include <array>
#include <optional>

// The calibration level of each part of the sensor, 0 to 3, as four bars, with a text about how to raise it.
namespace boresight::ui {

class LevelBar;
class ValueLabel;

class SensorLevels : public QWidget
{
    Q_OBJECT

public:
    explicit SensorLevels(QWidget* parent = nullptr);

    void showCalibration(const std::optional<orientation::Calibration>& calibration);

private:
    struct Row
    {
        LevelBar* bar = nullptr;
        ValueLabel* how = nullptr;
    };

    std::array<Row, 4> m_rows;
};

// Three boxes, filled from the left. Empty and dotted while the level is unknown.
class LevelBar : public QWidget
{
    Q_OBJECT

public:
    explicit LevelBar(const QString& name, QWidget* parent = nullptr);

    void setLevel(std::optional<int> level);
    [[nodiscard]] std::optional<int> level() const { return m_level; }

    [[nodiscard]] QSize sizeHint() const override { return {48, 14}; }

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    std::optional<int> m_level;
};

}  // namespace boresight::ui
