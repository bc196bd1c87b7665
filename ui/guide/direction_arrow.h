// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/units/sky.h"

#include <QWidget>

// An arrow that shows in which direction an axis turns. Azimuth is seen from above: clockwise when the angle grows.
// Elevation is seen from the side: upwards when the angle grows. While the axis stands still, the arrow is grey and
// shows the growing angle. While the axis moves, the arrow shows the present direction.
namespace boresight::ui {

enum class Turning
{
    Rests,
    Grows,
    Shrinks
};

class DirectionArrow : public QWidget
{
    Q_OBJECT

public:
    explicit DirectionArrow(Axis axis, QWidget* parent = nullptr);

    void setTurning(Turning turning);
    [[nodiscard]] Turning turning() const { return m_turning; }

    [[nodiscard]] QSize sizeHint() const override;

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    void describe();

    Axis m_axis;
    Turning m_turning = Turning::Rests;
};

}  // namespace boresight::ui
