// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"
#include "core/sim/simulated_pair.h"
#include "core/sim/simulated_sensor.h"

#include <QObject>
#include <QTimer>

#include <optional>

// The orientation sensor of a simulated pair as a separate device. It reads the true position of the axes. Its messages
// go both to its serial port (SensorPort) and to its broker (SensorPublisher). It fails when the faults of the pair
// include it. Lives on the thread of its event loop.
namespace boresight::sim {

class SensorBox final : public QObject
{
    Q_OBJECT

public:
    // Pair and clock outlive the box. `epoch`: the time 0 of the pair.
    SensorBox(SimulatedPair& pair, const Clock& clock, SteadyTime epoch, const SensorTruth& truth);

    void start();  // starts a timer that calls read(). With a hand-turned clock call read() instead
    void read();

Q_SIGNALS:
    void said(const boresight::sim::SensorMessage& message);

private:
    SimulatedPair& m_pair;
    const Clock& m_clock;
    SteadyTime m_epoch;
    SimulatedSensor m_sensor;
    QTimer m_timer;
};

// One reading of a sensor on the antenna of this pair. Moves the pair on to the present first.
[[nodiscard]] std::optional<SensorMessage> readOn(SimulatedPair& pair, SteadyTime epoch, const Clock& clock,
                                                  SimulatedSensor& sensor);

}  // namespace boresight::sim
