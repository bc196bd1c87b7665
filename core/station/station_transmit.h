// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/alarms/alarm_board.h"
#include "core/alarms/log_throttle.h"
#include "core/base/clock.h"
#include "core/messages/station_status.h"
#include "core/outputs/named_output.h"
#include "core/profile/in_force.h"
#include "core/transmit/transmit_gate.h"

#include <QObject>

#include <optional>

// Keeps the transmitter off until the beam is on its target. Switches the output that the profile names, as
// TransmitGate decides. The output is off after open(), at close(), after each change of the profile, and when it
// fails. Station thread; outputs have threads of their own for files, ports and programs.
namespace boresight {

class StationTransmit : public QObject
{
    Q_OBJECT

public:
    // An older measured position does not count, because the beam may be elsewhere.
    static constexpr std::chrono::milliseconds kOldestReport{500};
    // An output that failed while it should be on stays off for this time.
    static constexpr std::chrono::seconds kStaysOff{10};

    // All arguments but the parent outlive this. Any thread may read the clock.
    StationTransmit(const profile::InForce& profile, bool simulated, const Clock& clock, EventLog& log,
                    AlarmBoard& alarms, QObject* parent);
    ~StationTransmit() override;

    // Replaces how outputs are made. Call before open().
    void setMaker(outputs::NamedOutput::Make make) { m_output.setMaker(std::move(make)); }

    void open();
    // Switches the output off without waiting for its answer. The destructor waits.
    void close();
    void profileChanged(const profile::Profile& before, const profile::Profile& after);

    [[nodiscard]] bool isWanted() const { return m_output.isThere(); }
    // Call each tick with the status of the control. Does nothing unless isWanted().
    void tick(const StationStatus& status);
    [[nodiscard]] TransmitStatus status() const;

private:
    void forget();
    void settleAnew();
    [[nodiscard]] transmit::GateInput inputOf(const StationStatus& status) const;
    void reached(bool on);
    void fail(const QString& reason);
    void show(bool on);

    const profile::InForce& m_profile;
    bool m_simulated;
    const Clock& m_clock;
    LogThrottle m_lines;
    AlarmBoard& m_alarms;
    outputs::NamedOutput m_output;
    Angle m_within;  // permitted distance to the target for the antenna in use
    transmit::TransmitGate m_gate;
    transmit::GateDecision m_decision;
    std::optional<SteadyTime> m_failedOn;  // when the output failed while it should be on
    QString m_problem;                     // until the output is as decided
};

}  // namespace boresight
