// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/guide/step_picture.h"

#include "ui/kit/theme.h"

#include <QPainter>
#include <QPolygonF>

namespace boresight::ui {

namespace {

constexpr QSize kSceneSize(84, 54);  // px, as high as three lines of text

QString sceneText(StepPicture::Scene scene)
{
    switch (scene) {
        case StepPicture::Scene::Level:
            return StepPicture::tr("A spirit level lies on the antenna. Its bubble is in the middle: elevation 0°");
        case StepPicture::Scene::Travel:
            return StepPicture::tr("The axis turns between two ends. The cable turns with it");
        case StepPicture::Scene::North:
            break;
    }
    return StepPicture::tr(
        "Seen from above: the antenna points at a landmark. Its bearing counts clockwise from north");
}

void drawTip(QPainter& painter, QPointF tip, QPointF back, double half)
{
    const QPointF across(-(tip - back).y() * half, (tip - back).x() * half);
    painter.drawPolygon(QPolygonF({tip, back + across, back - across}));
}

}  // namespace

StepPicture::StepPicture(Scene scene, QWidget* parent) : QWidget(parent), m_scene(scene)
{
    setFont(fonts::label());
    setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
    setAccessibleName(tr("Picture of this step"));
    setAccessibleDescription(sceneText(scene));
    setToolTip(sceneText(scene));
}

QSize StepPicture::sizeHint() const
{
    return kSceneSize;
}

void StepPicture::paintEvent(QPaintEvent* /*event*/)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    switch (m_scene) {
        case Scene::Level:
            return drawLevel(painter);
        case Scene::Travel:
            return drawTravel(painter);
        case Scene::North:
            return drawNorth(painter);
    }
}

// Side view: the mast, the boom with its elements, and the spirit level on the boom.
void StepPicture::drawLevel(QPainter& painter)
{
    const Theme& theme = currentTheme();
    painter.setPen(QPen(theme.secondary, 3, Qt::SolidLine, Qt::FlatCap));
    painter.drawLine(QPointF(42, 52), QPointF(42, 32));
    painter.setPen(QPen(theme.text, 2));
    painter.drawLine(QPointF(6, 32), QPointF(78, 32));
    for (const double x : {10.0, 26.0, 58.0, 74.0}) {
        painter.drawLine(QPointF(x, 25), QPointF(x, 39));
    }
    painter.setPen(QPen(theme.accent, 1.5));
    painter.drawRoundedRect(QRectF(22, 8, 40, 14), 3, 3);
    painter.drawLine(QPointF(35, 8), QPointF(35, 22));
    painter.drawLine(QPointF(49, 8), QPointF(49, 22));
    painter.setBrush(theme.accent);
    painter.drawEllipse(QPointF(42, 15), 4, 4);
}

// Top view: the travel between the ends, and the cable that is wound by the axis.
void StepPicture::drawTravel(QPainter& painter)
{
    const Theme& theme = currentTheme();
    const QRectF circle(19, 7, 46, 46);
    painter.setPen(QPen(theme.secondary, 1.5));
    painter.drawArc(QRectF(32, 20, 20, 20), 100 * 16, 320 * 16);  // the cable, a spiral that is not closed
    painter.drawArc(QRectF(35, 23, 14, 14), 60 * 16, 300 * 16);
    painter.setPen(QPen(theme.accent, 2));
    painter.drawArc(circle, -30 * 16, 240 * 16);
    painter.setBrush(theme.accent);
    drawTip(painter, QPointF(61, 43), QPointF(65, 34), 0.5);
    drawTip(painter, QPointF(23, 43), QPointF(19, 34), 0.5);
    painter.setPen(QPen(theme.text, 4, Qt::SolidLine, Qt::FlatCap));
    painter.drawLine(QPointF(57, 47), QPointF(68, 47));
    painter.drawLine(QPointF(16, 47), QPointF(27, 47));
}

void StepPicture::drawNorth(QPainter& painter)
{
    const Theme& theme = currentTheme();
    const QPointF mast(32, 42);
    painter.setPen(QPen(theme.secondary, 1.5));
    painter.drawLine(mast, QPointF(32, 15));
    painter.setPen(theme.text);
    painter.drawText(QRectF(22, 0, 20, 16), Qt::AlignCenter, tr("N"));
    painter.setPen(QPen(theme.text, 3));
    painter.drawLine(mast, QPointF(62, 24));
    painter.setPen(QPen(theme.accent, 1.5));
    painter.drawArc(QRectF(14, 24, 36, 36), 31 * 16, 59 * 16);
    painter.setBrush(theme.accent);
    drawTip(painter, QPointF(48, 33), QPointF(43, 27), 0.5);
    painter.setPen(QPen(theme.text, 1.5));
    painter.setBrush(Qt::NoBrush);
    painter.drawPolygon(QPolygonF({QPointF(74, 8), QPointF(80, 28), QPointF(68, 28)}));  // a tower
    painter.setBrush(theme.text);
    painter.drawEllipse(mast, 3, 3);
}

}  // namespace boresight::ui

#include "moc_step_picture.cpp"
