// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/progress_line.h"

#include "ui/kit/theme.h"

#include <QPainter>

#include <algorithm>

namespace boresight::ui {

namespace {

constexpr int kHeight = 2;

}  // namespace

ProgressLine::ProgressLine(QWidget* parent) : QWidget(parent)
{
    setAccessibleName(tr("Progress of the slew"));
    setFixedHeight(kHeight);
}

void ProgressLine::setDone(const std::optional<double>& done)
{
    if (m_done != done) {
        m_done = done;
        setAccessibleDescription(done ? tr("%1 %").arg(qRound(*done * 100.0)) : QString());
        update();
    }
}

void ProgressLine::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.fillRect(rect(), currentTheme().grid);
    if (m_done) {
        const double part = std::clamp(*m_done, 0.0, 1.0);
        painter.fillRect(QRect(0, 0, qRound(part * width()), height()), currentTheme().accent);
    }
}

}  // namespace boresight::ui

#include "moc_progress_line.cpp"
