// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/units/sky.h"

#include <QWidget>

// Which way an axis turns, as an arrow: azimuth seen from above, clockwise for a growing angle; elevation seen from the
// side, upwards for a growing angle. At rest the arrow of the growing angle in grey, in motion the one of that motion.
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
