// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/alarms/alarm_board.h"
#include "core/alarms/log_throttle.h"
#include "core/base/clock.h"
#include "core/contacts/output_name.h"
#include "core/messages/station_status.h"
#include "core/outputs/output.h"
#include "core/profile/in_force.h"
#include "core/transmit/transmit_gate.h"

#include <QObject>

#include <functional>
#include <memory>
#include <optional>

// Keeps the transmitter off until the beam is on its target. Switches the output that the profile names, as
// TransmitGate decides. The output is off after open(), at close(), after each change of the profile, and when it
// fails. Station thread; outputs have threads of their own for files, ports and programs.
namespace boresight {

class StationTransmit : public QObject
{
    Q_OBJECT

public:
    using MakeOutput = std::function<std::unique_ptr<outputs::Output>(const contacts::OutputName& name)>;

    // An older measured position does not count, because the beam may be elsewhere.
    static constexpr std::chrono::milliseconds kOldestReport{500};
    // The output is set again after this time. So a lost output is found, and its reader knows that Boresight is alive.
    static constexpr std::chrono::seconds kRepeat{1};
    // An output that failed while it should be on stays off for this time.
    static constexpr std::chrono::seconds kStaysOff{10};
    // An output that does not answer within this time has failed.
    static constexpr std::chrono::seconds kPatience{5};

    // All arguments but the parent outlive this. Any thread may read the clock.
    StationTransmit(const profile::InForce& profile, bool simulated, const Clock& clock, EventLog& log,
                    AlarmBoard& alarms, QObject* parent);
    ~StationTransmit() override;

    // Replaces how outputs are made. Call before open().
    void setMaker(MakeOutput make) { m_make = std::move(make); }

    void open();
    // Switches the output off without waiting for its answer. The destructor waits.
    void close();
    void profileChanged(const profile::Profile& before, const profile::Profile& after);

    [[nodiscard]] bool isWanted() const { return m_output != nullptr; }
    // Call each tick with the status of the control. Does nothing unless isWanted().
    void tick(const StationStatus& status);
    [[nodiscard]] TransmitStatus status() const;

private:
    // The last order to the output, and its answer.
    struct Switching
    {
        bool ordered = false;
        bool isOn = false;  // by its last answer
        std::optional<SteadyTime> orderedAt = {};
        std::optional<SteadyTime> unanswered = {};  // the oldest order without an answer
        std::optional<SteadyTime> failedOn = {};    // when it failed while it should be on
        QString problem = {};
    };

    [[nodiscard]] std::unique_ptr<outputs::Output> make(const contacts::OutputName& name) const;
    void begin();
    void retire();
    void settleAnew();
    [[nodiscard]] transmit::GateInput inputOf(const StationStatus& status) const;
    void order(bool on);
    void reached(bool on);
    void fail(const QString& reason);
    void show(bool on);

    const profile::InForce& m_profile;
    bool m_simulated;
    const Clock& m_clock;
    LogThrottle m_lines;
    AlarmBoard& m_alarms;
    MakeOutput m_make;
    bool m_open = false;
    std::unique_ptr<outputs::Output> m_output;  // null: the profile names none, or m_former has to end first
    std::unique_ptr<outputs::Output> m_former;  // the previous output, until it is off
    Angle m_within;                             // permitted distance to the target for the antenna in use
    transmit::TransmitGate m_gate;
    transmit::GateDecision m_decision;
    Switching m_switching;
};

}  // namespace boresight
