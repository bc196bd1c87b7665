// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/messages/station_status.h"

#include <QWidget>

#include <array>

class QGridLayout;

// The numbers of one moment of a recording: UTC, state, both axes, and the pointing error. A number that is older than
// 2 s is not shown. Gui thread.
namespace boresight::ui {

class ValueLabel;

class MomentNumbers : public QWidget
{
    Q_OBJECT

public:
    explicit MomentNumbers(QWidget* parent = nullptr);

    // `state` is the word of the station, `error` the angle between beam and target.
    void show(const StationStatus& status, const QString& state, const std::optional<Angle>& error);
    using QWidget::show;

private:
    struct AxisLabels
    {
        ValueLabel* actual = nullptr;
        ValueLabel* commanded = nullptr;
        ValueLabel* target = nullptr;
        ValueLabel* torque = nullptr;
    };

    [[nodiscard]] ValueLabel* addNumber(QGridLayout& grid, int row, int column, const QString& name,
                                        const QString& widest);

    ValueLabel* m_utc;
    ValueLabel* m_state;
    ValueLabel* m_error;
    std::array<AxisLabels, 2> m_axes;  // by Axis
};

}  // namespace boresight::ui
