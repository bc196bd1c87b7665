// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/alarms/alarm_board.h"
#include "core/alarms/log_throttle.h"
#include "core/base/clock.h"
#include "core/messages/station_status.h"
#include "core/profile/in_force.h"
#include "core/transmit/output_name.h"
#include "core/transmit/transmit_gate.h"
#include "core/transmit_output/transmit_output.h"

#include <QObject>

#include <functional>
#include <memory>
#include <optional>

// Holds the transmitter until the beam is on its target: the output that the profile names, switched as TransmitGate
// decides. Off from open() on, at close(), after each change of the profile, and whenever its output fails. Station
// thread. What an output does with files, ports and programs has threads of its own.
namespace boresight {

class StationTransmit : public QObject
{
    Q_OBJECT

public:
    using MakeOutput = std::function<std::unique_ptr<transmit::TransmitOutput>(const transmit::OutputName& name)>;

    // Measured before that is no position: the beam may be elsewhere.
    static constexpr std::chrono::milliseconds kOldestReport{500};
    // The output is set again, so that one that was lost is found and its reader knows that Boresight is alive.
    static constexpr std::chrono::seconds kRepeat{1};
    // An output that failed to be on stays off for so long.
    static constexpr std::chrono::seconds kStaysOff{10};
    // An output that does not answer has failed.
    static constexpr std::chrono::seconds kPatience{5};

    // All but the parent outlive this. Any thread may read the clock.
    StationTransmit(const profile::InForce& profile, bool simulated, const Clock& clock, EventLog& log,
                    AlarmBoard& alarms, QObject* parent);
    ~StationTransmit() override;

    // In place of the outputs of this computer. Before open().
    void setMaker(MakeOutput make) { m_make = std::move(make); }

    void open();
    // Off, without waiting for it. The end of this waits.
    void close();
    void profileChanged(const profile::Profile& before, const profile::Profile& after);

    [[nodiscard]] bool isWanted() const { return m_output != nullptr; }
    // Each tick while it is wanted, with what the control knows. Else it does nothing.
    void tick(const StationStatus& status);
    [[nodiscard]] TransmitStatus status() const;

private:
    // What the output was asked for, and what it answered.
    struct Switching
    {
        bool ordered = false;
        bool isOn = false;  // by its last word
        std::optional<SteadyTime> orderedAt = {};
        std::optional<SteadyTime> unanswered = {};  // the oldest order without an answer
        std::optional<SteadyTime> failedOn = {};    // failed to be on
        QString problem = {};
    };

    [[nodiscard]] std::unique_ptr<transmit::TransmitOutput> make(const transmit::OutputName& name) const;
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
    std::unique_ptr<transmit::TransmitOutput> m_output;  // null: none is named, or another one has to end first
    std::unique_ptr<transmit::TransmitOutput> m_former;  // until it is off
    Angle m_within;                                      // of the target, for the antenna in use
    transmit::TransmitGate m_gate;
    transmit::GateDecision m_decision;
    Switching m_switching;
};

}  // namespace boresight
