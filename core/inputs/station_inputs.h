// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/inputs/station_azel.h"
#include "core/inputs/station_broker.h"
#include "core/inputs/station_elements.h"
#include "core/inputs/station_follow.h"
#include "core/inputs/station_position.h"
#include "core/inputs/station_power.h"
#include "core/inputs/station_sensor.h"
#include "core/inputs/station_switches.h"
#include "core/inputs/station_tables.h"
#include "core/inputs/station_wind.h"

#include <QObject>

// All inputs of a station. Reports for the control go there directly: wind, positions, the Moon of WSJT-X, end
// switches. Station thread.
namespace boresight {

class StationInputs : public QObject
{
    Q_OBJECT

public:
    // All arguments but the parent outlive this.
    StationInputs(StationControl& control, StationSwitches::Pins pins, const profile::InForce& profile,
                  const Clock& clock, EventLog& log, QObject* parent);

    void open();
    void close();
    void profileChanged(const profile::Profile& before, const profile::Profile& after);

    // Of these two only the newest request waits.
    void readTable(const QString& path, StationTables::Then then);
    void findRotator(const QString& name, StationFollow::Then then);
    // The control has accepted this request. It may end the waiting.
    void noticed(const Request& request);
    // The mount goes nowhere from here on: nothing waits, and no rotator is followed.
    void forget();
    // Call before each tick of the control: the end switches.
    void tellSwitches() { m_control.takeEndSwitches(m_switches.read()); }
    // Call after it.
    void tick();

    [[nodiscard]] StationBroker& broker() { return m_broker; }
    [[nodiscard]] StationSensor& sensor() { return m_sensor; }
    [[nodiscard]] StationPower& power() { return m_power; }
    [[nodiscard]] const StationElements& elements() const { return m_elements; }
    // Fills in the parts of the status about the inputs.
    void fill(StationStatus& status) const;

private:
    StationControl& m_control;
    const Clock& m_clock;
    StationBroker m_broker;
    StationSensor m_sensor;
    StationPower m_power;
    StationElements m_elements;
    StationFollow m_follow;
    StationAzel m_azel;
    StationTables m_tables{this};
    StationPosition m_position;
    StationWind m_wind;
    StationSwitches m_switches;
};

}  // namespace boresight
