// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/column_head.h"

#include "ui/kit/theme.h"
#include "ui/window/alarm_card.h"
#include "ui/window/antenna_row.h"
#include "ui/window/axis_readout.h"
#include "ui/window/sensor_readout.h"
#include "ui/window/wind_readout.h"

#include <QVBoxLayout>

#include <algorithm>
#include <array>

namespace boresight::ui {

namespace {

// px in a low window that an alarm may take from the panels. The last line of the log is below the sky there, which
// leaves 22 of them.
constexpr int kKeptForAlarms = 46;
constexpr int kKeptInAUsualWindow = 21;  // px, so that the numerals keep their size beside a short alarm
constexpr int kKeptInAHighWindow = 110;  // px, where the panels have more room than they need
constexpr int kHighWindow = 1000;        // px

int keptForAlarms(QSize window)
{
    return isLow(window) ? kKeptForAlarms : window.height() >= kHighWindow ? kKeptInAHighWindow : kKeptInAUsualWindow;
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
    column->addStretch(1);
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
    arrange();
}

int ColumnHead::heightOfAlarm(AlarmForm form) const
{
    return m_alarms.isHidden() ? 0 : m_alarms.heightWith(form, width()) + layout()->spacing();
}

// A long alarm is in smaller letters before it takes the room of the numerals, or leaves out a sentence. This is tried
// once for each alarm, because other letters lay the column out again.
void ColumnHead::arrange()
{
    if (const Tried now{m_alarms.wholeText(), m_window}; now != m_tried) {
        m_tried = now;
        m_alarms.setTight(isLow(m_window));
    }
    Arrangement best = mostCompleteArrangement();
    if (best.numerals < Numerals::Row) {
        m_alarms.setTight(true);
        best = mostCompleteArrangement();
    }
    m_axes->setNumerals(best.numerals);
    m_sensor->setRoom(best.sensor);
    m_alarms.setForm(best.alarm);
}

// The first that fits into the room of the head without an alarm, else the last. Reserves this room.
ColumnHead::Arrangement ColumnHead::mostCompleteArrangement()
{
    const Numerals usual = numeralsFor(m_window);
    const int sensor = m_sensor->isConfigured() ? m_sensor->sizeHint().height() + layout()->spacing() : 0;
    const int antenna = m_antenna->hasChoice() ? m_antenna->sizeHint().height() + layout()->spacing() : 0;
    const int wind = m_wind->isConfigured() ? m_wind->sizeHint().height() + layout()->spacing() : 0;
    const auto height = [&](const Arrangement& of) {
        return antenna + wind + m_axes->sizeWith(of.numerals).height() + (of.sensor ? sensor : 0);
    };
    const Numerals inRow = isLow(m_window) ? Numerals::Small : Numerals::Row;
    const std::array arrangements{Arrangement{usual, true},
                                  Arrangement{std::min(usual, Numerals::Usual), true},
                                  Arrangement{inRow, true},
                                  Arrangement{inRow, isLow(m_window)},
                                  Arrangement{Numerals::Small, true},
                                  Arrangement{Numerals::Beside, true},
                                  Arrangement{Numerals::Beside, false},
                                  Arrangement{Numerals::Bare, false},
                                  Arrangement{Numerals::Bare, false, AlarmForm::Flowing},
                                  Arrangement{Numerals::Bare, false, AlarmForm::Remedy}};
    const int room = height(arrangements.front()) + keptForAlarms(m_window);
    setMinimumSize(m_axes->sizeWith(usual).width(), room);
    const auto* const fits = std::ranges::find_if(
        arrangements, [&](const Arrangement& one) { return heightOfAlarm(one.alarm) + height(one) <= room; });
    return fits == arrangements.end() ? arrangements.back() : *fits;
}

}  // namespace boresight::ui

#include "moc_column_head.cpp"
