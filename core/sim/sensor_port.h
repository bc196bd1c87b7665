// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"
#include "core/sim/pseudo_terminal.h"
#include "core/sim/simulated_pair.h"
#include "core/sim/simulated_sensor.h"

#include <QObject>
#include <QTimer>

#include <memory>

// The orientation sensor of a simulated pair as a device file: its sentences on a pseudo-terminal. Says nothing to
// nobody: who opens it hears from the next sentence on. Lives on the thread of its event loop; never blocks.
namespace boresight::sim {

class SensorPort final : public QObject
{
    Q_OBJECT

public:
    // Clock and pair outlive the port; the pair's time 0 was at `epoch`. Refused if `link` exists and is no symbolic
    // link.
    [[nodiscard]] static Result<std::unique_ptr<SensorPort>> create(const QString& link, SimulatedPair& pair,
                                                                    const Clock& clock, SteadyTime epoch);

    [[nodiscard]] const QString& device() const { return m_terminal.device(); }
    [[nodiscard]] SimulatedSensor& sensor() { return m_sensor; }

private:
    SensorPort(PseudoTerminal terminal, SimulatedPair& pair, const Clock& clock, SteadyTime epoch);
    void read();

    PseudoTerminal m_terminal;
    SimulatedPair& m_pair;
    const Clock& m_clock;
    SteadyTime m_epoch;
    SimulatedSensor m_sensor;
    QTimer m_timer;
};

}  // namespace boresight::sim
