// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/messages/station_status.h"

#include <QWidget>

#include <array>
#include <optional>

// The numbers of both axes: actual and target as true directions, error (target minus actual, along the way the axis
// really goes) and a word; below, what is trimmed, what the axis shows where that is not the truth, and a detail. An
// old number is dimmed with its age, a very old one is not shown at all; on an unknown turn it is dimmed, coarse and
// ends in a question mark.
namespace boresight::ui {

class ValueLabel;

class AxisReadout : public QWidget
{
    Q_OBJECT

public:
    explicit AxisReadout(QWidget* parent = nullptr);

    void showStatus(const StationStatus& status);

protected:
    bool event(QEvent* event) override;

private:
    struct Row
    {
        ValueLabel* actual = nullptr;
        ValueLabel* target = nullptr;
        ValueLabel* error = nullptr;
        ValueLabel* state = nullptr;
        ValueLabel* detail = nullptr;
    };

    Row makeRow(Axis axis);
    void showRow(Axis which, bool turnKnown, bool turnAwaited);
    [[nodiscard]] QString detail(Axis which) const;

    std::array<Row, 2> m_rows;  // by Axis
    std::array<AxisStatus, 2> m_shown;
    std::array<QString, 2> m_registers;  // what the drives say of themselves
    std::optional<SkyPointing> m_trim;
    bool m_hasModel = false;  // the axes do not show the truth
};

}  // namespace boresight::ui
