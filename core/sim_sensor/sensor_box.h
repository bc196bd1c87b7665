// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"
#include "core/sim/simulated_pair.h"
#include "core/sim/simulated_sensor.h"

#include <QObject>
#include <QTimer>

#include <optional>

// The orientation sensor of a simulated pair as a box of its own, as it hangs on the boom: it reads where the axes
// truly are, and what it says goes to its serial port (SensorPort) and to its broker (SensorPublisher) alike. It fails
// when the pair's faults say so. Lives on the thread of its event loop.
namespace boresight::sim {

class SensorBox final : public QObject
{
    Q_OBJECT

public:
    // Pair and clock outlive the box; the pair's time 0 was at `epoch`.
    SensorBox(SimulatedPair& pair, const Clock& clock, SteadyTime epoch, const SensorTruth& truth);

    void start();  // from now on it reads by a timer of its own; with a hand-turned clock call read() in its place
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

// One reading of a sensor on the antenna of this pair, which is brought up to the present first.
[[nodiscard]] std::optional<SensorMessage> readOn(SimulatedPair& pair, SteadyTime epoch, const Clock& clock,
                                                  SimulatedSensor& sensor);

}  // namespace boresight::sim
