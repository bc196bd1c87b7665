// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/passes/pass_timeline.h"

#include "ui/kit/format.h"
#include "ui/kit/theme.h"
#include "ui/look/glyph.h"
#include "ui/passes/pass_words.h"

#include <QHelpEvent>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QScrollBar>
#include <QToolTip>

#include <algorithm>
#include <chrono>
#include <cmath>

namespace boresight::ui {

namespace {

// The next day, and the part of the present hour that is over.
constexpr std::chrono::hours kSpan{25};
constexpr double kLeastRow = 20.0;    // px
constexpr double kLeastBar = 3.0;     // px wide
constexpr double kReach = 10.0;       // px: a click this far beside a bar still selects it
constexpr double kStar = 12.0;        // px
constexpr double kNamePart = 0.32;    // of the width, at most
constexpr double kWeakest = 0.35;     // of colour and height, for a pass that stays at the horizon
constexpr double kStrongFrom = 60.0;  // °: from this highest elevation on, a bar has its full colour

}  // namespace

PassTimeline::PassTimeline(QWidget* parent) : QAbstractScrollArea(parent)
{
    setFont(fonts::label());
    setAccessibleName(tr("Timeline of the coming passes"));
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setFocusPolicy(Qt::StrongFocus);
    setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Expanding);
    viewport()->setMouseTracking(false);
}

void PassTimeline::show(const Timeline& timeline)
{
    m_timeline = timeline;
    m_widestName = 0.0;
    for (const TimelineRow& row : timeline.rows) {
        m_widestName = std::max<double>(m_widestName, fontMetrics().horizontalAdvance(row.name) + 1);
    }
    setAccessibleDescription(summary());
    fitScrollBar();
    showSelectedRow();
    viewport()->update();
}

void PassTimeline::setNow(UtcTime now)
{
    m_now = now;
    m_begin = std::chrono::floor<std::chrono::hours>(now);
    viewport()->update();
}

void PassTimeline::setSelected(std::int64_t number, UtcTime highest)
{
    m_number = number;
    m_highest = highest;
    showSelectedRow();
    viewport()->update();
}

QString PassTimeline::summary() const
{
    return tr("%1 satellites. %2").arg(QString::number(m_timeline.rows.size()), leftOutText()).trimmed();
}

QString PassTimeline::leftOutText() const
{
    return m_timeline.leftOut == 0 ? QString() : tr("%1 more satellites are only in the list.").arg(m_timeline.leftOut);
}

// One more row gives the number of satellites without a row.
std::size_t PassTimeline::rowCount() const
{
    return m_timeline.rows.size() + (m_timeline.leftOut == 0 ? 0 : 1);
}

double PassTimeline::headHeight() const
{
    return fontMetrics().height() + 4.0;
}

double PassTimeline::rowHeight() const
{
    const double room = viewport()->height() - headHeight();
    const double rows = std::max<double>(1.0, static_cast<double>(rowCount()));
    return std::clamp(std::floor(room / rows), kLeastRow, static_cast<double>(kRowHeight));
}

double PassTimeline::nameWidth() const
{
    const double star = 4.0 + kStar + 4.0;
    return std::min(star + m_widestName, viewport()->width() * kNamePart);
}

QRectF PassTimeline::nameBox(std::size_t row) const
{
    return rowBox(row).adjusted(4.0 + kStar + 4.0, 0.0, nameWidth() - viewport()->width(), 0.0);
}

double PassTimeline::pixelOf(UtcTime utc) const
{
    const double left = nameWidth() + 4.0;
    return left + (viewport()->width() - 4.0 - left) * (Seconds(utc - m_begin) / Seconds(kSpan));
}

QRectF PassTimeline::rowBox(std::size_t row) const
{
    const double top = headHeight() + rowHeight() * static_cast<double>(row) - verticalScrollBar()->value();
    return {0.0, top, static_cast<double>(viewport()->width()), rowHeight()};
}

// The height of the bar grows with the elevation, so a high pass is also visible in a theme with one colour.
QRectF PassTimeline::barBox(std::size_t row, const TimelineBar& bar) const
{
    const QRectF box = rowBox(row).adjusted(0.0, 3.0, 0.0, -3.0);
    const double part = kWeakest + (1.0 - kWeakest) * std::clamp(bar.elevation.degrees() / 90.0, 0.0, 1.0);
    const double left = std::max(pixelOf(bar.rises), pixelOf(m_begin));
    const double right = std::min(pixelOf(bar.sets), pixelOf(m_begin + kSpan));
    const double height = box.height() * part;
    return {left, box.bottom() - height, std::max(right - left, kLeastBar), height};
}

bool PassTimeline::isSelected(const TimelineRow& row, const TimelineBar& bar) const
{
    return row.number == m_number && isSameMoment(bar.highest, m_highest);
}

void PassTimeline::fitScrollBar()
{
    const double all = rowHeight() * static_cast<double>(rowCount());
    const double room = viewport()->height() - headHeight();
    verticalScrollBar()->setRange(0, std::max(0, static_cast<int>(std::ceil(all - room))));
    verticalScrollBar()->setPageStep(std::max(1, static_cast<int>(room)));
    verticalScrollBar()->setSingleStep(static_cast<int>(rowHeight()));
}

// The selection may come from the keys or from the list.
void PassTimeline::showSelectedRow()
{
    const auto found = std::ranges::find(m_timeline.rows, m_number, &TimelineRow::number);
    if (found == m_timeline.rows.end()) {
        return;
    }
    const double top = rowHeight() * static_cast<double>(found - m_timeline.rows.begin());
    const double lowest = top + rowHeight() - (viewport()->height() - headHeight());
    const double highest = std::max(top, lowest);
    verticalScrollBar()->setValue(static_cast<int>(
        std::clamp<double>(verticalScrollBar()->value(), std::ceil(std::min(top, lowest)), std::floor(highest))));
}

void PassTimeline::resizeEvent(QResizeEvent* event)
{
    QAbstractScrollArea::resizeEvent(event);
    fitScrollBar();
    showSelectedRow();
}

void PassTimeline::paintEvent(QPaintEvent*)
{
    QPainter painter(viewport());
    painter.setFont(font());
    painter.fillRect(viewport()->rect(), currentTheme().plotGround);
    painter.setClipRect(QRectF(0.0, headHeight(), viewport()->width(), viewport()->height()));
    paintSelectedSpan(painter);
    for (std::size_t row = 0; row < m_timeline.rows.size(); ++row) {
        if (rowBox(row).intersects(viewport()->rect())) {
            paintRow(painter, row);
        }
    }
    painter.setPen(currentTheme().secondary);
    painter.drawText(rowBox(m_timeline.rows.size()).adjusted(4.0, 0.0, 0.0, 0.0), Qt::AlignLeft | Qt::AlignVCenter,
                     leftOutText());
    painter.setClipping(false);
    paintHours(painter);
}

// Across all rows, so that overlapping passes are visible.
void PassTimeline::paintSelectedSpan(QPainter& painter) const
{
    for (const TimelineRow& row : m_timeline.rows) {
        for (const TimelineBar& bar : row.bars) {
            if (isSelected(row, bar)) {
                const double left = pixelOf(std::max(bar.rises, m_begin));
                const double right = std::max(pixelOf(bar.sets), left + kLeastBar);
                painter.fillRect(QRectF(left - 1.0, headHeight(), right - left + 2.0, viewport()->height()),
                                 currentTheme().accentSoft);
            }
        }
    }
}

void PassTimeline::paintRow(QPainter& painter, std::size_t row) const
{
    const Theme& colours = currentTheme();
    const TimelineRow& satellite = m_timeline.rows[row];
    const QRectF box = rowBox(row);
    painter.setRenderHint(QPainter::Antialiasing, false);
    painter.setPen(colours.grid);
    painter.drawLine(box.bottomLeft(), box.bottomRight());
    const QRectF name = nameBox(row);
    if (satellite.isFavourite) {
        painter.save();
        const QRectF star(4.0, name.center().y() - kStar / 2.0, kStar, kStar);
        drawGlyph(painter, Glyph::Favourite, star, colours.secondary);
        painter.restore();
    }
    painter.setPen(satellite.number == m_number ? colours.text : colours.secondary);
    painter.drawText(name, Qt::AlignLeft | Qt::AlignVCenter,
                     fontMetrics().elidedText(satellite.name, Qt::ElideRight, static_cast<int>(name.width())));
    for (const TimelineBar& bar : satellite.bars) {
        if (bar.sets > m_begin && bar.rises < m_begin + kSpan) {
            paintBar(painter, row, bar);
        }
    }
}

// Bars of passes that the schedule tracks are underlined. Bars of passes that it omits are hollow.
void PassTimeline::paintBar(QPainter& painter, std::size_t row, const TimelineBar& bar) const
{
    const Theme& colours = currentTheme();
    const QRectF box = barBox(row, bar);
    const bool isPlanned = bar.plan != PassPlan::None;
    QColor colour = isPlanned ? colours.accent : colours.secondary;
    colour.setAlphaF(
        static_cast<float>(kWeakest + (1.0 - kWeakest) * std::clamp(bar.elevation.degrees() / kStrongFrom, 0.0, 1.0)));
    if (bar.plan == PassPlan::LeftOut) {
        painter.setPen(QPen(colours.accent, 1.0));
        painter.setBrush(Qt::NoBrush);
        painter.drawRect(box.adjusted(0.0, 0.0, -1.0, -1.0));
    } else {
        painter.fillRect(box, colour);
    }
    for (const passes::Stretch& part : bar.tracked) {
        const double left = std::max(pixelOf(part.from), box.left()) - 1.0;
        const double right = std::min(pixelOf(part.to), box.right()) + 1.0;
        painter.fillRect(QRectF(left, box.bottom(), std::max(right - left, kLeastBar), 2.0), colours.accent);
    }
    if (isSelected(m_timeline.rows[row], bar)) {
        painter.setPen(QPen(colours.text, 1.0));
        painter.setBrush(Qt::NoBrush);
        painter.drawRect(box.adjusted(-3.0, -3.0, 2.0, 2.0));
    }
}

void PassTimeline::paintHours(QPainter& painter) const
{
    const Theme& colours = currentTheme();
    const QFontMetrics metrics = fontMetrics();
    const double hour = pixelOf(m_begin + std::chrono::hours(1)) - pixelOf(m_begin);
    const int step = hour * 1.0 > metrics.horizontalAdvance(QStringLiteral("00  "))   ? 1
                     : hour * 3.0 > metrics.horizontalAdvance(QStringLiteral("00  ")) ? 3
                                                                                      : 6;
    painter.setPen(colours.secondary);
    painter.drawText(QRectF(4.0, 0.0, nameWidth(), headHeight()), Qt::AlignLeft | Qt::AlignVCenter, tr("UTC"));
    for (UtcTime at = m_begin; at <= m_begin + kSpan; at += std::chrono::hours(1)) {
        const auto number = std::chrono::duration_cast<std::chrono::hours>(at.time_since_epoch()).count() % 24;
        if (number % step != 0) {
            continue;
        }
        const double x = std::round(pixelOf(at)) + 0.5;
        painter.setPen(colours.grid);
        painter.drawLine(QPointF(x, headHeight()), QPointF(x, viewport()->height()));
        const QString text = QStringLiteral("%1").arg(number, 2, 10, QLatin1Char('0'));
        const double half = metrics.horizontalAdvance(text) / 2.0 + 1.0;
        painter.setPen(colours.secondary);
        if (x + half < viewport()->width()) {
            painter.drawText(QRectF(x - half, 0.0, 2.0 * half, headHeight()), Qt::AlignCenter, text);
        }
    }
    const double now = std::round(pixelOf(m_now)) + 0.5;
    painter.setPen(QPen(colours.text, 1.5));
    painter.drawLine(QPointF(now, headHeight() - 4.0), QPointF(now, viewport()->height()));
}

std::optional<PassTimeline::Place> PassTimeline::placeAt(const QPointF& at) const
{
    std::optional<Place> nearest;
    double least = kReach;
    for (std::size_t row = 0; at.y() > headHeight() && row < m_timeline.rows.size(); ++row) {
        if (!rowBox(row).contains(at)) {
            continue;
        }
        const std::vector<TimelineBar>& bars = m_timeline.rows[row].bars;
        for (std::size_t bar = 0; bar < bars.size(); ++bar) {
            const QRectF box = barBox(row, bars[bar]);
            const double away = std::max({box.left() - at.x(), at.x() - box.right(), 0.0});
            if (away < least) {
                least = away;
                nearest = Place{.row = row, .bar = bar};
            }
        }
    }
    return nearest;
}

void PassTimeline::mousePressEvent(QMouseEvent* event)
{
    if (const auto place = placeAt(event->position()); place && event->button() == Qt::LeftButton) {
        const TimelineRow& row = m_timeline.rows[place->row];
        Q_EMIT passChosen(row.number, row.bars[place->bar].highest);
    }
}

void PassTimeline::keyPressEvent(QKeyEvent* event)
{
    const int key = event->key();
    if (key == Qt::Key_Left || key == Qt::Key_Up) {
        Q_EMIT stepWanted(-1);
    } else if (key == Qt::Key_Right || key == Qt::Key_Down) {
        Q_EMIT stepWanted(1);
    } else {
        QAbstractScrollArea::keyPressEvent(event);
    }
}

QString PassTimeline::helpAt(const QPointF& at) const
{
    const auto place = placeAt(at);
    if (!place) {
        return tr(
            "A high pass has a high bar. Underlined: the schedule tracks it. Hollow: the schedule leaves it out.");
    }
    const TimelineRow& row = m_timeline.rows[place->row];
    const TimelineBar& bar = row.bars[place->bar];
    return tr("%1: %2Z to %3Z, %4 high")
        .arg(row.name, clockText(bar.rises), clockText(bar.sets), angleText(bar.elevation, 0));
}

bool PassTimeline::viewportEvent(QEvent* event)
{
    if (event->type() != QEvent::ToolTip) {
        return QAbstractScrollArea::viewportEvent(event);
    }
    const auto* const help = static_cast<QHelpEvent*>(event);
    QToolTip::showText(help->globalPos(), helpAt(help->pos()), viewport());
    return true;
}

}  // namespace boresight::ui

#include "moc_pass_timeline.cpp"
