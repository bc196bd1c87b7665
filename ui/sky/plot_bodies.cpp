// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/sky/plot_bodies.h"

#include "core/units/angle_between.h"
#include "ui/kit/theme.h"
#include "ui/sky/sky_text.h"

#include <QCoreApplication>
#include <QFontMetricsF>
#include <QPainter>
#include <QPainterPath>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace boresight::ui {

namespace {

constexpr double kBodyRadius = 7.0;  // px
constexpr double kNameGap = 5.0;
constexpr Angle kSamePlace = Angle::fromDegrees(0.1);

class PlotBodies
{
    Q_DECLARE_TR_FUNCTIONS(SkyBodies)
};

QString bodyName(ephemeris::Body body)
{
    return body == ephemeris::Body::Sun ? PlotBodies::tr("Sun") : PlotBodies::tr("Moon");
}

// Beside the symbol, on the side towards the zenith, so that the name stays on the disc.
QRectF nameBox(const BodyPlace& body, const SkyProjection& sky)
{
    const QFontMetricsF metrics(fonts::label());
    const QPointF at = sky.toPixel(body.direction);
    QRectF box(0, 0, metrics.horizontalAdvance(bodyName(body.body)), metrics.height());
    const double away = kBodyRadius + kNameGap + box.width() / 2.0;
    box.moveCenter(at + QPointF(at.x() > sky.zenith.x() ? -away : away, 0.0));
    return box;
}

void paintSun(QPainter& painter, QPointF at)
{
    const QColor colour = currentTheme().sun;
    painter.setPen(Qt::NoPen);
    painter.setBrush(colour);
    painter.drawEllipse(at, kBodyRadius * 0.65, kBodyRadius * 0.65);
    painter.setPen(QPen(colour, 1.5));
    for (int ray = 0; ray < 8; ++ray) {
        const double angle = ray * std::numbers::pi / 4.0;
        const QPointF away(std::cos(angle), std::sin(angle));
        painter.drawLine(at + away * kBodyRadius * 0.9, at + away * kBodyRadius * 1.25);
    }
}

void paintMoon(QPainter& painter, QPointF at)
{
    QPainterPath disc;
    disc.addEllipse(at, kBodyRadius, kBodyRadius);
    QPainterPath shadow;
    shadow.addEllipse(at + QPointF(kBodyRadius * 0.55, -kBodyRadius * 0.25), kBodyRadius * 0.85, kBodyRadius * 0.85);
    painter.setPen(Qt::NoPen);
    painter.setBrush(currentTheme().secondary);
    painter.drawPath(disc.subtracted(shadow));
}

}  // namespace

std::vector<BodyPlace> bodiesInTheSky(const std::vector<BodyPlace>& shown, const std::vector<BodyPlace>& now)
{
    std::vector<BodyPlace> bodies;
    for (const BodyPlace& one : now) {
        if (one.direction.elevation < 0_deg) {
            continue;
        }
        const auto before = std::ranges::find(shown, one.body, &BodyPlace::body);
        const bool same = before != shown.end() && angleBetween(before->direction, one.direction) < kSamePlace;
        bodies.push_back(same ? *before : one);
    }
    return bodies;
}

QRectF bodyBox(const BodyPlace& body, const SkyProjection& sky)
{
    const double half = kBodyRadius * 1.25 + 1.0;
    const QPointF at = sky.toPixel(body.direction);
    return QRectF(at.x() - half, at.y() - half, 2.0 * half, 2.0 * half) |
           nameBox(body, sky).adjusted(-3.0, -2.0, 3.0, 2.0);
}

void paintBody(QPainter& painter, const BodyPlace& body, const SkyProjection& sky)
{
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setFont(fonts::label());
    const QPointF at = sky.toPixel(body.direction);
    if (body.body == ephemeris::Body::Sun) {
        paintSun(painter, at);
    } else {
        paintMoon(painter, at);
    }
    drawOutlinedText(painter, nameBox(body, sky), bodyName(body.body), currentTheme().secondary, currentTheme().skyRim);
    painter.restore();
}

}  // namespace boresight::ui
