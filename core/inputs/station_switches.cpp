// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/inputs/station_switches.h"

#include "core/base/text.h"
#include "core/status_lines/serial_status_port.h"

#include <algorithm>
#include <utility>

namespace boresight {
namespace {

using contacts::InputKind;
using contacts::InputReading;

const QString kSwitchSource = QStringLiteral("end switch");
constexpr int kSwitchLinesPerSecond = 1;

std::unique_ptr<status_lines::LineReader> readerOf(const QString& port, const Clock& clock)
{
    const auto opened = std::make_shared<status_lines::SerialStatusPort>(port);
    return std::make_unique<status_lines::LineReader>([opened] { return opened->read(); }, clock);
}

}  // namespace

StationSwitches::StationSwitches(const profile::InForce& profile, Pins pins, EventLog& log, const Clock& clock,
                                 StationBroker& broker, QObject* parent)
    : QObject(parent),
      m_profile(profile),
      m_pins(std::move(pins)),
      m_clock(clock),
      m_broker(broker),
      m_lines(log, clock, kSwitchLinesPerSecond)
{}

void StationSwitches::open()
{
    close();
    m_open = true;
    for (const end_switches::EndSwitch& one : end_switches::kEndSwitches) {
        Input& input = m_inputs.at(end_switches::indexOf(one));
        input.name = contacts::parseInput(m_profile->endSwitches.input(one)).value_or(contacts::InputName{});
        if (isElsewhere(input.name)) {
            continue;
        }
        if (input.name.kind == InputKind::Mqtt) {
            openTopic(end_switches::indexOf(one), input.name.place);
        } else if (input.name.isLine()) {
            auto& reader = m_ports[input.name.place];
            reader = reader ? std::move(reader) : readerOf(input.name.place, m_clock);
        }
    }
}

void StationSwitches::openTopic(std::size_t number, const QString& topic)
{
    Topic& opened = m_inputs.at(number).topic;
    opened.inlet = std::make_unique<MessageInlet>(kSwitchSource, m_broker, this);
    connect(opened.inlet.get(), &MessageInlet::received, this,
            [this, &opened](const QByteArray& message) { take(opened, message); });
    opened.inlet->openTopic(topic);
}

void StationSwitches::close()
{
    m_open = false;
    for (Input& input : m_inputs) {
        if (input.topic.inlet) {
            input.topic.inlet->close();
        }
        input = {};
    }
    m_ports.clear();
}

void StationSwitches::profileChanged(const profile::Profile& before, const profile::Profile& after)
{
    if (m_open && before.endSwitches != after.endSwitches) {
        open();
    }
}

void StationSwitches::take(Topic& topic, const QByteArray& message)
{
    const Result<bool> read = contacts::readContact({message.constData(), static_cast<std::size_t>(message.size())});
    if (!read) {
        m_lines.add(Severity::Warning, kSwitchSource,
                    Text::tr("a message about a switch was refused: %1").arg(read.error().text));
        return;
    }
    topic.isOn = *read;
    topic.received = m_clock.now();
}

InputReading StationSwitches::readTopic(const Topic& topic) const
{
    if (const QString trouble = topic.inlet->trouble(); !trouble.isEmpty()) {
        return {.problem = trouble};
    }
    const Seconds silence = m_profile->endSwitches.silence;
    if (topic.isOn && m_clock.now() - topic.received > silence) {
        return {.problem = Text::tr("no message for %1 s").arg(silence.count())};
    }
    return {.isOn = topic.isOn};
}

bool StationSwitches::isElsewhere(const contacts::InputName& name) const
{
    const bool isOfAnAxis = name.kind == InputKind::Pin && std::ranges::any_of(kAxes, [&](Axis axis) {
                                const profile::AxisSettings& settings = m_profile->axis(axis);
                                return settings.driver == profile::AxisDriver::Moteus && settings.id == name.pin.board;
                            });
    return m_pins.simulated && !isOfAnAxis;
}

InputReading StationSwitches::readOf(const Input& input) const
{
    if (input.name.kind == InputKind::None) {
        return {};
    }
    if (isElsewhere(input.name)) {
        return {.isOn = m_profile->endSwitches.pressedWhen == profile::PressedWhen::Off};
    }
    if (input.name.kind == InputKind::Pin) {
        return m_pins.read(input.name.pin);
    }
    return input.topic.inlet ? readTopic(input.topic) : m_ports.at(input.name.place)->reading(input.name.kind);
}

EndSwitchGuard::Readings StationSwitches::read()
{
    for (const auto& [path, reader] : m_ports) {
        reader->poll();
    }
    EndSwitchGuard::Readings readings;
    std::ranges::transform(m_inputs, readings.begin(), [this](const Input& input) { return readOf(input); });
    return readings;
}

}  // namespace boresight

#include "moc_station_switches.cpp"
