// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/sky/sky_path.h"

#include "ui/kit/format.h"
#include "ui/kit/theme.h"
#include "ui/sky/sky_text.h"

#include <QFontMetricsF>
#include <QPainter>

#include <algorithm>
#include <chrono>

namespace boresight::ui {

namespace {

constexpr double kLineWidth = 1.6;  // px
constexpr double kDot = 2.5;
constexpr double kEndMark = 4.0;
constexpr std::chrono::minutes kLongWay{40};
constexpr UtcTime::duration kMinute = std::chrono::minutes(1);
constexpr UtcTime::duration kHour = std::chrono::hours(1);

}  // namespace

void SkyPath::setSky(const SkyProjection& sky)
{
    m_sky = sky;
    rebuild();
}

QRect SkyPath::show(const targets::SkyWay& way, UtcTime utc)
{
    std::size_t first = 0;
    if (way) {
        first = static_cast<std::size_t>(
            std::ranges::find_if(*way, [&](const targets::SkyMoment& one) { return one.utc > utc; }) - way->begin());
    }
    if (way == m_way && first == m_first) {
        return {};
    }
    const QRect before = box();
    m_way = way;
    m_first = first;
    rebuild();
    return before | box();
}

void SkyPath::rebuild()
{
    m_clear.clear();
    m_hidden.clear();
    m_dots.clear();
    m_ends.clear();
    if (!m_way || m_way->size() < 2 || m_first == m_way->size()) {
        return;
    }
    addLines();
    addDots();
    if (m_first == 0) {
        addEnd(m_way->front(), true);
    }
    addEnd(m_way->back(), false);
}

// A segment is hidden if its end is hidden.
void SkyPath::addLines()
{
    for (std::size_t i = m_first + 1; i < m_way->size(); ++i) {
        const targets::SkyMoment& to = (*m_way)[i];
        QPainterPath& line = to.isHidden ? m_hidden : m_clear;
        const QPointF begin = m_sky.toPixel((*m_way)[i - 1].direction);
        if (line.isEmpty() || line.currentPosition() != begin) {
            line.moveTo(begin);
        }
        line.lineTo(m_sky.toPixel(to.direction));
    }
}

// Between two moments the line is straight.
void SkyPath::addDots()
{
    const UtcTime::duration length = m_way->back().utc - m_way->front().utc;
    const UtcTime::duration apart = length > kLongWay ? kHour : kMinute;
    for (std::size_t i = std::max<std::size_t>(m_first, 1); i < m_way->size(); ++i) {
        const targets::SkyMoment& from = (*m_way)[i - 1];
        const targets::SkyMoment& to = (*m_way)[i];
        const UtcTime whole{to.utc.time_since_epoch() / apart * apart};
        if (whole > from.utc) {
            const QPointF begin = m_sky.toPixel(from.direction);
            m_dots.push_back(begin +
                             (m_sky.toPixel(to.direction) - begin) * (Seconds(whole - from.utc) / (to.utc - from.utc)));
        }
    }
}

void SkyPath::addEnd(const targets::SkyMoment& moment, bool isBegin)
{
    End end{.pixel = m_sky.toPixel(moment.direction),
            .text = {},
            .time = clockText(moment.utc).chopped(3),  // to the minute
            .isBegin = isBegin};
    const QFontMetricsF metrics(fonts::label());
    end.text = boxBeside(end.pixel, {metrics.horizontalAdvance(end.time) + 4.0, metrics.height()});
    m_ends.push_back(end);
}

// Towards the middle of the sky, at the height of the end. If the path passes there, below or above the end.
QRectF SkyPath::boxBeside(const QPointF& end, const QSizeF& size) const
{
    const bool isWest = end.x() < m_sky.zenith.x();
    const double left = end.x() + (isWest ? kEndMark + 2.0 : -kEndMark - 2.0 - size.width());
    const auto isFree = [&](const QRectF& box) {
        return std::none_of(m_way->begin() + static_cast<std::ptrdiff_t>(m_first), m_way->end(),
                            [&](const targets::SkyMoment& one) { return box.contains(m_sky.toPixel(one.direction)); });
    };
    for (const double down : {-0.5 * size.height(), kEndMark + 2.0, -kEndMark - 2.0 - size.height()}) {
        const QRectF box(QPointF(left, end.y() + down), size);
        if (isFree(box)) {
            return box;
        }
    }
    return {QPointF(left, end.y() - 0.5 * size.height()), size};
}

QRect SkyPath::box() const
{
    if (m_ends.empty()) {
        return {};
    }
    QRectF box = m_clear.boundingRect() | m_hidden.boundingRect();
    for (const End& end : m_ends) {
        box |= end.text;
    }
    const int margin = static_cast<int>(kEndMark) + 2;
    return box.toAlignedRect().adjusted(-margin, -margin, margin, margin);
}

void SkyPath::paint(QPainter& painter, const QColor& colour) const
{
    const Theme& colours = currentTheme();
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(colour, kLineWidth, Qt::DotLine));
    painter.drawPath(m_hidden);
    painter.setPen(QPen(colour, kLineWidth, Qt::DashLine));
    painter.drawPath(m_clear);
    for (const End& end : m_ends) {
        painter.setBrush(end.isBegin ? colour : colours.skyRim);
        painter.drawEllipse(end.pixel, kEndMark, kEndMark);
    }
    painter.setPen(Qt::NoPen);
    painter.setBrush(colour);
    for (const QPointF& dot : m_dots) {
        painter.drawEllipse(dot, kDot, kDot);
    }
    for (const End& end : m_ends) {
        drawOutlinedText(painter, end.text, end.time, colour, colours.skyRim);
    }
}

}  // namespace boresight::ui
