// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/inputs/station_inputs.h"

#include "core/night/night_desk.h"

#include <utility>

namespace boresight {

StationInputs::StationInputs(StationControl& control, StationSwitches::Pins pins, const profile::InForce& profile,
                             const Clock& clock, EventLog& log, QObject* parent)
    : QObject(parent),
      m_control(control),
      m_clock(clock),
      m_broker(profile, log, clock, this),
      m_sensor(profile, clock, log, control.alarms(), m_broker, this),
      m_power(profile, clock, log, this),
      m_elements(profile, log, clock, this),
      m_follow(control, profile, clock, this),
      m_azel(profile, this),
      m_position(profile, log, clock, m_broker, this),
      m_wind(profile, log, clock, m_broker, this),
      m_switches(profile, std::move(pins), log, clock, m_broker, this)
{
    for (const Axis axis : kAxes) {
        if (!control.mount().capabilities().has(axis)) {
            m_sensor.watch().leaveOut(axis);
        }
    }
    connect(&m_azel, &StationAzel::looked, this,
            [this](const azel::AzelReading& reading) { (void)m_control.receive(reading); });
    connect(&m_position, &StationPosition::received, this, [this](const Result<position::PositionText>& read) {
        if (const Result<> taken = m_control.receive(read); !taken) {
            m_position.tellRefused(taken.error());
        }
    });
    connect(&m_wind, &StationWind::measured, this, [this](double speed) { m_control.takeWind(speed); });
}

void StationInputs::open()
{
    m_broker.open();
    m_sensor.open();
    m_power.open();
    m_elements.open();
    m_azel.open();
    m_position.open();
    m_wind.open();
    m_switches.open();
}

void StationInputs::close()
{
    m_sensor.close();
    m_power.close();
    m_azel.close();
    m_position.close();
    m_wind.close();
    m_switches.close();
    m_broker.close();  // last, because others read from it
}

void StationInputs::profileChanged(const profile::Profile& before, const profile::Profile& after)
{
    m_broker.profileChanged(before, after);
    m_sensor.profileChanged(before, after);
    m_power.profileChanged(before, after);
    m_elements.profileChanged(before, after);
    m_position.profileChanged(before, after);
    m_wind.profileChanged(before, after);
    m_switches.profileChanged(before, after);
}

void StationInputs::readTable(const QString& path, StationTables::Then then)
{
    m_follow.forget();
    m_tables.read(path, std::move(then));
}

void StationInputs::findRotator(const QString& name, StationFollow::Then then)
{
    m_tables.forget();
    m_follow.find(name, std::move(then));
}

void StationInputs::noticed(const Request& request)
{
    m_tables.noticed(request);
    if (!leavesTheMount(request)) {
        m_follow.forget();
    }
}

void StationInputs::forget()
{
    m_tables.forget();
    m_follow.close();
}

void StationInputs::tick()
{
    m_tables.tick(m_control.motionId(), m_clock.now());
    m_follow.tick();
    m_control.takeWindTrouble(m_wind.trouble());
}

void StationInputs::fill(StationStatus& status) const
{
    status.broker = m_broker.status();
    status.sensor = m_sensor.status();
    m_position.describe(status.position);
    m_wind.describe(status.wind);
    status.satellites = m_elements.satellites();
    status.elementProblems = m_elements.problems();
}

}  // namespace boresight

#include "moc_station_inputs.cpp"
