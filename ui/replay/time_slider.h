// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"

#include <QSlider>

#include <vector>

// The moments of a recording from left to right, with a mark where a motion began. A press jumps to that moment. Keys
// are left to the window, which uses the same ones everywhere. Gui thread.
namespace boresight::ui {

class TimeSlider : public QSlider
{
    Q_OBJECT

public:
    TimeSlider(UtcTime begin, UtcTime end, const std::vector<UtcTime>& marks, QWidget* parent = nullptr);

    void setMoment(UtcTime moment);

    [[nodiscard]] QSize sizeHint() const override;

Q_SIGNALS:
    void momentChosen(boresight::UtcTime moment);

protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

private:
    [[nodiscard]] double pixelOf(UtcTime moment) const;
    void choose(double pixel);

    UtcTime m_begin;
    UtcTime m_end;
    UtcTime m_moment;
    std::vector<UtcTime> m_marks;
};

}  // namespace boresight::ui
