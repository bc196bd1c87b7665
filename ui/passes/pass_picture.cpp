// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/passes/pass_picture.h"

#include "ui/kit/format.h"
#include "ui/kit/theme.h"
#include "ui/sky/sky_projection.h"

#include <QPainter>

namespace boresight::ui {

namespace {

constexpr int kUsualSize = 132;  // px
constexpr double kDot = 2.0;     // px
constexpr double kEndMark = 3.5;

SkyProjection projectionOf(const QWidget& picture)
{
    const double letters = picture.fontMetrics().height();
    const QRectF box = picture.rect();
    return {.zenith = box.center(), .radius = std::min(box.width(), box.height()) / 2.0 - letters};
}

void paintSky(QPainter& painter, const SkyProjection& sky)
{
    const Theme& colours = currentTheme();
    painter.setPen(QPen(colours.grid, 1.0));
    painter.setBrush(colours.plotGround);
    painter.drawEllipse(sky.zenith, sky.radius, sky.radius);
    painter.setBrush(Qt::NoBrush);
    for (const double part : {1.0 / 3.0, 2.0 / 3.0}) {
        painter.drawEllipse(sky.zenith, sky.radius * part, sky.radius * part);
    }
    const double letters = painter.fontMetrics().height();
    painter.setPen(colours.secondary);
    const std::pair<QString, Angle> sides[] = {{PassPicture::tr("N"), 0_deg},
                                               {PassPicture::tr("E"), 90_deg},
                                               {PassPicture::tr("S"), 180_deg},
                                               {PassPicture::tr("W"), 270_deg}};
    for (const auto& [letter, azimuth] : sides) {
        const QPointF rim = sky.toPixel({.azimuth = azimuth, .elevation = 0_deg});
        const QPointF away = (rim - sky.zenith) / sky.radius;
        const QPointF middle = rim + away * letters / 2.0;
        painter.drawText(QRectF(middle - QPointF(letters, letters) / 2.0, QSizeF(letters, letters)), Qt::AlignCenter,
                         letter);
    }
}

void paintPath(QPainter& painter, const SkyProjection& sky, const PassPath& path)
{
    const Theme& colours = currentTheme();
    for (std::size_t i = 1; i < path.points.size(); ++i) {
        const bool hidden = path.points[i].isHidden;
        painter.setPen(QPen(hidden ? colours.secondary : colours.accent, hidden ? 1.0 : 2.0,
                            hidden ? Qt::DotLine : Qt::SolidLine));
        painter.drawLine(sky.toPixel(path.points[i - 1].direction), sky.toPixel(path.points[i].direction));
    }
    painter.setPen(Qt::NoPen);
    painter.setBrush(colours.accent);
    for (const PathPoint& mark : path.marks) {
        painter.drawEllipse(sky.toPixel(mark.direction), kDot, kDot);
    }
}

// Its time stands inside the sky, beside where it happens.
void paintEnd(QPainter& painter, const SkyProjection& sky, const PathPoint& end, bool rises)
{
    const Theme& colours = currentTheme();
    const QPointF at = sky.toPixel(end.direction);
    painter.setPen(QPen(colours.accent, 1.5));
    painter.setBrush(rises ? colours.accent : colours.plotGround);
    painter.drawEllipse(at, kEndMark, kEndMark);
    const QString text = clockText(end.utc).chopped(3);  // to the minute
    const QFontMetrics metrics = painter.fontMetrics();
    const QSizeF size(metrics.horizontalAdvance(text) + 2, metrics.height());
    const double side = at.x() < sky.zenith.x() ? kEndMark + 2.0 : -kEndMark - 2.0 - size.width();
    painter.setPen(colours.text);
    painter.drawText(QRectF(at + QPointF(side, -size.height() / 2.0), size), Qt::AlignCenter, text);
}

}  // namespace

PassPicture::PassPicture(QWidget* parent) : QWidget(parent)
{
    setFont(fonts::label());
    setAccessibleName(tr("Picture of the pass"));
    setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
}

QSize PassPicture::sizeHint() const
{
    return {kUsualSize, kUsualSize};
}

void PassPicture::show(const PassPath& path)
{
    m_path = path;
    update();
}

void PassPicture::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const SkyProjection sky = projectionOf(*this);
    paintSky(painter, sky);
    if (m_path.points.empty()) {
        return;
    }
    paintPath(painter, sky, m_path);
    paintEnd(painter, sky, m_path.points.front(), true);
    paintEnd(painter, sky, m_path.points.back(), false);
}

}  // namespace boresight::ui

#include "moc_pass_picture.cpp"
