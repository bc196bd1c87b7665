// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/guide/bus_picture.h"

#include "ui/kit/symbol.h"
#include "ui/kit/theme.h"

#include <QPainter>

namespace boresight::ui {

namespace {

constexpr QSizeF kPictureSize(132, 96);  // px
constexpr double kCableY = 62;

void drawBox(QPainter& painter, const QRectF& box, const QString& words, const QColor& colour)
{
    painter.setPen(QPen(colour, 1.5));
    painter.drawRoundedRect(box, 3, 3);
    painter.drawText(box, Qt::AlignCenter, words);
}

// The termination of 120 Ω at an end of the cable.
void drawTermination(QPainter& painter, double x)
{
    painter.drawLine(QPointF(x, kCableY), QPointF(x, kCableY + 6));
    painter.drawRect(QRectF(x - 3, kCableY + 6, 6, 12));
    painter.drawText(QRectF(x - 24, kCableY + 18, 48, 16), Qt::AlignCenter, QStringLiteral("120 Ω"));
}

}  // namespace

BusPicture::BusPicture(QWidget* parent) : QWidget(parent)
{
    setFont(fonts::label());
    setAccessibleName(tr("Cabling of adapter and drives"));
    setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
    describe();
}

void BusPicture::showBoards(Boards boards)
{
    if (boards != m_boards) {
        m_boards = boards;
        describe();
        update();
    }
}

void BusPicture::describe()
{
    const QString cable = tr("Adapter and boards on one cable, with 120 Ω at both ends");
    const QString text = m_boards == Boards::One             ? tr("%1. One board is disconnected").arg(cable)
                         : m_boards == Boards::BothWithOneId ? tr("%1. Both boards share one id").arg(cable)
                                                             : cable;
    setAccessibleDescription(text);
    setToolTip(text);
}

QSize BusPicture::sizeHint() const
{
    return kPictureSize.toSize();
}

void BusPicture::paintEvent(QPaintEvent* /*event*/)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const Theme& theme = currentTheme();
    const double ends[] = {20, 66, 112};
    painter.setPen(QPen(theme.secondary, 2));
    painter.drawLine(QPointF(ends[0], kCableY), QPointF(ends[2], kCableY));
    drawTermination(painter, ends[0]);
    drawTermination(painter, ends[2]);
    const bool one = m_boards == Boards::One;
    const bool same = m_boards == Boards::BothWithOneId;
    const QString first = same ? tr("id 1") : one ? tr("this") : tr("AZ");
    const QString second = same ? tr("id 1") : one ? tr("other") : tr("EL");
    const QString names[] = {QStringLiteral("USB"), first, second};
    for (int i = 0; i < 3; ++i) {
        const bool off = one && i == 2;
        painter.setPen(QPen(off ? theme.grid : theme.secondary, 2, off ? Qt::DotLine : Qt::SolidLine));
        painter.drawLine(QPointF(ends[i], 40), QPointF(ends[i], kCableY));
        drawBox(painter, QRectF(ends[i] - 19, 14, 38, 26), names[i], off ? theme.grid : theme.text);
        if (same && i > 0) {
            drawSymbol(painter, Symbol::Warning, QRectF(ends[i] - 5, 1, 10, 10), theme.warning);
        }
        if (off) {  // the disconnected board
            painter.setPen(QPen(theme.text, 2.5));
            painter.drawLine(QPointF(ends[i] - 5, 46), QPointF(ends[i] + 5, 56));
            painter.drawLine(QPointF(ends[i] - 5, 56), QPointF(ends[i] + 5, 46));
        }
    }
}

}  // namespace boresight::ui

#include "moc_bus_picture.cpp"
