// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/report/report_sky.h"

#include "core/base/text.h"
#include "ui/report/paper_text.h"

#include <QPainterPath>
#include <QPolygonF>

#include <algorithm>
#include <cmath>

namespace boresight::ui {

namespace {

constexpr qreal kAroundDisc = 44.0;
constexpr qreal kLegendHeight = 40.0;

struct PaperDisc
{
    QPointF centre;
    qreal radius;

    [[nodiscard]] QPointF at(const SkyPointing& direction) const
    {
        // A target below the horizon stands just outside of the disc.
        const double share = std::min((90.0 - direction.elevation.degrees()) / 90.0, 1.05);
        const double azimuth = direction.azimuth.radians();
        return centre + radius * share * QPointF(std::sin(azimuth), -std::cos(azimuth));
    }
};

void drawGrid(QPainter& painter, const PaperDisc& disc)
{
    painter.setBrush(Qt::NoBrush);
    painter.setPen(paperPen(kPaperGrid, 1.5));
    for (const double share : {1.0 / 3.0, 2.0 / 3.0}) {
        painter.drawEllipse(disc.centre, disc.radius * share, disc.radius * share);
    }
    for (int azimuth = 0; azimuth < 360; azimuth += 30) {
        painter.drawLine(disc.at({Angle::fromDegrees(azimuth), Angle::fromDegrees(80.0)}),
                         disc.at({Angle::fromDegrees(azimuth), Angle()}));
    }
    painter.setPen(paperPen(kFaintInk, 2.0));
    painter.drawEllipse(disc.centre, disc.radius, disc.radius);
}

void drawLabels(QPainter& painter, const PaperDisc& disc)
{
    const auto label = [&](double azimuth, const QString& text, bool isBold) {
        const double radians = Angle::fromDegrees(azimuth).radians();
        const QPointF place =
            disc.centre + (disc.radius + 0.5 * kAroundDisc) * QPointF(std::sin(radians), -std::cos(radians));
        drawPaperText(painter, {place.x() - 35.0, place.y() - 18.0, 70.0, 36.0},
                      {.text = text,
                       .size = kSmallLetters,
                       .colour = isBold ? kInk : kFaintInk,
                       .isBold = isBold,
                       .alignment = Qt::AlignCenter});
    };
    label(0.0, Text::tr("N"), true);
    label(90.0, Text::tr("E"), true);
    label(180.0, Text::tr("S"), true);
    label(270.0, Text::tr("W"), true);
    for (const int azimuth : {30, 60, 120, 150, 210, 240, 300, 330}) {
        label(azimuth, QString::number(azimuth), false);
    }
    for (const int elevation : {30, 60}) {
        const QPointF place = disc.at({Angle(), Angle::fromDegrees(elevation)});
        drawPaperText(painter, {place.x() + 5.0, place.y() - 30.0, 60.0, 28.0},
                      {.text = QStringLiteral("%1°").arg(elevation), .size = kSmallLetters - 4, .colour = kFaintInk});
    }
}

void drawSkyLine(QPainter& painter, const PaperDisc& disc, const pass_report::SkyLine& line, const QPen& pen)
{
    painter.setPen(pen);
    painter.setBrush(Qt::NoBrush);
    for (const auto& piece : line) {
        QPolygonF way;
        for (const SkyPointing& direction : piece) {
            way << disc.at(direction);
        }
        painter.drawPolyline(way);
    }
}

// Where the pass begins.
void drawBegin(QPainter& painter, const PaperDisc& disc, const pass_report::SkyLine& target, const QColor& colour)
{
    if (target.empty()) {
        return;
    }
    painter.setPen(paperPen(colour, 3.0));
    painter.setBrush(Qt::white);
    painter.drawEllipse(disc.at(target.front().front()), 10.0, 10.0);
}

QPen targetPen()
{
    return paperPen(kTargetInk, 9.0);
}

QPen planPen()
{
    return paperPen(kPlanInk, 2.5, Qt::DashLine);
}

void drawSkyLegend(QPainter& painter, const QRectF& room, bool hasPlan, bool isPair)
{
    struct Entry
    {
        QString text;
        QPen pen;
    };
    std::vector<Entry> entries{{Text::tr("target"), targetPen()}, {Text::tr("beam"), paperPen(kPassInk[0], 3.5)}};
    if (isPair) {
        entries[1].text = Text::tr("beam A");
        entries.push_back({Text::tr("beam B"), paperPen(kPassInk[1], 3.5)});
    }
    if (hasPlan) {
        entries.push_back({Text::tr("plan"), planPen()});
    }
    const qreal width = room.width() / static_cast<qreal>(entries.size());
    for (std::size_t i = 0; i < entries.size(); ++i) {
        const QRectF one(room.left() + width * static_cast<qreal>(i), room.top(), width, room.height());
        painter.setPen(entries[i].pen);
        painter.drawLine(QPointF(one.left(), one.center().y()), QPointF(one.left() + 55.0, one.center().y()));
        drawPaperText(painter, one.adjusted(65.0, 0.0, -8.0, 0.0), {.text = entries[i].text, .size = kSmallLetters});
    }
}

}  // namespace

void drawReportSky(QPainter& painter, const QRectF& room, std::span<const pass_report::PassTrace> passes)
{
    const QRectF square = room.adjusted(0.0, 0.0, 0.0, -kLegendHeight);
    const PaperDisc disc{.centre = square.center(),
                         .radius = 0.5 * std::min(square.width(), square.height()) - kAroundDisc};
    drawGrid(painter, disc);
    drawLabels(painter, disc);
    const bool hasPlan = std::ranges::any_of(passes, [](const auto& pass) { return !pass.plan.empty(); });
    for (const pass_report::PassTrace& pass : passes) {
        drawSkyLine(painter, disc, pass.target, targetPen());
    }
    for (const pass_report::PassTrace& pass : passes) {
        drawSkyLine(painter, disc, pass.plan, planPen());
    }
    for (std::size_t i = 0; i < passes.size() && i < kPassInk.size(); ++i) {
        drawSkyLine(painter, disc, passes[i].beam, paperPen(kPassInk[i], 3.5));
        drawBegin(painter, disc, passes[i].target, kPassInk[i]);
    }
    drawSkyLegend(painter, {room.left(), room.bottom() - kLegendHeight, room.width(), kLegendHeight}, hasPlan,
                  passes.size() > 1);
}

}  // namespace boresight::ui
