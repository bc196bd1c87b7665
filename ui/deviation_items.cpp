// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/deviation_items.h"

#include "ui/theme.h"

#include <QPainter>
#include <QPolygonF>
#include <qwt_scale_map.h>

#include <algorithm>

namespace boresight::ui {

namespace {
constexpr double kSize = 3.5;  // px, half a sample
constexpr int kStep = 3;       // degrees between points of the curve
}  // namespace

void drawSample(QPainter& painter, SampleShape shape, QPointF at)
{
    const Theme& colours = currentTheme();
    const double side = shape == SampleShape::Back ? -kSize : kSize;
    switch (shape) {
        case SampleShape::Clockwise:
        case SampleShape::Back:
            painter.setPen(QPen(shape == SampleShape::Back ? colours.secondary : colours.text, 1.0));
            painter.setBrush(shape == SampleShape::Back ? QBrush(Qt::NoBrush) : QBrush(colours.text));
            painter.drawPolygon(
                QPolygonF{at + QPointF(side, 0.0), at + QPointF(-side, kSize), at + QPointF(-side, -kSize)});
            break;
        case SampleShape::LeftOut:
            painter.setPen(QPen(colours.warning, 1.2));
            painter.drawLine(at + QPointF(-kSize, -kSize), at + QPointF(kSize, kSize));
            painter.drawLine(at + QPointF(-kSize, kSize), at + QPointF(kSize, -kSize));
            break;
    }
}

void SwingItem::draw(QPainter* painter, const QwtScaleMap& headingMap, const QwtScaleMap& errorMap,
                     const QRectF& canvas) const
{
    if (!m_swing) {
        return;
    }
    painter->save();
    painter->setRenderHint(QPainter::Antialiasing);
    drawUnreliable(*painter, headingMap, canvas);
    drawSamples(*painter, headingMap, errorMap, canvas);
    drawCurve(*painter, headingMap, errorMap);
    painter->restore();
}

void SwingItem::drawUnreliable(QPainter& painter, const QwtScaleMap& headingMap, const QRectF& canvas) const
{
    const auto hatch = [&](double from, double to) {
        const double left = headingMap.transform(from);
        painter.fillRect(QRectF(left, canvas.top(), headingMap.transform(to) - left, canvas.height()),
                         QBrush(currentTheme().secondary, Qt::BDiagPattern));
    };
    for (const calibration::UnreliableSector& sector : m_swing->fit.curve.unreliable) {
        const double from = sector.from.wrapped360().degrees();
        const double to = sector.to.wrapped360().degrees();
        if (from <= to) {
            hatch(from, to);
        } else {  // through north
            hatch(from, 360.0);
            hatch(0.0, to);
        }
    }
}

void SwingItem::drawCurve(QPainter& painter, const QwtScaleMap& headingMap, const QwtScaleMap& errorMap) const
{
    QPolygonF curve;
    for (int heading = 0; heading <= 360; heading += kStep) {
        const Angle error = m_swing->fit.curve.deviation(Angle::fromDegrees(heading));
        curve << QPointF(headingMap.transform(heading), errorMap.transform(error.degrees()));
    }
    painter.setPen(QPen(currentTheme().accent, 2.0));
    painter.drawPolyline(curve);
}

// The residual of each as a line to the curve; what lies beyond the scale stands at its edge.
void SwingItem::drawSamples(QPainter& painter, const QwtScaleMap& headingMap, const QwtScaleMap& errorMap,
                            const QRectF& canvas) const
{
    for (const calibration::SwingResidual& one : m_swing->fit.samples) {
        const bool isUsed = one.fate == calibration::SampleFate::Used;
        const bool clockwise = one.sample >= m_swing->samples.size() ||
                               m_swing->samples[one.sample].turning == calibration::Turning::Clockwise;
        const double x = headingMap.transform(one.heading.wrapped360().degrees());
        const auto y = [&](Angle error) {
            return std::clamp(errorMap.transform(error.degrees()), canvas.top() + kSize, canvas.bottom() - kSize);
        };
        painter.setPen(QPen(currentTheme().secondary, 0.7));
        painter.drawLine(QPointF(x, y(one.error)), QPointF(x, y(one.error - one.residual)));
        drawSample(painter,
                   !isUsed     ? SampleShape::LeftOut
                   : clockwise ? SampleShape::Clockwise
                               : SampleShape::Back,
                   {x, y(one.error)});
    }
}

}  // namespace boresight::ui
