// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plan/plan_chart.h"

#include "ui/kit/format.h"
#include "ui/kit/theme.h"
#include "ui/plan/variant_words.h"
#include "ui/sky/sky_text.h"

#include <QPainter>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>

namespace boresight::ui {

namespace {

constexpr double kPlanLine = 2.0;      // px
constexpr double kEndBand = 4.0;       // px, beyond each end of the cable
constexpr double kBetweenLanes = 6.0;  // px
constexpr double kErrorPart = 0.42;    // of the height
constexpr double kErrorTops[] = {0.1, 0.2, 0.5, 1.0, 2.0, 5.0, 10.0, 20.0, 50.0, 90.0, 180.0};  // degrees
// An unwrap is off by tens of beam widths. The scale ends at this number of bounds, so that the bound is visible.
constexpr double kMostBounds = 4.0;
constexpr double kAboveTheCurve = 1.15;

// Highest first: a value on the scale of degrees, without needless decimals.
QString scaleText(Angle angle)
{
    return angleText(angle, angle < 1_deg && angle > 0_deg ? 1 : 0);
}

}  // namespace

PlanChart::PlanChart(QWidget* parent) : QWidget(parent)
{
    setFont(fonts::label());
    setAccessibleName(tr("The planned motion over time"));
    setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Expanding);
}

void PlanChart::show(const plan::SharedVariant& variant, const TravelRange& azimuths, Angle bound, const QString& words)
{
    m_variant = variant && variant->moments.size() > 1 ? variant : nullptr;
    m_azimuths = azimuths;
    m_bound = bound;
    m_words = words;
    setAccessibleDescription(m_variant ? describedVariant(*m_variant, azimuths) : words);
    update();
}

void PlanChart::setNow(UtcTime now)
{
    m_now = now;
    if (m_variant) {
        update();
    }
}

QRectF PlanChart::canvas() const
{
    const double left = std::max(fontMetrics().horizontalAdvance(angleText(m_azimuths.min, 0)),
                                 fontMetrics().horizontalAdvance(angleText(m_azimuths.max, 0))) +
                        8.0;
    return QRectF(rect()).adjusted(left, 2.0, -14.0, -fontMetrics().height() - 10.0);
}

QRectF PlanChart::errorLane() const
{
    QRectF lane = canvas();
    lane.setTop(lane.bottom() - kErrorPart * lane.height());
    return lane;
}

QRectF PlanChart::azimuthLane() const
{
    QRectF lane = canvas();
    lane.setBottom(errorLane().top() - kBetweenLanes);
    return lane.adjusted(0.0, kEndBand, 0.0, -kEndBand);
}

PassTimeAxis PlanChart::timeAxis() const
{
    return {.first = m_variant->moments.front().utc,
            .last = m_variant->moments.back().utc,
            .canvas = canvas(),
            .room = double(width())};
}

double PlanChart::xOf(UtcTime utc) const
{
    return timeAxis().pixelOf(utc);
}

double PlanChart::yOfAzimuth(Angle azimuth) const
{
    const QRectF lane = azimuthLane();
    return lane.bottom() - lane.height() * ((azimuth - m_azimuths.min) / (m_azimuths.max - m_azimuths.min));
}

double PlanChart::yOfError(Angle error) const
{
    const QRectF lane = errorLane();
    return lane.bottom() - lane.height() * std::min(error / errorTop(), 1.0);
}

Angle PlanChart::errorTop() const
{
    const Angle most =
        m_variant ? std::min(std::max(m_variant->forecast.peak, m_bound), kMostBounds * m_bound) : m_bound;
    const auto* const found =
        std::ranges::find_if(kErrorTops, [&](double top) { return top >= kAboveTheCurve * most.degrees(); });
    return Angle::fromDegrees(found == std::end(kErrorTops) ? *(found - 1) : *found);
}

std::vector<plan::PlanSpan> PlanChart::hiddenSpans() const
{
    std::vector<plan::PlanSpan> spans;
    bool isInside = false;
    for (std::size_t i = 0; m_variant && i < m_variant->moments.size(); ++i) {
        const plan::PlannedMoment& moment = m_variant->moments[i];
        if (moment.isHidden && !isInside) {
            spans.push_back({.from = moment.utc, .to = moment.utc});
        }
        if (moment.isHidden || isInside) {
            spans.back().to = moment.utc;
        }
        isInside = moment.isHidden;
    }
    return spans;
}

QPainterPath PlanChart::azimuthLine() const
{
    QPainterPath path;
    for (std::size_t i = 0; m_variant && i < m_variant->moments.size(); ++i) {
        const plan::PlannedMoment& moment = m_variant->moments[i];
        const QPointF pixel(xOf(moment.utc), yOfAzimuth(moment.axes.azimuth));
        i == 0 ? path.moveTo(pixel) : path.lineTo(pixel);
    }
    return path;
}

QPainterPath PlanChart::errorLine() const
{
    QPainterPath path;
    bool isDrawing = false;
    for (std::size_t i = 0; m_variant && i < m_variant->moments.size(); ++i) {
        const plan::PlannedMoment& moment = m_variant->moments[i];
        const QPointF pixel(xOf(moment.utc), yOfError(moment.error));
        if (!moment.isHidden) {
            isDrawing ? path.lineTo(pixel) : path.moveTo(pixel);
        }
        isDrawing = !moment.isHidden;
    }
    return path;
}

QRectF PlanChart::boxOf(const plan::PlanSpan& span) const
{
    const QRectF box = canvas();
    return {QPointF(xOf(span.from), box.top()), QPointF(xOf(span.to), box.bottom())};
}

void PlanChart::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    const Theme& colours = currentTheme();
    painter.setFont(font());
    painter.fillRect(rect(), colours.plotGround);
    if (!m_variant) {
        painter.setPen(colours.secondary);
        painter.drawText(QRectF(rect()).adjusted(kGrid, 0.0, -kGrid, 0.0), Qt::AlignCenter | Qt::TextWordWrap, m_words);
        return;
    }
    paintSpans(painter);
    timeAxis().paint(painter);
    paintCableEnds(painter);
    paintScales(painter);
    painter.setRenderHint(QPainter::Antialiasing);
    paintLines(painter);
    paintNames(painter);
}

void PlanChart::paintSpans(QPainter& painter) const
{
    const Theme& colours = currentTheme();
    for (const auto& span : {m_variant->ramp, m_variant->unwrap}) {
        if (span) {
            painter.fillRect(boxOf(*span), colours.accentSoft);
        }
    }
    QColor hatching = colours.secondary;
    hatching.setAlphaF(0.7F);
    for (const plan::PlanSpan& span : hiddenSpans()) {
        painter.fillRect(boxOf(span), QBrush(hatching, Qt::BDiagPattern));
    }
}

// Beyond its ends the cable has no room: hatched as on the ring of the sky.
void PlanChart::paintCableEnds(QPainter& painter) const
{
    const QRectF lane = azimuthLane();
    const QRectF above(lane.left(), lane.top() - kEndBand, lane.width(), kEndBand);
    const QRectF below(lane.left(), lane.bottom(), lane.width(), kEndBand);
    for (const QRectF& band : {above, below}) {
        painter.fillRect(band, currentTheme().band);
        painter.fillRect(band, QBrush(currentTheme().secondary, Qt::FDiagPattern));
    }
}

void PlanChart::paintScales(QPainter& painter) const
{
    const Theme& colours = currentTheme();
    const double half = fontMetrics().height() / 2.0;
    const QRectF box = canvas();
    const auto label = [&](double y, const QString& text) {
        const double top = std::clamp(y - half, 0.0, height() - 2.0 * half);
        painter.setPen(colours.secondary);
        painter.drawText(QRectF(0.0, top, box.left() - 4.0, 2.0 * half), Qt::AlignRight | Qt::AlignVCenter, text);
    };
    const auto line = [&](double y) {
        painter.setPen(colours.grid);
        painter.drawLine(QPointF(box.left(), std::round(y) + 0.5), QPointF(box.right(), std::round(y) + 0.5));
    };
    const QRectF azimuths = azimuthLane();
    const QRectF errors = errorLane();
    line(azimuths.top());
    line(azimuths.bottom());
    label(azimuths.top() + half - kEndBand, angleText(m_azimuths.max, 0));
    if (azimuths.height() > 3.0 * half) {
        label(azimuths.bottom() - half + kEndBand, angleText(m_azimuths.min, 0));
    }
    line(errors.top());
    line(errors.bottom());
    label(errors.top() + half, scaleText(errorTop()));
    if (errors.height() > 4.0 * half) {
        label(errors.bottom() - half, scaleText(0_deg));
    }
}

void PlanChart::paintLines(QPainter& painter) const
{
    const Theme& colours = currentTheme();
    const QRectF box = canvas();
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(colours.secondary, 1.0, Qt::DashLine));
    painter.drawLine(QPointF(box.left(), yOfError(m_bound)), QPointF(box.right(), yOfError(m_bound)));
    painter.setPen(QPen(colours.accent, kPlanLine));
    painter.drawPath(azimuthLine());
    painter.setPen(QPen(colours.text, 1.5));
    painter.drawPath(errorLine());
    if (m_now > m_variant->moments.front().utc && m_now < m_variant->moments.back().utc) {
        painter.drawLine(QPointF(xOf(m_now), box.top()), QPointF(xOf(m_now), box.bottom()));
    }
}

void PlanChart::paintNames(QPainter& painter) const
{
    const Theme& colours = currentTheme();
    const auto name = [&](double x, double y, const QString& text, const QColor& colour) {
        const QSizeF size(fontMetrics().horizontalAdvance(text) + 4.0, fontMetrics().height());
        const double left = std::clamp(x, canvas().left(), std::max(canvas().right() - size.width(), canvas().left()));
        drawOutlinedText(painter, {QPointF(left, y), size}, text, colour, colours.plotGround);
    };
    const double end = canvas().right();
    name(end, azimuthLane().top() - 2.0, tr("azimuth"), colours.accent);
    name(end, errorLane().top() - 2.0, tr("error up to %1").arg(angleText(m_variant->forecast.peak)), colours.text);
    const double low = azimuthLane().bottom() - fontMetrics().height();
    if (m_variant->ramp) {
        name(xOf(m_variant->ramp->from), low, tr("ramp"), colours.secondary);
    }
    if (m_variant->unwrap) {
        name(xOf(m_variant->unwrap->from), low, tr("unwrap"), colours.secondary);
    }
    if (const auto hidden = hiddenSpans(); !hidden.empty()) {
        name(xOf(hidden.front().from), low, tr("hidden"), colours.secondary);
    }
}

}  // namespace boresight::ui

#include "moc_plan_chart.cpp"
