// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/messages/calibration_status.h"

#include <QWidget>

#include <optional>

// The two lines of a cross scan side by side: the readings, the beam fitted to them, and its peak. The offset in
// degrees increases to the right, the power in dB upwards. Both lines have the same scale. The plot gets the room that
// the other widgets leave. In a small window it is invisible.
namespace boresight::ui {

class ScanPlot : public QWidget
{
    Q_OBJECT

public:
    explicit ScanPlot(QWidget* parent = nullptr);

    void showScan(const std::optional<calibration::CrossScan>& scan);

    // The pixel of a place and a power on one of the lines.
    [[nodiscard]] QPointF pixel(const calibration::ScanPeak& line, Angle offset, double decibels) const;

    [[nodiscard]] QSize sizeHint() const override { return {260, 120}; }
    [[nodiscard]] QSize minimumSizeHint() const override { return {160, 0}; }

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    [[nodiscard]] QRectF frame(const calibration::ScanPeak& line) const;
    void paintLine(QPainter& painter, const calibration::ScanPeak& line, const QString& name) const;

    std::optional<calibration::CrossScan> m_scan;
    double m_low = 0.0;  // dB, of both lines
    double m_high = 1.0;
};

}  // namespace boresight::ui
