// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/column_head.h"

#include "ui/kit/theme.h"
#include "ui/window/alarm_card.h"
#include "ui/window/antenna_row.h"
#include "ui/window/axis_readout.h"
#include "ui/window/sensor_readout.h"

#include <QEvent>
#include <QScrollArea>
#include <QVBoxLayout>

#include <algorithm>
#include <array>

namespace boresight::ui {

namespace {

// What Boresight did and what to do have two to five lines. A low window has no room for more than two.
constexpr int kLinesOfAdvice = 5;
constexpr int kLinesInLowWindow = 2;

}  // namespace

ColumnHead::ColumnHead(AlarmCard& alarms, RequestDesk& desk, QWidget* parent)
    : QWidget(parent),
      m_alarms(alarms),
      m_alarmRoom(new QScrollArea(this)),
      m_axes(new AxisReadout(this)),
      m_antenna(new AntennaRow(desk, alarms.notice(), this)),
      m_sensor(new SensorReadout(this))
{
    m_alarmRoom->setFrameShape(QFrame::NoFrame);
    m_alarmRoom->setWidgetResizable(true);
    m_alarmRoom->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_alarmRoom->setFocusPolicy(Qt::NoFocus);
    m_alarmRoom->setWidget(&m_alarms);
    m_alarms.hide();  // setWidget() shows it
    m_alarmRoom->hide();
    m_alarms.installEventFilter(this);
    auto* const column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(kGrid / 2);
    column->addWidget(m_alarmRoom);
    column->addWidget(m_axes, 1);
    column->addWidget(m_antenna);
    column->addWidget(m_sensor);
}

void ColumnHead::showStatus(const StationStatus& status)
{
    m_axes->showStatus(status);
    m_antenna->showStatus(status);
    m_sensor->showStatus(status.sensor);
    arrange();
}

void ColumnHead::setRoom(QSize window)
{
    m_window = window;
    arrange();
}

// The card comes and goes at any time: with a notice, too.
bool ColumnHead::eventFilter(QObject* watched, QEvent* event)
{
    if (event->type() == QEvent::ShowToParent || event->type() == QEvent::HideToParent) {
        arrange();
    }
    return QWidget::eventFilter(watched, event);
}

int ColumnHead::heightOfAlarm() const
{
    return m_alarms.isHidden() ? 0 : m_alarms.heightForWidth(width()) + layout()->spacing();
}

// The fullest arrangement that there is room for beside the alarm.
void ColumnHead::arrange()
{
    struct Arrangement
    {
        Numerals numerals;
        bool sensor;
    };
    const Numerals usual = numeralsFor(m_window);
    const int sensor = m_sensor->isConfigured() ? m_sensor->sizeHint().height() + layout()->spacing() : 0;
    const int antenna = m_antenna->hasChoice() ? m_antenna->sizeHint().height() + layout()->spacing() : 0;
    const auto height = [&](const Arrangement& of) {
        return antenna + m_axes->sizeWith(of.numerals).height() + (of.sensor ? sensor : 0);
    };
    const std::array arrangements{Arrangement{std::max(usual, Numerals::Usual), true},
                                  Arrangement{Numerals::Usual, true}, Arrangement{Numerals::Small, true},
                                  Arrangement{Numerals::Beside, true}, Arrangement{Numerals::Beside, false}};
    const Arrangement& least = arrangements.back();
    const int reserved = m_alarms.heightWith(usual == Numerals::Small ? kLinesInLowWindow : kLinesOfAdvice);
    const int room = std::max(height({usual, true}), height(least) + reserved + layout()->spacing());
    const int alarm = heightOfAlarm();
    const auto fits = [&](const Arrangement& one) {
        return alarm + height(one) <= room && m_axes->sizeWith(one.numerals).width() <= width();
    };
    const auto* const found = std::ranges::find_if(arrangements, fits);
    const Arrangement& best = found == arrangements.end() ? least : *found;
    setFixedHeight(room);
    setMinimumWidth(m_axes->sizeWith(usual).width());
    m_axes->setNumerals(best.numerals);
    m_sensor->setRoom(best.sensor);
    m_alarmRoom->setFixedHeight(std::max(0, std::min(alarm, room - height(best)) - layout()->spacing()));
    m_alarmRoom->setVisible(alarm > 0);
}

}  // namespace boresight::ui

#include "moc_column_head.cpp"
