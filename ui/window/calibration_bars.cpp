// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/calibration_bars.h"

#include "ui/kit/theme.h"

#include <QHelpEvent>
#include <QPainter>
#include <QToolTip>

#include <algorithm>

namespace boresight::ui {

namespace {

constexpr int kParts = 4;
constexpr int kFull = 3;
constexpr int kCell = 8;  // px
constexpr int kGap = 3;
constexpr int kTrusted = 2;  // below this level the compass is no evidence

QString partName(int part)
{
    switch (part) {
        case 0:
            return CalibrationBars::tr("SYS");
        case 1:
            return CalibrationBars::tr("GYR");
        case 2:
            return CalibrationBars::tr("ACC");
        default:
            return CalibrationBars::tr("MAG");
    }
}

QString procedure(int part)
{
    switch (part) {
        case 0:
            return CalibrationBars::tr(
                "System: this value follows the other three. At 0 the heading is not referred to north.");
        case 1:
            return CalibrationBars::tr("Gyro: hold the sensor still for some seconds.");
        case 2:
            return CalibrationBars::tr(
                "Accelerometer: hold the sensor still on each of its six sides, some seconds each.");
        default:
            return CalibrationBars::tr(
                "Magnetometer: move the sensor in figures of eight, away from iron and motors. On the mast, turn the "
                "mount through its range.");
    }
}

}  // namespace

CalibrationBars::CalibrationBars(QWidget* parent) : QWidget(parent)
{
    setFont(fonts::label());
    setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
    showCalibration(std::nullopt);
}

void CalibrationBars::showCalibration(const std::optional<orientation::Calibration>& calibration)
{
    std::optional<std::array<int, 4>> digits;
    if (calibration) {
        digits = {calibration->system, calibration->gyro, calibration->accelerometer, calibration->magnetometer};
    }
    if (digits == m_digits && !accessibleName().isEmpty()) {
        return;
    }
    m_digits = digits;
    setAccessibleName(digits ? tr("Calibration: system %1, gyro %2, accelerometer %3, magnetometer %4 of 3")
                                   .arg((*digits)[0])
                                   .arg((*digits)[1])
                                   .arg((*digits)[2])
                                   .arg((*digits)[3])
                             : tr("Calibration: not reported"));
    update();
}

int CalibrationBars::nameWidth() const
{
    int width = 0;
    for (int part = 0; part < kParts; ++part) {
        width = std::max(width, fontMetrics().horizontalAdvance(partName(part)));
    }
    return width;
}

int CalibrationBars::partWidth() const
{
    return nameWidth() + kGap + kFull * (kCell + 1) + 2 * kGap;
}

QSize CalibrationBars::sizeHint() const
{
    return {kParts * partWidth(), std::max(fontMetrics().height(), kCell + 4)};
}

void CalibrationBars::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.setFont(font());
    for (int part = 0; part < kParts; ++part) {
        drawPart(painter, part);
    }
}

void CalibrationBars::drawPart(QPainter& painter, int part) const
{
    const Theme& colours = currentTheme();
    const int digit = m_digits ? (*m_digits)[static_cast<std::size_t>(part)] : 0;
    const bool weak = m_digits && digit < kTrusted;
    const QColor colour = !m_digits ? colours.secondary : weak ? colours.warning : colours.text;
    const int left = part * partWidth();
    painter.setPen(colour);
    painter.drawText(QRect(left, 0, nameWidth(), height()), Qt::AlignLeft | Qt::AlignVCenter, partName(part));
    for (int cell = 0; cell < kFull; ++cell) {
        const QRect box(left + nameWidth() + kGap + cell * (kCell + 1), (height() - kCell) / 2, kCell - 1, kCell);
        if (cell < digit) {
            painter.fillRect(box, colour);
        } else {
            painter.setPen(colours.secondary);
            painter.drawRect(box.adjusted(0, 0, -1, -1));
        }
    }
}

bool CalibrationBars::event(QEvent* event)
{
    if (event->type() == QEvent::ToolTip) {
        const auto* const help = static_cast<QHelpEvent*>(event);
        const int part = std::clamp(help->pos().x() / partWidth(), 0, kParts - 1);
        QToolTip::showText(help->globalPos(), procedure(part), this);
        return true;
    }
    return QWidget::event(event);
}

}  // namespace boresight::ui

#include "moc_calibration_bars.cpp"
