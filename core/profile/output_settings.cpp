// SPDX-License-Identifier: GPL-3.0-or-later
// What this computer reads and switches beside the mount: received power, transmit output, brake, end switches.
#include "core/profile/output_settings.h"

#include "core/base/numbers.h"
#include "core/base/text.h"
#include "core/contacts/input_name.h"
#include "core/contacts/output_name.h"
#include "core/profile/setting_groups.h"
#include "core/profile/setting_makers.h"

#include <algorithm>
#include <initializer_list>
#include <tuple>

namespace boresight::profile {

using namespace makers;

namespace {

bool isByBroker(const std::string& output)
{
    const auto name = contacts::parseOutput(output);
    return name && name->kind == contacts::OutputKind::Mqtt;
}

// The serial port whose line is the output. Empty: the output is no such line.
std::string linePort(const std::string& output)
{
    const auto name = contacts::parseOutput(output);
    const bool isLine = name && (name->kind == contacts::OutputKind::Dtr || name->kind == contacts::OutputKind::Rts);
    return isLine ? name->place.toStdString() : std::string();
}

// Boresight would take an "on" or "off" for a command, or write over what it publishes. `isTaken`: it has another use.
void checkTopic(std::vector<Problem>& problems, const BrokerSettings& broker, const std::string& key,
                const std::string& topic, bool isTaken)
{
    const auto isOneOf = [&](std::initializer_list<const char*> names) {
        return std::ranges::any_of(names, [&](const char* name) { return topic == broker.topic(name); });
    };
    const bool takesCommands = broker.commands != BrokerCommands::Off;
    const bool publishes = broker.publish != Publish::Off;
    if (takesCommands && isOneOf({"command", "stop"})) {
        problems.push_back({key, Text::tr("Boresight takes each message of the topic %1 for a command (mqtt.commands). "
                                          "Choose another topic")
                                     .arg(toQString(topic))});
    } else if ((takesCommands && isOneOf({"answer"})) || (publishes && isOneOf({"state", "availability"})) || isTaken) {
        problems.push_back(
            {key, Text::tr("Boresight already uses the topic %1. Choose another topic").arg(toQString(topic))});
    }
}

// Boresight would take its own "on" and "off" for a reading.
void checkOutputTopic(std::vector<Problem>& problems, const Profile& profile, const std::string& key,
                      const std::string& output)
{
    if (isByBroker(output)) {
        const std::string topic = contacts::parseOutput(output)->place.toStdString();
        checkTopic(problems, profile.mqtt, key, topic, takesReadings(profile, topic));
    }
}

using end_switches::EndSwitch;

std::string keyOf(const EndSwitch& one)
{
    return std::string("end_switches.") + (one.axis == Axis::Azimuth ? "azimuth" : "elevation") +
           (one.isUpper ? "_upper" : "_lower");
}

contacts::InputName inputOf(const Profile& profile, const EndSwitch& one)
{
    return contacts::parseInput(profile.endSwitches.input(one)).value_or(contacts::InputName{});
}

bool hasBoards(const Profile& profile)
{
    return profile.azimuth.driver == AxisDriver::Moteus || profile.elevation.driver == AxisDriver::Moteus;
}

// The same pin cannot be an output and an input.
void checkBrakePin(std::vector<Problem>& problems, const Profile& profile)
{
    const auto output = contacts::parseOutput(profile.brake.output);
    if (!output || output->kind != contacts::OutputKind::Pin) {
        return;
    }
    const bool isInput = std::ranges::any_of(end_switches::kEndSwitches, [&](const EndSwitch& one) {
        const contacts::InputName input = inputOf(profile, one);
        return input.kind == contacts::InputKind::Pin && input.pin == output->pin;
    });
    if (!hasBoards(profile)) {
        problems.push_back({"brake.output", Text::tr("is a pin of a moteus, but no axis has a moteus")});
    } else if (isInput) {
        problems.push_back({"brake.output", Text::tr("is also the input of an end switch")});
    }
}

// Two switches at one input would close both of their ends together, and the axis could not move away.
void checkEndSwitch(std::vector<Problem>& problems, const Profile& profile, const EndSwitch& one)
{
    const contacts::InputName input = inputOf(profile, one);
    if (input.kind == contacts::InputKind::None) {
        return;
    }
    for (const EndSwitch& other : end_switches::kEndSwitches) {
        if (other != one && inputOf(profile, other) == input) {
            problems.push_back({keyOf(one), Text::tr("is also the input of %1. Each switch needs an input of its own")
                                                .arg(toQString(keyOf(other)))});
            return;
        }
    }
    if (input.kind == contacts::InputKind::Mqtt) {
        checkTopic(problems, profile.mqtt, keyOf(one), input.place.toStdString(), false);
    }
    if (input.kind == contacts::InputKind::Pin && !hasBoards(profile)) {
        problems.push_back({keyOf(one), Text::tr("is a pin of a moteus, but no axis has a moteus")});
    }
    const std::string port = input.place.toStdString();
    if (input.isLine() && (port == linePort(profile.transmit.output) || port == linePort(profile.brake.output))) {
        problems.push_back({keyOf(one), Text::tr("uses the port of the transmit output or of the brake output")});
    }
}

}  // namespace

bool isAnotherBroker(const BrokerSettings& before, const BrokerSettings& after)
{
    const auto connection = [](const BrokerSettings& broker) {
        return std::tie(broker.host, broker.port, broker.user, broker.password, broker.tls, broker.caFile,
                        broker.clientId);
    };
    return connection(before) != connection(after);
}

bool isAnotherOutput(const std::string& before, const BrokerSettings& brokerBefore, const std::string& after,
                     const BrokerSettings& brokerAfter)
{
    return before != after || (isByBroker(after) && isAnotherBroker(brokerBefore, brokerAfter));
}

void addPower(std::vector<Setting>& list)
{
    list.push_back(choice(
        "power.source",
        {{"none", QT_TRANSLATE_NOOP("Text", "None")},
         {"udp", QT_TRANSLATE_NOOP("Text", "Listen by UDP")},
         {"tcp", QT_TRANSLATE_NOOP("Text", "Connect by TCP")}},
        Applies::Now,
        {QT_TRANSLATE_NOOP("Text", "Source"),
         QT_TRANSLATE_NOOP("Text",
                           "Whether a receiver reports the received power for the cross scan, one number in dB per "
                           "line. \"udp\" listens for it, \"tcp\" connects to it.")},
        [](auto& p) -> auto& { return p.power.source; }));
    list.push_back(textual(
        "power.host", Applies::Now,
        {QT_TRANSLATE_NOOP("Text", "Host"),
         QT_TRANSLATE_NOOP(
             "Text",
             "UDP: the address of this computer to listen on. 127.0.0.1 receives from this computer only, 0.0.0.0 from "
             "all computers. TCP: name or address of the computer with the receiver.")},
        [](const Profile& p) { return p.power.host; },
        [](Profile& p, const std::string& wanted) { return checkHost(wanted).map([&] { p.power.host = wanted; }); }));
    list.push_back(integer(
        "power.port", "", {1, 65535}, Applies::Now,
        {QT_TRANSLATE_NOOP("Text", "Port"), QT_TRANSLATE_NOOP("Text", "UDP or TCP port of the received power.")},
        [](auto& p) -> auto& { return p.power.port; }));
}

void addTransmit(std::vector<Setting>& list)
{
    list.push_back(textual(
        "transmit.output", Applies::Now,
        {QT_TRANSLATE_NOOP("Text", "Output"),
         QT_TRANSLATE_NOOP(
             "Text",
             "An output that is on only while the beam is on its target: file:PATH, mqtt:TOPIC, command:PROGRAM with "
             "its arguments, dtr:PORT or rts:PORT. Use it as the interlock of the transmitter. Empty: none.")},
        [](const Profile& p) { return p.transmit.output; },
        [](Profile& p, const std::string& wanted) {
            return contacts::parseOutput(wanted).and_then([&](const contacts::OutputName& name) -> Result<> {
                if (name.kind == contacts::OutputKind::Pin) {
                    return failure(ErrorCode::InvalidInput,
                                   Text::tr("a pin of a moteus can only be a brake output (brake.output)"));
                }
                p.transmit.output = wanted;
                return {};
            });
        }));
    list.push_back(number(
        "transmit.beam_fraction", "", {0.01, 1.0}, Applies::Now,
        {QT_TRANSLATE_NOOP("Text", "Part of the beam width"),
         QT_TRANSLATE_NOOP("Text",
                           "The output is on while the beam is nearer to the target than this part of the beam width. "
                           "At 0.5 the antenna sends half of its best power to the target.")},
        [](auto& p) -> auto& { return p.transmit.beamFraction; }));
    list.push_back(choice(
        "transmit.in_simulation", offOn(), Applies::Now,
        {QT_TRANSLATE_NOOP("Text", "Also with a simulated mount"),
         QT_TRANSLATE_NOOP("Text",
                           "With \"off\" the output stays off while the mount is simulated, because the real antenna "
                           "points elsewhere.")},
        [](auto& p) -> auto& { return p.transmit.inSimulation; }));
}

void addBrake(std::vector<Setting>& list)
{
    list.push_back(textual(
        "brake.output", Applies::Now,
        {QT_TRANSLATE_NOOP("Text", "Output"),
         QT_TRANSLATE_NOOP(
             "Text",
             "An output that is on while the brakes of the axes are released: file:PATH, mqtt:TOPIC, command:PROGRAM "
             "with its arguments, dtr:PORT, rts:PORT or moteus:ID:aux1.PIN. Nothing moves before it is on. A pin stays "
             "on "
             "when Boresight dies, so wire the brakes to close without power. Empty: no brake.")},
        [](const Profile& p) { return p.brake.output; },
        [](Profile& p, const std::string& wanted) {
            return contacts::parseOutput(wanted).map([&](const contacts::OutputName&) { p.brake.output = wanted; });
        }));
    list.push_back(number(
        "brake.switching_s", "s", {0.0, 10.0}, Applies::Now,
        {QT_TRANSLATE_NOOP("Text", "Time to open or to close"),
         QT_TRANSLATE_NOOP("Text",
                           "The time that the brakes need to open or to close. Boresight waits for this time before it "
                           "moves the mount. When Boresight ends, it waits again before it releases the drives.")},
        [](auto& p) -> auto& { return p.brake.switching; }));
    list.push_back(number(
        "brake.set_after_s", "s", {0.5, 3600.0}, Applies::Now,
        {QT_TRANSLATE_NOOP("Text", "Set after"),
         QT_TRANSLATE_NOOP("Text",
                           "The brakes are set when nothing has moved for this time. After STOP and after a fault they "
                           "are set as soon as the mount stands still.")},
        [](auto& p) -> auto& { return p.brake.setAfter; }));
}

void addEndSwitches(std::vector<Setting>& list)
{
    const auto input = [&list](const EndSwitch& one, const char* title) {
        list.push_back(textual(
            keyOf(one), Applies::Now,
            {title,
             QT_TRANSLATE_NOOP("Text",
                               "The input of the switch at this end of the axis: moteus:ID:aux1.PIN, mqtt:TOPIC, "
                               "cts:PORT, dsr:PORT, dcd:PORT or ri:PORT. While the switch is pressed, nothing "
                               "moves the axis further into this end. Empty: no switch.")},
            [one](const Profile& p) { return p.endSwitches.input(one); },
            [one](Profile& p, const std::string& wanted) {
                return contacts::parseInput(wanted).map(
                    [&](const contacts::InputName&) { p.endSwitches.inputs.at(end_switches::indexOf(one)) = wanted; });
            }));
    };
    const auto place = [&list](const EndSwitch& one, const char* title) {
        list.push_back(textual(
            keyOf(one) + "_at_deg", Applies::Now,
            {title, QT_TRANSLATE_NOOP("Text",
                                      "The angle of the axis at which it meets this switch. An axis that meets it "
                                      "elsewhere has lost steps. Empty: not compared.")},
            [one](const Profile& p) { return p.endSwitches.places.at(end_switches::indexOf(one)); },
            [one](Profile& p, const std::string& wanted) -> Result<> {
                const auto degrees = parseFinite(wanted);
                if (!wanted.empty() && (!degrees || *degrees < -720.0 || *degrees > 900.0)) {
                    return failure(ErrorCode::InvalidInput,
                                   Text::tr("an angle of the axis in degrees is expected, like -3.5, or nothing"));
                }
                p.endSwitches.places.at(end_switches::indexOf(one)) = wanted;
                return {};
            }));
    };
    input({Axis::Azimuth, false}, QT_TRANSLATE_NOOP("Text", "Azimuth, lower end"));
    input({Axis::Azimuth, true}, QT_TRANSLATE_NOOP("Text", "Azimuth, upper end"));
    input({Axis::Elevation, false}, QT_TRANSLATE_NOOP("Text", "Elevation, lower end"));
    input({Axis::Elevation, true}, QT_TRANSLATE_NOOP("Text", "Elevation, upper end"));
    place({Axis::Azimuth, false}, QT_TRANSLATE_NOOP("Text", "Azimuth, lower end at"));
    place({Axis::Azimuth, true}, QT_TRANSLATE_NOOP("Text", "Azimuth, upper end at"));
    place({Axis::Elevation, false}, QT_TRANSLATE_NOOP("Text", "Elevation, lower end at"));
    place({Axis::Elevation, true}, QT_TRANSLATE_NOOP("Text", "Elevation, upper end at"));
    list.push_back(number(
        "end_switches.lost_steps_deg", "°", {0.5, 45.0}, Applies::Now,
        {QT_TRANSLATE_NOOP("Text", "Lost steps beyond"),
         QT_TRANSLATE_NOOP("Text",
                           "An axis that meets a switch farther than this from the angle of the switch has lost steps. "
                           "A rotator that reports its position seldom needs a larger value.")},
        [](auto& p) -> auto& { return p.endSwitches.lostSteps; }));
    list.push_back(choice(
        "end_switches.pressed_when",
        {{"off", QT_TRANSLATE_NOOP("Text", "Input is off")}, {"on", QT_TRANSLATE_NOOP("Text", "Input is on")}},
        Applies::Now,
        {QT_TRANSLATE_NOOP("Text", "Pressed when"),
         QT_TRANSLATE_NOOP("Text",
                           "What the input reads while its switch is pressed. \"off\" suits a switch that opens its "
                           "circuit when it is pressed: a broken wire then counts as pressed.")},
        [](auto& p) -> auto& { return p.endSwitches.pressedWhen; }));
    list.push_back(choice(
        "end_switches.when_unread",
        {{"pressed", QT_TRANSLATE_NOOP("Text", "Counts as pressed")},
         {"ignored", QT_TRANSLATE_NOOP("Text", "Alarm only")}},
        Applies::Now,
        {QT_TRANSLATE_NOOP("Text", "If it cannot be read"),
         QT_TRANSLATE_NOOP(
             "Text",
             "Both raise an alarm. \"pressed\" also permits no motion into the end of a switch that cannot "
             "be read.")},
        [](auto& p) -> auto& { return p.endSwitches.whenUnread; }));
    list.push_back(number(
        "end_switches.silence_s", "s", {0.5, 600.0}, Applies::Now,
        {QT_TRANSLATE_NOOP("Text", "Longest silence"),
         QT_TRANSLATE_NOOP("Text",
                           "MQTT: without a message for this long the switch cannot be read. The sender has to repeat "
                           "its messages more often than this.")},
        [](auto& p) -> auto& { return p.endSwitches.silence; }));
}

void checkPower(std::vector<Problem>& problems, const Profile& profile)
{
    if (profile.power.source == PowerSource::Udp && !checkAddress(profile.power.host)) {
        problems.push_back(
            {"power.host", Text::tr("an address of this computer is expected while power.source is \"udp\"")});
    }
}

void checkTransmit(std::vector<Problem>& problems, const Profile& profile)
{
    checkOutputTopic(problems, profile, "transmit.output", profile.transmit.output);
}

void checkBrake(std::vector<Problem>& problems, const Profile& profile)
{
    checkOutputTopic(problems, profile, "brake.output", profile.brake.output);
    checkBrakePin(problems, profile);
    if (!profile.brake.output.empty() && profile.brake.output == profile.transmit.output) {
        problems.push_back({"brake.output", Text::tr("is also the transmit output (transmit.output)")});
    } else if (const std::string port = linePort(profile.brake.output);
               !port.empty() && port == linePort(profile.transmit.output)) {
        problems.push_back({"brake.output", Text::tr("uses the port of the transmit output (transmit.output)")});
    }
}

void checkEndSwitches(std::vector<Problem>& problems, const Profile& profile)
{
    for (const EndSwitch& one : end_switches::kEndSwitches) {
        checkEndSwitch(problems, profile, one);
    }
}

}  // namespace boresight::profile
