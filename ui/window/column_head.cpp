// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/column_head.h"

#include "ui/kit/theme.h"
#include "ui/window/alarm_card.h"
#include "ui/window/antenna_row.h"
#include "ui/window/axis_readout.h"
#include "ui/window/sensor_readout.h"
#include "ui/window/wind_readout.h"

#include <QVBoxLayout>

#include <array>

namespace boresight::ui {

namespace {

// px that an alarm may take from the panels, by the size of the window. The readouts of the axes use this room while
// there is no alarm. In a low window the last line of the log is below the sky, which leaves 22 of them.
constexpr int keptForAlarms(Numerals numerals)
{
    switch (numerals) {
        case Numerals::Small:
            return 32;
        case Numerals::Usual:
            return 6;
        case Numerals::Large:
            break;
    }
    return 150;
}

}  // namespace

ColumnHead::ColumnHead(AlarmCard& alarms, RequestDesk& desk, QWidget* parent)
    : QWidget(parent),
      m_alarms(alarms),
      m_axes(new AxisReadout(this)),
      m_antenna(new AntennaRow(desk, alarms.notice(), this)),
      m_sensor(new SensorReadout(this)),
      m_wind(new WindReadout(this))
{
    auto* const column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(kGrid / 2);
    column->addWidget(&m_alarms);
    column->addWidget(m_axes, 1);
    column->addWidget(m_antenna);
    column->addWidget(m_wind);
    column->addWidget(m_sensor);
    connect(m_antenna, &AntennaRow::editWanted, this, &ColumnHead::antennasWanted);
}

void ColumnHead::showStatus(const StationStatus& status)
{
    m_axes->showStatus(status);
    m_antenna->showStatus(status);
    m_wind->showStatus(status.wind);
    m_sensor->showStatus(status.sensor, status.broker);
    arrange();
}

void ColumnHead::setRoom(QSize window)
{
    m_window = window;
    m_alarms.setLow(isLow(window));
    arrange();
}

int ColumnHead::heightOfAlarm(AlarmForm form) const
{
    return m_alarms.isHidden() ? 0 : m_alarms.heightWith(form, width()) + layout()->spacing();
}

// The most complete arrangement that fits into the room without an alarm.
void ColumnHead::arrange()
{
    struct Arrangement
    {
        CardForm cards;
        bool sensor;
        AlarmForm alarm = AlarmForm::Lines;
    };
    const Numerals numerals = numeralsFor(m_window);
    const int line = m_sensor->sizeHint().height() + layout()->spacing();
    const int sensor = m_sensor->isConfigured() ? line : 0;
    const int antenna = m_antenna->hasChoice() ? m_antenna->sizeHint().height() + layout()->spacing() : 0;
    const int wind = m_wind->isConfigured() ? m_wind->sizeHint().height() + layout()->spacing() : 0;
    const auto height = [&](const Arrangement& of) {
        return antenna + wind + m_axes->sizeWith(numerals, of.cards).height() + (of.sensor ? sensor : 0);
    };
    // The largest numbers are too wide for two cards in one row.
    const bool isWideEnough = m_axes->sizeWith(numerals, CardForm::Narrow).width() <= width();
    const CardForm narrow = isWideEnough ? CardForm::Narrow : CardForm::Wide;
    const CardForm bare = isWideEnough ? CardForm::Bare : CardForm::Wide;
    const std::array arrangements{Arrangement{CardForm::Wide, true},
                                  Arrangement{narrow, true},
                                  Arrangement{narrow, false},
                                  Arrangement{bare, false},
                                  Arrangement{bare, false, AlarmForm::Flowing},
                                  Arrangement{bare, false, AlarmForm::Remedy}};
    // Without a sensor its line is room for alarms, too.
    const int room = height(arrangements.front()) + (line - sensor) + keptForAlarms(numerals);
    Arrangement best = arrangements.back();
    for (const Arrangement& one : arrangements) {
        if (heightOfAlarm(one.alarm) + height(one) <= room) {
            best = one;
            break;
        }
    }
    setMinimumSize(m_axes->sizeWith(numerals, CardForm::Wide).width(), room);
    m_axes->arrange(numerals, best.cards);
    m_sensor->setRoom(best.sensor);
    m_alarms.setForm(best.alarm);
}

}  // namespace boresight::ui

#include "moc_column_head.cpp"
