// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/north/scan_plot.h"

#include "ui/kit/format.h"
#include "ui/kit/theme.h"

#include <QPainter>

#include <algorithm>
#include <cmath>
#include <limits>

namespace boresight::ui {

namespace {
constexpr double kScanPlotGap = 8.0;  // px, between the two lines
constexpr double kMargin = 4.0;       // px, of a reading from the edge
constexpr double kScanPlotDot = 2.5;  // px
constexpr double kCurveStep = 2.0;    // px
constexpr double kLeastSpan = 0.1;    // dB
constexpr int kLeastHeight = 40;      // px, including the names below
}  // namespace

ScanPlot::ScanPlot(QWidget* parent) : QWidget(parent)
{
    setAccessibleName(tr("Power along both lines of the scan"));
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
}

void ScanPlot::showScan(const std::optional<calibration::CrossScan>& scan)
{
    m_scan = scan;
    if (m_scan) {
        m_low = std::numeric_limits<double>::infinity();
        m_high = -m_low;
        for (const calibration::ScanPeak* const line : {&m_scan->across, &m_scan->elevation}) {
            m_high = std::max(m_high, line->decibels);
            for (const calibration::ScanReading& reading : line->readings) {
                m_low = std::min(m_low, reading.decibels);
                m_high = std::max(m_high, reading.decibels);
            }
        }
        m_high = std::max(m_high, m_low + kLeastSpan);
        setAccessibleDescription(tr("%1 to %2 dB").arg(m_low, 0, 'f', 1).arg(m_high, 0, 'f', 1));
    }
    update();
}

QRectF ScanPlot::frame(const calibration::ScanPeak& line) const
{
    const double text = QFontMetricsF(fonts::label()).height();
    const double wide = (width() - kScanPlotGap) / 2.0;
    return {m_scan && &line == &m_scan->elevation ? wide + kScanPlotGap : 0.0, 0.0, wide,
            std::max(1.0, height() - text)};
}

QPointF ScanPlot::pixel(const calibration::ScanPeak& line, Angle offset, double decibels) const
{
    const QRectF inside = frame(line).adjusted(kMargin, kMargin, -kMargin, -kMargin);
    const Angle first = line.readings.front().offset;
    const double along = (offset - first) / (line.readings.back().offset - first);
    return {inside.left() + along * inside.width(),
            inside.bottom() - (decibels - m_low) / (m_high - m_low) * inside.height()};
}

void ScanPlot::paintLine(QPainter& painter, const calibration::ScanPeak& line, const QString& name) const
{
    const Theme& colours = currentTheme();
    const QRectF box = frame(line);
    painter.setPen(colours.grid);
    painter.setBrush(colours.plotGround);
    painter.drawRect(box.adjusted(0.5, 0.5, -0.5, -0.5));
    const Angle first = line.readings.front().offset;
    const Angle length = line.readings.back().offset - first;
    const double middle = pixel(line, Angle{}, m_low).x();
    painter.drawLine(QPointF(middle, box.top()), QPointF(middle, box.bottom()));
    const double peak = pixel(line, line.offset.value, m_low).x();
    painter.setPen(QPen(colours.accent, 1.0, Qt::DashLine));
    painter.drawLine(QPointF(peak, box.top()), QPointF(peak, box.bottom()));
    QPolygonF curve;
    const int steps = std::max(1, static_cast<int>(box.width() / kCurveStep));
    for (int step = 0; step <= steps; ++step) {
        const Angle offset = first + length * (static_cast<double>(step) / steps);
        curve << pixel(line, offset, std::max(m_low, calibration::decibelsAt(line, offset)));
    }
    painter.setPen(QPen(colours.accent, 1.5));
    painter.drawPolyline(curve);
    painter.setPen(Qt::NoPen);
    painter.setBrush(colours.text);
    for (const calibration::ScanReading& reading : line.readings) {
        painter.drawEllipse(pixel(line, reading.offset, reading.decibels), kScanPlotDot, kScanPlotDot);
    }
    painter.setPen(colours.secondary);
    painter.drawText(QRectF(box.left(), box.bottom(), box.width(), height() - box.bottom()), Qt::AlignCenter, name);
}

void ScanPlot::paintEvent(QPaintEvent*)
{
    if (!m_scan || height() < kLeastHeight) {
        return;
    }
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setFont(fonts::label());
    paintLine(painter, m_scan->across, tr("across"));
    paintLine(painter, m_scan->elevation, tr("elevation"));
}

}  // namespace boresight::ui

#include "moc_scan_plot.cpp"
