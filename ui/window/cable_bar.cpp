// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/cable_bar.h"

#include "ui/kit/axes.h"
#include "ui/kit/format.h"
#include "ui/kit/theme.h"
#include "ui/kit/travel_scale.h"

#include <QPainter>

namespace boresight::ui {

namespace {

constexpr double kThickness = 10.0;  // px

QString rangeText(const TravelRange& travel)
{
    return CableBar::tr("%1 to %2").arg(angleText(travel.min, 0), angleText(travel.max, 0));
}

bool changedByAPixel(const std::optional<Angle>& a, const std::optional<Angle>& b)
{
    return a.has_value() != b.has_value() || (a && abs(*a - *b) > Angle::fromDegrees(0.2));
}

}  // namespace

CableBar::CableBar(QWidget* parent) : QWidget(parent)
{
    setFont(fonts::label());
    setAccessibleName(tr("Azimuth cable"));
    setToolTip(
        tr("How far the azimuth cable is wound: 0° is not wound, the hatched ends are out of travel.\n"
           "▼ actual, | commanded"));
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
}

QSize CableBar::sizeHint() const
{
    return {320, fontMetrics().lineSpacing() + 22};
}

void CableBar::showStatus(const StationStatus& status)
{
    const AxisStatus& axis = status.azimuth;
    const Freshness age = freshness(axis.age);
    const bool known = isTurnKnown(status, Axis::Azimuth);
    const std::optional<Angle> actual = age == Freshness::NoData || !known ? std::nullopt : axis.actual;
    const std::optional<Angle> commanded = known ? axis.commanded : std::nullopt;
    const bool mute = age == Freshness::NoData || isTurnAwaited(status, Axis::Azimuth);
    const QString place = actual ? angleText(*actual, 0) : mute ? noValue() : tr("TURN?");
    const bool ends = actual && status.cableEnd;
    const QString text = ends ? tr("▲ %1 ends in %2").arg(place, waitText(status.cableEnd->in))
                              : tr("%1 of %2").arg(place, rangeText(axis.travel));
    const bool late = age == Freshness::Late;
    if (text == m_text && late == m_late && axis.travel == m_travel && !changedByAPixel(actual, m_actual) &&
        !changedByAPixel(commanded, m_commanded)) {
        return;
    }
    m_travel = axis.travel;
    m_actual = actual;
    m_commanded = commanded;
    m_late = late;
    m_ends = ends;
    m_text = text;
    setAccessibleDescription(text);
    update();
}

QRectF CableBar::bar() const
{
    const double left = fontMetrics().horizontalAdvance(tr("AZ cable")) + 10.0 + TravelScale::kCap;
    const double right =
        fontMetrics().horizontalAdvance(tr("%1 of %2").arg(QStringLiteral("-000°"), rangeText({-888_deg, 888_deg}))) +
        10.0 + TravelScale::kCap;
    return {left, 10.0, std::max(width() - left - right, 40.0), kThickness};
}

void CableBar::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const Theme& colours = currentTheme();
    const QRectF box = bar();
    const QRectF words(0, box.center().y() - fontMetrics().height() / 2.0, width(), fontMetrics().height());
    painter.setPen(colours.secondary);
    painter.drawText(words, Qt::AlignLeft, tr("AZ cable"));
    painter.setPen(m_ends ? colours.warning : m_late ? colours.secondary : colours.text);
    painter.drawText(words, Qt::AlignRight, m_text);
    const TravelScale scale(m_travel, box);
    if (scale.isEmpty()) {
        return;
    }
    scale.draw(painter);
    const QColor mark = m_late ? colours.secondary : colours.text;
    if (m_actual) {
        const double zero = scale.pixel(0_deg);
        const double x = scale.pixel(*m_actual);
        painter.fillRect(QRectF(QPointF(zero, box.center().y() - 1.5), QPointF(x, box.center().y() + 1.5)).normalized(),
                         colours.accent);
        painter.setPen(Qt::NoPen);
        painter.setBrush(mark);
        painter.drawPolygon(QPolygonF({QPointF(x - 6, 0.5), QPointF(x + 6, 0.5), QPointF(x, box.top() + 1)}));
    }
    if (m_commanded) {
        const double x = scale.pixel(*m_commanded);
        painter.setPen(QPen(mark, 2.0, Qt::SolidLine, Qt::FlatCap));
        painter.drawLine(QPointF(x, box.top() - 2), QPointF(x, box.bottom() + 2));
    }
}

}  // namespace boresight::ui

#include "moc_cable_bar.cpp"
