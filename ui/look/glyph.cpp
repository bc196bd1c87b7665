// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/look/glyph.h"

#include "ui/kit/theme.h"

#include <QIconEngine>
#include <QPainter>
#include <QPainterPath>

#include <cmath>
#include <functional>
#include <numbers>
#include <utility>

namespace boresight::ui {

namespace {

constexpr double kStroke = 1.0 / 11.0;  // of the box: 1.5 px of 16

// Points in a box from 0 to 1.
class Pen
{
public:
    Pen(QPainter& painter, const QRectF& box, const QColor& colour) : m_painter(painter), m_box(box), m_colour(colour)
    {
        painter.setRenderHint(QPainter::Antialiasing);
        painter.setPen(QPen(colour, box.width() * kStroke, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
        painter.setBrush(Qt::NoBrush);
    }

    [[nodiscard]] QPointF at(double x, double y) const
    {
        return {m_box.left() + x * m_box.width(), m_box.top() + y * m_box.height()};
    }
    void line(std::initializer_list<QPointF> points)
    {
        QPolygonF polygon;
        for (const QPointF& point : points) {
            polygon << at(point.x(), point.y());
        }
        m_painter.drawPolyline(polygon);
    }
    void circle(double x, double y, double radius)
    {
        m_painter.drawEllipse(at(x, y), radius * m_box.width(), radius * m_box.height());
    }
    void dot(double x, double y, double radius)
    {
        m_painter.setBrush(m_colour);
        circle(x, y, radius);
        m_painter.setBrush(Qt::NoBrush);
    }
    void box(double left, double top, double right, double bottom)
    {
        m_painter.drawRoundedRect(QRectF(at(left, top), at(right, bottom)), 0.08 * m_box.width(),
                                  0.08 * m_box.height());
    }
    // Angles in degrees, counterclockwise from the right.
    void arc(double x, double y, double radius, int from, int span)
    {
        m_painter.drawArc(QRectF(at(x - radius, y - radius), at(x + radius, y + radius)), from * 16, span * 16);
    }
    void shape(const QPolygonF& corners, bool filled)
    {
        QPolygonF polygon;
        for (const QPointF& corner : corners) {
            polygon << at(corner.x(), corner.y());
        }
        m_painter.setBrush(filled ? QBrush(m_colour) : QBrush(Qt::NoBrush));
        m_painter.drawPolygon(polygon);
        m_painter.setBrush(Qt::NoBrush);
    }
    void letter(const QString& text)
    {
        QFont font = m_painter.font();
        font.setPixelSize(static_cast<int>(m_box.height() * 0.75));
        font.setBold(true);
        m_painter.setFont(font);
        m_painter.drawText(m_box, Qt::AlignCenter, text);
    }

private:
    QPainter& m_painter;
    QRectF m_box;
    QColor m_colour;
};

void drawJog(Pen& pen)
{
    pen.line({{0.5, 0.08}, {0.5, 0.92}});
    pen.line({{0.08, 0.5}, {0.92, 0.5}});
    pen.line({{0.36, 0.22}, {0.5, 0.08}, {0.64, 0.22}});
    pen.line({{0.36, 0.78}, {0.5, 0.92}, {0.64, 0.78}});
    pen.line({{0.22, 0.36}, {0.08, 0.5}, {0.22, 0.64}});
    pen.line({{0.78, 0.36}, {0.92, 0.5}, {0.78, 0.64}});
}

void drawPasses(Pen& pen)
{
    pen.line({{0.06, 0.86}, {0.94, 0.86}});
    pen.arc(0.5, 0.86, 0.42, 0, 180);
    pen.dot(0.8, 0.56, 0.12);
}

void drawCharts(Pen& pen)
{
    pen.line({{0.1, 0.08}, {0.1, 0.9}, {0.94, 0.9}});
    pen.line({{0.24, 0.68}, {0.42, 0.36}, {0.62, 0.56}, {0.88, 0.16}});
}

void drawLimits(Pen& pen)
{
    pen.line({{0.1, 0.32}, {0.1, 0.1}, {0.32, 0.1}});
    pen.line({{0.68, 0.1}, {0.9, 0.1}, {0.9, 0.32}});
    pen.line({{0.9, 0.68}, {0.9, 0.9}, {0.68, 0.9}});
    pen.line({{0.32, 0.9}, {0.1, 0.9}, {0.1, 0.68}});
    pen.dot(0.5, 0.5, 0.1);
}

void drawClients(Pen& pen)
{
    pen.line({{0.08, 0.34}, {0.9, 0.34}});
    pen.line({{0.72, 0.16}, {0.9, 0.34}});
    pen.line({{0.92, 0.66}, {0.1, 0.66}});
    pen.line({{0.28, 0.84}, {0.1, 0.66}});
}

void drawLog(Pen& pen)
{
    for (const auto& [y, end] : {std::pair(0.2, 0.9), std::pair(0.4, 0.7), std::pair(0.6, 0.9), std::pair(0.8, 0.55)}) {
        pen.line({{0.1, y}, {end, y}});
    }
}

void drawMount(Pen& pen)
{
    pen.arc(0.62, 0.3, 0.36, 165, 150);
    pen.line({{0.26, 0.22}, {0.72, 0.66}});
    pen.line({{0.48, 0.44}, {0.74, 0.18}});
    pen.line({{0.42, 0.54}, {0.42, 0.92}});
    pen.line({{0.2, 0.92}, {0.64, 0.92}});
}

void drawNorth(Pen& pen)
{
    pen.line({{0.5, 0.06}, {0.76, 0.92}, {0.5, 0.72}, {0.24, 0.92}, {0.5, 0.06}});
}

void drawBrightness(Pen& pen)
{
    pen.circle(0.5, 0.5, 0.2);
    for (const QPointF& way : {QPointF(1, 0), QPointF(-1, 0), QPointF(0, 1), QPointF(0, -1), QPointF(0.7, 0.7),
                               QPointF(-0.7, 0.7), QPointF(0.7, -0.7), QPointF(-0.7, -0.7)}) {
        pen.line({QPointF(0.5, 0.5) + 0.33 * way, QPointF(0.5, 0.5) + 0.45 * way});
    }
}

void drawLanguage(Pen& pen)
{
    pen.circle(0.5, 0.5, 0.42);
    pen.line({{0.08, 0.5}, {0.92, 0.5}});
    pen.line({{0.5, 0.08}, {0.34, 0.3}, {0.34, 0.7}, {0.5, 0.92}});
    pen.line({{0.5, 0.08}, {0.66, 0.3}, {0.66, 0.7}, {0.5, 0.92}});
}

void drawKeys(Pen& pen)
{
    pen.box(0.04, 0.22, 0.96, 0.78);
    for (const double x : {0.24, 0.5, 0.76}) {
        pen.dot(x, 0.42, 0.02);
    }
    pen.line({{0.3, 0.62}, {0.7, 0.62}});
}

void drawGuide(Pen& pen)
{
    for (const double y : {0.2, 0.5, 0.8}) {
        pen.line({{0.42, y}, {0.92, y}});
    }
    pen.line({{0.08, 0.2}, {0.16, 0.28}, {0.3, 0.1}});
    pen.line({{0.08, 0.5}, {0.16, 0.58}, {0.3, 0.4}});
    pen.circle(0.18, 0.8, 0.06);
}

void drawProfile(Pen& pen)
{
    for (const auto& [y, knob] : {std::pair(0.2, 0.66), std::pair(0.5, 0.3), std::pair(0.8, 0.56)}) {
        pen.line({{0.08, y}, {0.92, y}});
        pen.dot(knob, y, 0.09);
    }
}

void drawScreen(Pen& pen)
{
    pen.line({{0.1, 0.36}, {0.1, 0.1}, {0.36, 0.1}});
    pen.line({{0.64, 0.9}, {0.9, 0.9}, {0.9, 0.64}});
    pen.line({{0.14, 0.14}, {0.38, 0.38}});
    pen.line({{0.86, 0.86}, {0.62, 0.62}});
}

void drawDiagnostics(Pen& pen)
{
    pen.line({{0.5, 0.06}, {0.5, 0.62}});
    pen.line({{0.28, 0.42}, {0.5, 0.64}, {0.72, 0.42}});
    pen.line({{0.1, 0.66}, {0.1, 0.92}, {0.9, 0.92}, {0.9, 0.66}});
}

void drawMenu(Pen& pen)
{
    for (const double y : {0.24, 0.5, 0.76}) {
        pen.line({{0.12, y}, {0.88, y}});
    }
}

void drawAbout(Pen& pen)
{
    pen.circle(0.5, 0.5, 0.42);
    pen.dot(0.5, 0.28, 0.03);
    pen.line({{0.5, 0.46}, {0.5, 0.74}});
}

// Five points, the first at the top.
void drawStar(Pen& pen, bool filled)
{
    QPolygonF star;
    for (int corner = 0; corner < 10; ++corner) {
        const double angle = corner * std::numbers::pi / 5.0;
        const double radius = corner % 2 == 0 ? 0.46 : 0.2;
        star << QPointF(0.5 + radius * std::sin(angle), 0.53 - radius * std::cos(angle));
    }
    pen.shape(star, filled);
}

using Paint = std::function<void(QPainter& painter, const QRectF& box, QIcon::Mode mode)>;

// Nothing is cached, so the next picture has the colours of the current theme.
class PaintedIcon : public QIconEngine
{
public:
    explicit PaintedIcon(Paint paint) : m_paint(std::move(paint)) {}

    void paint(QPainter* painter, const QRect& rect, QIcon::Mode mode, QIcon::State) override
    {
        painter->save();
        m_paint(*painter, rect, mode);
        painter->restore();
    }
    QPixmap pixmap(const QSize& size, QIcon::Mode mode, QIcon::State state) override
    {
        if (size.isEmpty()) {
            return {};  // Qt asks for this while a button has no size
        }
        QPixmap pixmap(size);
        pixmap.fill(Qt::transparent);
        QPainter painter(&pixmap);
        paint(&painter, QRect(QPoint(), size), mode, state);
        return pixmap;
    }
    [[nodiscard]] QIconEngine* clone() const override { return new PaintedIcon(*this); }

private:
    Paint m_paint;
};

}  // namespace

void drawGlyph(QPainter& painter, Glyph glyph, const QRectF& box, const QColor& colour)
{
    Pen pen(painter, box, colour);
    switch (glyph) {
        case Glyph::Jog:
            return drawJog(pen);
        case Glyph::Passes:
            return drawPasses(pen);
        case Glyph::Charts:
            return drawCharts(pen);
        case Glyph::Limits:
            return drawLimits(pen);
        case Glyph::Clients:
            return drawClients(pen);
        case Glyph::Log:
            return drawLog(pen);
        case Glyph::Mount:
            return drawMount(pen);
        case Glyph::North:
            return drawNorth(pen);
        case Glyph::Question:
            return pen.letter(QStringLiteral("?"));
        case Glyph::Menu:
            return drawMenu(pen);
        case Glyph::Screen:
            return drawScreen(pen);
        case Glyph::Language:
            return drawLanguage(pen);
        case Glyph::Keys:
            return drawKeys(pen);
        case Glyph::Guide:
            return drawGuide(pen);
        case Glyph::Diagnostics:
            return drawDiagnostics(pen);
        case Glyph::Profile:
            return drawProfile(pen);
        case Glyph::About:
            return drawAbout(pen);
        case Glyph::Brightness:
            return drawBrightness(pen);
        case Glyph::Favourite:
            return drawStar(pen, true);
        case Glyph::NoFavourite:
            return drawStar(pen, false);
    }
}

QIcon glyphIcon(Glyph glyph)
{
    return QIcon(new PaintedIcon([glyph](QPainter& painter, const QRectF& box, QIcon::Mode mode) {
        const Theme& colours = currentTheme();
        const QColor& plain = glyph == Glyph::NoFavourite ? colours.secondary : colours.text;
        drawGlyph(painter, glyph, box,
                  mode == QIcon::Disabled   ? colours.hairline
                  : mode == QIcon::Selected ? colours.onAccent  // in a row of a table
                                            : plain);
    }));
}

QIcon themePicture(ThemeKind kind)
{
    return QIcon(new PaintedIcon([kind](QPainter& painter, const QRectF& box, QIcon::Mode) {
        const Theme& colours = theme(kind, currentBrightness());
        painter.setRenderHint(QPainter::Antialiasing);
        painter.setPen(currentTheme().secondary);
        painter.setBrush(colours.window);
        painter.drawRoundedRect(box.adjusted(0.5, 0.5, -0.5, -0.5), 3, 3);
        painter.setPen(Qt::NoPen);
        painter.setBrush(colours.accent);
        const double side = box.height();
        painter.drawEllipse(box.center() - QPointF(0.16 * side, 0.0), 0.22 * side, 0.22 * side);
        painter.setBrush(colours.text);
        painter.drawRect(QRectF(box.center() + QPointF(0.14 * side, -0.16 * side), QSizeF(0.26 * side, 0.1 * side)));
        painter.drawRect(QRectF(box.center() + QPointF(0.14 * side, 0.06 * side), QSizeF(0.18 * side, 0.1 * side)));
    }));
}

}  // namespace boresight::ui
