// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/cable_bar.h"

#include "ui/format.h"
#include "ui/theme.h"

#include <QPainter>

#include <cmath>

namespace boresight::ui {

namespace {

constexpr double kCap = 14.0;        // px of the hatched end
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
    const std::optional<Angle> actual = age == Freshness::NoData ? std::nullopt : axis.actual;
    const QString text = (actual ? angleText(*actual, 0) : noValue()) + tr(" of ") + rangeText(axis.travel);
    const bool late = age == Freshness::Late;
    if (text == m_text && late == m_late && axis.travel == m_travel && !changedByAPixel(actual, m_actual) &&
        !changedByAPixel(axis.commanded, m_commanded)) {
        return;
    }
    m_travel = axis.travel;
    m_actual = actual;
    m_commanded = axis.commanded;
    m_late = late;
    m_text = text;
    setAccessibleDescription(text);
    update();
}

QRectF CableBar::bar() const
{
    const double left = fontMetrics().horizontalAdvance(tr("AZ cable")) + 10.0 + kCap;
    const double right = fontMetrics().horizontalAdvance(QStringLiteral("-000° of -000° to 000°")) + 10.0 + kCap;
    return {left, 10.0, std::max(width() - left - right, 40.0), kThickness};
}

double CableBar::pixel(Angle angle) const
{
    const QRectF box = bar();
    return box.left() + (m_travel.clamped(angle) - m_travel.min) / (m_travel.max - m_travel.min) * box.width();
}

void CableBar::drawScale(QPainter& painter, const QRectF& box) const
{
    const Theme& colours = currentTheme();
    painter.fillRect(box, colours.plotGround);
    for (const QRectF& cap : {QRectF(box.left() - kCap, box.top(), kCap, box.height()),
                              QRectF(box.right(), box.top(), kCap, box.height())}) {
        painter.fillRect(cap, QBrush(colours.secondary, Qt::BDiagPattern));
    }
    painter.setPen(colours.secondary);
    painter.drawRect(box.adjusted(-kCap, 0, kCap, 0));
    const int first = static_cast<int>(std::ceil(m_travel.min.degrees() / 90.0));
    const int last = static_cast<int>(std::floor(m_travel.max.degrees() / 90.0));
    const int labelWidth = fontMetrics().horizontalAdvance(QStringLiteral("-000°"));
    for (int quarter = first; quarter <= last; ++quarter) {
        const Angle angle = 90_deg * quarter;
        const double x = pixel(angle);
        painter.drawLine(QPointF(x, box.top()), QPointF(x, box.bottom() + (quarter == 0 ? 4 : 2)));
        if (quarter % 2 == 0 || box.width() > 1.2 * labelWidth * (last - first + 1)) {
            painter.drawText(QRectF(x - labelWidth, box.bottom() + 2, 2.0 * labelWidth, fontMetrics().height()),
                             Qt::AlignHCenter | Qt::AlignTop, angleText(angle, 0));
        }
    }
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
    painter.setPen(m_late ? colours.secondary : colours.text);
    painter.drawText(words, Qt::AlignRight, m_text);
    if (m_travel.max <= m_travel.min) {
        return;  // no profile heard of yet
    }
    drawScale(painter, box);
    const QColor mark = m_late ? colours.secondary : colours.text;
    if (m_actual) {
        const double zero = pixel(0_deg);
        const double x = pixel(*m_actual);
        painter.fillRect(QRectF(QPointF(zero, box.center().y() - 1.5), QPointF(x, box.center().y() + 1.5)).normalized(),
                         colours.accent);
        painter.setPen(Qt::NoPen);
        painter.setBrush(mark);
        painter.drawPolygon(QPolygonF({QPointF(x - 6, 0.5), QPointF(x + 6, 0.5), QPointF(x, box.top() + 1)}));
    }
    if (m_commanded) {
        const double x = pixel(*m_commanded);
        painter.setPen(QPen(mark, 2.0, Qt::SolidLine, Qt::FlatCap));
        painter.drawLine(QPointF(x, box.top() - 2), QPointF(x, box.bottom() + 2));
    }
}

}  // namespace boresight::ui
