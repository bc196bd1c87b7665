// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/sim_sensor/sensor_port.h"

#include <unistd.h>

#include <utility>

namespace boresight::sim {

Result<std::unique_ptr<SensorPort>> SensorPort::create(const QString& link, SensorBox& box)
{
    return PseudoTerminal::create(link).map([&](PseudoTerminal&& terminal) {
        return std::unique_ptr<SensorPort>(new SensorPort(std::move(terminal), box));
    });
}

SensorPort::SensorPort(PseudoTerminal terminal, SensorBox& box) : m_terminal(std::move(terminal))
{
    connect(&box, &SensorBox::said, this, &SensorPort::write);
}

void SensorPort::write(const SensorMessage& message) const
{
    if (m_terminal.hasClient()) {
        const std::string sentence = toSentence(message);
        // Bytes that do not fit are lost, as on a line that nobody reads.
        [[maybe_unused]] const ssize_t sent = ::write(m_terminal.number(), sentence.data(), sentence.size());
    }
}

}  // namespace boresight::sim

#include "moc_sensor_port.cpp"
