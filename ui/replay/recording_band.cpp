// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/replay/recording_band.h"

#include "ui/kit/theme.h"

#include <QPainter>

namespace boresight::ui {

namespace {

constexpr int kBandMargin = 12;  // px
constexpr int kBandHeight = 40;
constexpr double kStripe = 14.0;

}  // namespace

RecordingBand::RecordingBand(const QString& title, const QString& detail, QWidget* parent)
    : QWidget(parent), m_title(title), m_detail(detail)
{
    setAccessibleName(title);
    setAccessibleDescription(detail);
    setToolTip(title + QLatin1Char('\n') + detail);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
}

QSize RecordingBand::sizeHint() const
{
    return {0, kBandHeight};
}

// Stripes at both ends, so that the shape shows it, too.
void RecordingBand::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const Theme& colours = currentTheme();
    painter.fillRect(rect(), colours.accent);
    painter.setPen(QPen(colours.onAccent, kStripe / 3.0));
    for (int i = 0; i < 3; ++i) {
        for (const double left : {kBandMargin + i * kStripe, width() - kBandMargin - (i + 1) * kStripe}) {
            painter.drawLine(QPointF(left, height() - 6.0), QPointF(left + kStripe, 6.0));
        }
    }
    painter.setPen(colours.onAccent);
    const int side = kBandMargin + static_cast<int>(4.0 * kStripe) + kBandMargin;
    const QRect room = rect().adjusted(side, 0, -side, 0);
    painter.setFont(fonts::label());
    const int detail = painter.fontMetrics().horizontalAdvance(m_detail);
    painter.drawText(room, Qt::AlignRight | Qt::AlignVCenter, m_detail);
    QFont large = fonts::text();
    large.setBold(true);
    painter.setFont(large);
    const int left = room.width() - detail - kBandMargin;
    painter.drawText(room, Qt::AlignLeft | Qt::AlignVCenter,
                     painter.fontMetrics().elidedText(m_title, Qt::ElideRight, left));
}

}  // namespace boresight::ui

#include "moc_recording_band.cpp"
