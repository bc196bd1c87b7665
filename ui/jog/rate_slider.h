// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/units/quantity.h"

#include <QSlider>

// A slider for a rate, from slow to fast on a logarithmic scale: equal distances are equal factors. It has the height
// of a finger, and a press anywhere on it goes there. Keys: arrows, Page Up and Down, Home, End.
namespace boresight::ui {

class RateSlider : public QSlider
{
    Q_OBJECT

public:
    explicit RateSlider(QWidget* parent = nullptr);

    void setEnds(AngularRate slow, AngularRate fast);
    void setRate(AngularRate rate);  // emits no signal
    [[nodiscard]] AngularRate rate() const;

    [[nodiscard]] QSize sizeHint() const override;
    [[nodiscard]] QSize minimumSizeHint() const override { return sizeHint(); }

Q_SIGNALS:
    void rateChosen(boresight::AngularRate rate);  // chosen by the operator

protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;

private:
    void moveTo(const QMouseEvent& event);
    [[nodiscard]] double pixel(int position) const;

    AngularRate m_slow = 1_deg_s;
    AngularRate m_fast = 1_deg_s;
};

}  // namespace boresight::ui
