// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/sim_bus/pseudo_terminal.h"
#include "core/sim_sensor/sensor_box.h"

#include <QObject>

#include <memory>

// The serial port of a simulated orientation sensor as a device file: its sentences on a pseudo-terminal. Nothing is
// written while no client has opened the file. A client receives from the next sentence on. Lives on the thread of its
// event loop. Never blocks.
namespace boresight::sim {

class SensorPort final : public QObject
{
    Q_OBJECT

public:
    // The box outlives the port. Refused if `link` exists and is not a symbolic link.
    [[nodiscard]] static Result<std::unique_ptr<SensorPort>> create(const QString& link, SensorBox& box);

    [[nodiscard]] const QString& device() const { return m_terminal.device(); }

private:
    SensorPort(PseudoTerminal terminal, SensorBox& box);
    void write(const SensorMessage& message) const;

    PseudoTerminal m_terminal;
};

}  // namespace boresight::sim
