// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/sky/sky_frame.h"

#include "ui/kit/theme.h"

#include <QCoreApplication>
#include <QFontMetricsF>
#include <QPainter>

#include <algorithm>
#include <cmath>

namespace boresight::ui {

namespace {

constexpr double kShareOfSide = 0.0475;
constexpr double kLeastMargin = 24.0;  // px: room for a letter and two tracks of the ring
constexpr double kLabelGap = 5.0;      // px between the ring and the degrees
constexpr double kCornerGap = 4.0;     // px between the contents of a corner and the ring
constexpr double kEdge = 1.0;          // px

class SkyLabels
{
    Q_DECLARE_TR_FUNCTIONS(SkyLabels)
};

QString azimuthLabel(int degrees)
{
    switch (degrees) {
        case 0:
            return SkyLabels::tr("N");
        case 90:
            return SkyLabels::tr("E");
        case 180:
            return SkyLabels::tr("S");
        case 270:
            return SkyLabels::tr("W");
        default:
            return QString::number(degrees);
    }
}

QFont labelFont(int degrees)
{
    QFont font = fonts::label();
    font.setBold(degrees % 90 == 0);
    return font;
}

QPointF outwards(int degrees)
{
    const double azimuth = Angle::fromDegrees(degrees).radians();
    return {std::sin(azimuth), -std::cos(azimuth)};
}

}  // namespace

double SkyFrame::margin(double side)
{
    return std::max(kLeastMargin, kShareOfSide * side);
}

SkyFrame::SkyFrame(const QRectF& view, const SkyProjection& sky)
    : m_view(view), m_sky(sky), m_margin(margin(std::min(view.width(), view.height())))
{
    for (int degrees = 0; degrees < 360; degrees += 30) {
        m_labels.push_back({labelBox(degrees), degrees});
    }
}

// As tight as the glyphs. Letters are at the edge of the square. Degrees are beside the ring, where the square is wider
// than the disc.
QRectF SkyFrame::labelBox(int degrees) const
{
    const QFontMetricsF metrics(labelFont(degrees));
    const QString text = azimuthLabel(degrees);
    QRectF box(0, 0, metrics.horizontalAdvance(text), metrics.capHeight() + 1.0);
    const QPointF away = outwards(degrees);
    const double half = std::abs(away.x()) * box.width() / 2.0 + std::abs(away.y()) * box.height() / 2.0;
    const double distance = degrees % 90 == 0 ? m_sky.radius + m_margin - kEdge - half
                                              : outerTrack() + widestTrack() / 2.0 + kLabelGap + half;
    box.moveCenter(m_sky.zenith + distance * away);
    return box;
}

bool SkyFrame::isFree(const QRectF& box) const
{
    const QPointF nearest(std::clamp(m_sky.zenith.x(), box.left(), box.right()),
                          std::clamp(m_sky.zenith.y(), box.top(), box.bottom()));
    const QPointF away = nearest - m_sky.zenith;
    return std::hypot(away.x(), away.y()) > outerTrack() + kCornerGap &&
           std::ranges::none_of(m_labels, [&](const Label& label) { return label.box.intersects(box); });
}

double SkyFrame::freeWidth(SkyCorner corner, double from, double to) const
{
    const bool left = corner == SkyCorner::UpperLeft || corner == SkyCorner::LowerLeft;
    const bool upper = corner == SkyCorner::UpperLeft || corner == SkyCorner::UpperRight;
    const double top = upper ? m_view.top() + from : m_view.bottom() - to;
    double width = 0.0;
    for (double wanted = 1.0; wanted < m_view.width() / 2.0; wanted += 1.0) {
        if (!isFree({left ? m_view.left() : m_view.right() - wanted, top, wanted, to - from})) {
            break;
        }
        width = wanted;
    }
    return width;
}

void SkyFrame::paint(QPainter& painter) const
{
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    paintTicks(painter);
    for (const Label& label : m_labels) {
        const QFont font = labelFont(label.degrees);
        painter.setFont(font);
        painter.setPen(label.degrees % 90 == 0 ? currentTheme().text : currentTheme().secondary);
        painter.drawText(label.box.bottomLeft() - QPointF(0.0, 0.5), azimuthLabel(label.degrees));
    }
    painter.restore();
}

void SkyFrame::paintTicks(QPainter& painter) const
{
    painter.setPen(QPen(currentTheme().secondary, 1.0));
    for (int degrees = 0; degrees < 360; degrees += 10) {
        const double length = (degrees % 30 == 0 ? 0.17 : 0.1) * m_margin;
        const QPointF away = outwards(degrees);
        painter.drawLine(m_sky.zenith + m_sky.radius * away, m_sky.zenith + (m_sky.radius + length) * away);
    }
}

}  // namespace boresight::ui
