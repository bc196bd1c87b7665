// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/north/deviation_items.h"

#include "ui/kit/theme.h"

#include <QPainter>
#include <QPolygonF>
#include <qwt_scale_map.h>

#include <algorithm>
#include <utility>

namespace boresight::ui {

namespace {

constexpr double kSize = 2.5;  // px, half a sample
// Samples overlap each other and the curve, so they are translucent.
constexpr int kSampleAlpha = 130;
constexpr double kCurveWidth = 2.0;  // px
constexpr double kHalo = 5.0;        // px of the background around it
constexpr int kStep = 3;             // degrees between points of the curve

SampleShape shapeOf(bool isUsed, bool clockwise)
{
    return !isUsed ? SampleShape::LeftOut : clockwise ? SampleShape::Clockwise : SampleShape::Back;
}

QColor translucent(QColor colour)
{
    colour.setAlpha(kSampleAlpha);
    return colour;
}

// A value beyond the scale is drawn at the edge.
double heightOf(Angle error, const QwtScaleMap& errorMap, const QRectF& canvas)
{
    return std::clamp(errorMap.transform(error.degrees()), canvas.top() + kSize, canvas.bottom() - kSize);
}

}  // namespace

void drawSample(QPainter& painter, SampleShape shape, QPointF at)
{
    const Theme& colours = currentTheme();
    const double side = shape == SampleShape::Back ? -kSize : kSize;
    switch (shape) {
        case SampleShape::Clockwise:
        case SampleShape::Back:
            painter.setPen(QPen(translucent(shape == SampleShape::Back ? colours.secondary : colours.text), 1.0));
            painter.setBrush(shape == SampleShape::Back ? QBrush(Qt::NoBrush) : QBrush(translucent(colours.text)));
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
    painter->save();
    painter->setRenderHint(QPainter::Antialiasing);
    if (m_swing) {
        drawUnreliable(*painter, headingMap, canvas);
        drawSamples(*painter, headingMap, errorMap, canvas);
        drawCurve(*painter, headingMap, errorMap);
    }
    drawDots(*painter, headingMap, errorMap, canvas);
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
    for (const auto& [colour, width] :
         {std::pair(currentTheme().plotGround, kHalo), std::pair(currentTheme().accent, kCurveWidth)}) {
        painter.setPen(QPen(colour, width));
        painter.drawPolyline(curve);
    }
}

void SwingItem::drawDots(QPainter& painter, const QwtScaleMap& headingMap, const QwtScaleMap& errorMap,
                         const QRectF& canvas) const
{
    for (const calibration::SwingDot& dot : m_dots) {
        drawSample(painter, shapeOf(dot.isUsed, dot.turning == calibration::Turning::Clockwise),
                   {headingMap.transform(dot.heading.degrees()), heightOf(dot.error, errorMap, canvas)});
    }
}

// The residual of each sample as a line to the curve.
void SwingItem::drawSamples(QPainter& painter, const QwtScaleMap& headingMap, const QwtScaleMap& errorMap,
                            const QRectF& canvas) const
{
    for (const calibration::SwingResidual& one : m_swing->fit.samples) {
        const bool clockwise = one.sample >= m_swing->samples.size() ||
                               m_swing->samples[one.sample].turning == calibration::Turning::Clockwise;
        const double x = headingMap.transform(one.heading.wrapped360().degrees());
        const double y = heightOf(one.error, errorMap, canvas);
        painter.setPen(QPen(currentTheme().secondary, 0.7));
        painter.drawLine(QPointF(x, y), QPointF(x, heightOf(one.error - one.residual, errorMap, canvas)));
        drawSample(painter, shapeOf(one.fate == calibration::SampleFate::Used, clockwise), {x, y});
    }
}

}  // namespace boresight::ui
