// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/units/sky.h"
#include "ui/kit/format.h"

#include <QWidget>

#include <optional>

// One axis in axis angles: its travel as a bar, hatched outside the limits in effect, the edited limits as dashed
// marks, and a pointer at the position of the axis.
namespace boresight::ui {

class LimitBar : public QWidget
{
    Q_OBJECT

public:
    using QWidget::QWidget;

    void setRanges(const TravelRange& travel, const TravelRange& inForce, const TravelRange& edited);
    void setActual(const std::optional<Angle>& actual, Freshness freshness);

    [[nodiscard]] QSize sizeHint() const override;
    [[nodiscard]] QSize minimumSizeHint() const override;

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    TravelRange m_travel;
    TravelRange m_inForce;
    TravelRange m_edited;
    std::optional<Angle> m_actual;
    Freshness m_freshness = Freshness::NoData;
};

}  // namespace boresight::ui
