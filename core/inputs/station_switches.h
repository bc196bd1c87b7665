// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/alarms/log_throttle.h"
#include "core/contacts/input_name.h"
#include "core/end_switches/end_switch.h"
#include "core/guards/end_switch_guard.h"
#include "core/inputs/message_inlet.h"
#include "core/profile/in_force.h"
#include "core/status_lines/line_reader.h"

#include <QObject>
#include <QString>

#include <array>
#include <functional>
#include <map>
#include <memory>
#include <optional>

// Reads the inputs of the end switches: pins of the mount, topics of the broker, lines of serial ports. With a
// simulated mount only the pins of its own boards are read: every other switch is at the real antenna, and counts as
// free. Station thread.
namespace boresight {

class StationSwitches : public QObject
{
    Q_OBJECT

public:
    // The pins of the boards of the mount.
    struct Pins
    {
        std::function<contacts::InputReading(const contacts::BoardPin&)> read;
        bool simulated = false;
    };

    // All arguments but the parent outlive this.
    StationSwitches(const profile::InForce& profile, Pins pins, EventLog& log, const Clock& clock,
                    StationBroker& broker, QObject* parent);

    void open();
    void close();
    void profileChanged(const profile::Profile& before, const profile::Profile& after);
    // Once per tick, before the control.
    [[nodiscard]] EndSwitchGuard::Readings read();

private:
    // A switch that is read from a topic.
    struct Topic
    {
        std::unique_ptr<MessageInlet> inlet;
        std::optional<bool> isOn;
        SteadyTime received{};
    };
    struct Input
    {
        contacts::InputName name;
        Topic topic;
    };

    void openTopic(std::size_t number, const QString& topic);
    void take(Topic& topic, const QByteArray& message);
    [[nodiscard]] contacts::InputReading readTopic(const Topic& topic) const;
    [[nodiscard]] contacts::InputReading readOf(const Input& input) const;
    [[nodiscard]] bool isElsewhere(const contacts::InputName& name) const;

    const profile::InForce& m_profile;
    Pins m_pins;
    const Clock& m_clock;
    StationBroker& m_broker;
    LogThrottle m_lines;
    std::array<Input, end_switches::kEndSwitches.size()> m_inputs;
    std::map<QString, std::unique_ptr<status_lines::LineReader>> m_ports;  // one for all switches of a port
    bool m_open = false;
};

}  // namespace boresight
