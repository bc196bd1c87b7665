// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/north/sensor_levels.h"

#include "ui/kit/caption.h"
#include "ui/kit/value_label.h"

#include <QGridLayout>
#include <QPainter>

namespace boresight::ui {

namespace {

constexpr int kHighest = 3;
constexpr int kEnough = 2;  // calibration::SensorOffsetLimits

struct Part
{
    const char* name;
    const char* how;
    int orientation::Calibration::*level;
};

// From the documentation of the BNO055.
constexpr Part kSensorLevelsParts[] = {
    {QT_TRANSLATE_NOOP("boresight::ui::SensorLevels", "System"),
     QT_TRANSLATE_NOOP("boresight::ui::SensorLevels", "follows the other three"), &orientation::Calibration::system},
    {QT_TRANSLATE_NOOP("boresight::ui::SensorLevels", "Gyro"),
     QT_TRANSLATE_NOOP("boresight::ui::SensorLevels", "hold it still, 5 s"), &orientation::Calibration::gyro},
    {QT_TRANSLATE_NOOP("boresight::ui::SensorLevels", "Accel."),
     QT_TRANSLATE_NOOP("boresight::ui::SensorLevels", "lay it on its six sides, 3 s each"),
     &orientation::Calibration::accelerometer},
    {QT_TRANSLATE_NOOP("boresight::ui::SensorLevels", "Compass"),
     QT_TRANSLATE_NOOP("boresight::ui::SensorLevels", "figure of eight, away from iron"),
     &orientation::Calibration::magnetometer}};

}  // namespace

SensorLevels::SensorLevels(QWidget* parent) : QWidget(parent)
{
    auto* const grid = new QGridLayout(this);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setHorizontalSpacing(6);
    grid->setVerticalSpacing(2);
    for (std::size_t line = 0; line < m_rows.size(); ++line) {
        const QString name = tr(kSensorLevelsParts[line].name);
        m_rows[line] = {.bar = new LevelBar(tr("%1 calibration").arg(name), this),
                        .how = new ValueLabel(tr("%1: how to raise it").arg(name), fonts::label(), {}, this)};
        m_rows[line].how->setStretching(true);
        const int row = static_cast<int>(line);
        grid->addWidget(makeCaption(name, this), row, 0);
        grid->addWidget(m_rows[line].bar, row, 1);
        grid->addWidget(m_rows[line].how, row, 2);
    }
    grid->setColumnStretch(2, 1);
    showCalibration({});
}

void SensorLevels::showCalibration(const std::optional<orientation::Calibration>& calibration)
{
    for (std::size_t line = 0; line < m_rows.size(); ++line) {
        const Part& part = kSensorLevelsParts[line];
        const auto level = calibration ? std::optional(*calibration.*part.level) : std::nullopt;
        m_rows[line].bar->setLevel(level);
        if (!level) {
            m_rows[line].how->setValue(tr("not reported"), Tone::Secondary);
        } else if (*level == kHighest) {
            m_rows[line].how->setValue(tr("good"), Tone::Secondary);
        } else {
            const bool low = *level < kEnough;
            m_rows[line].how->setValue(tr(part.how), low ? Tone::Warning : Tone::Normal,
                                       low ? Symbol::Warning : Symbol::None);
        }
    }
}

LevelBar::LevelBar(const QString& name, QWidget* parent) : QWidget(parent)
{
    setAccessibleName(name);
    setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
}

void LevelBar::setLevel(std::optional<int> level)
{
    if (level != m_level || accessibleDescription().isEmpty()) {
        m_level = level;
        setAccessibleDescription(level ? tr("%1 of 3").arg(*level) : tr("not reported"));
        setToolTip(accessibleDescription());
        update();
    }
}

void LevelBar::paintEvent(QPaintEvent*)
{
    const Theme& colours = currentTheme();
    QPainter painter(this);
    const int step = width() / kHighest;
    for (int box = 0; box < kHighest; ++box) {
        painter.setPen(QPen(colours.secondary, 1.0, m_level ? Qt::SolidLine : Qt::DotLine));
        painter.setBrush(m_level && box < *m_level ? QBrush(colours.secondary) : QBrush(Qt::NoBrush));
        painter.drawRect(box * step, 1, step - 4, height() - 3);
    }
}

}  // namespace boresight::ui

#include "moc_sensor_levels.cpp"
