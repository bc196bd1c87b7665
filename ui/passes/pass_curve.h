// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/targets/sky_moment.h"

#include <QPainterPath>
#include <QWidget>

#include <optional>

// The elevation of the selected pass over time, from rise to set. The line is dotted where the limits of the mount hide
// the satellite. The lowest elevation that counts and the present place are marked. Passive. Gui thread, UTC.
namespace boresight::ui {

struct PassTimeAxis;

class PassCurve : public QWidget
{
    Q_OBJECT

public:
    explicit PassCurve(QWidget* parent = nullptr);

    void show(const targets::SkyWay& way);              // null: no pass
    void setLowest(const std::optional<Angle>& angle);  // the pass counts above this elevation; empty: all of it counts
    void setNow(UtcTime now);

    [[nodiscard]] QPainterPath line(bool hidden) const;  // in pixels
    [[nodiscard]] std::optional<QPointF> place() const;  // the present place of the satellite; empty: below the horizon
    [[nodiscard]] Angle top() const;                     // upper end of the scale
    [[nodiscard]] QPointF pixelOf(UtcTime utc, Angle elevation) const;

    [[nodiscard]] QSize minimumSizeHint() const override { return {200, 80}; }

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    [[nodiscard]] QRectF canvas() const;
    [[nodiscard]] PassTimeAxis timeAxis() const;
    [[nodiscard]] const targets::SkyMoment& highest() const;
    void paintGrid(QPainter& painter) const;
    void paintMarks(QPainter& painter) const;
    void describe();

    targets::SkyWay m_way;
    std::optional<Angle> m_lowest;
    UtcTime m_now{};
};

}  // namespace boresight::ui
