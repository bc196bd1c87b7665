// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/messages/calibration_status.h"

#include <QWidget>

#include <vector>

// The calibration points on the sky, with the error of the beam at each: dashed with the model in effect, solid with
// the fit. The two have different scales, so that both are visible. The scales are written below.
namespace boresight::ui {

struct SkyProjection;

class ResidualSky : public QWidget
{
    Q_OBJECT

public:
    explicit ResidualSky(QWidget* parent = nullptr);

    void showPoints(const std::vector<PointStatus>& points);
    void setSelected(int row);  // -1: none

    [[nodiscard]] SkyProjection sky() const;
    [[nodiscard]] QPointF tip(const PointStatus& point, bool after) const;  // the tip of its arrow

    [[nodiscard]] QSize sizeHint() const override { return {180, 190}; }
    [[nodiscard]] QSize minimumSizeHint() const override { return {150, 140}; }

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    void paintGrid(QPainter& painter, const SkyProjection& projection) const;
    void paintArrow(QPainter& painter, const PointStatus& point, bool after) const;
    [[nodiscard]] double largest(bool after) const;  // degrees

    std::vector<PointStatus> m_points;
    int m_selected = -1;
};

}  // namespace boresight::ui
