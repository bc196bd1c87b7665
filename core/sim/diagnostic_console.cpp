// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/sim/diagnostic_console.h"

#include "core/base/numbers.h"

#include <algorithm>
#include <array>
#include <set>

namespace boresight::sim {
namespace {

using moteus::Mode;

constexpr std::size_t kLongestLine = 100;
constexpr std::size_t kMostPending = 65536;  // nobody reads: forget rather than grow
constexpr double kShortestPeriod = 0.01;     // s

constexpr std::string_view kOk = "OK\r\n";

std::string refusal(std::string_view why)
{
    return "ERR " + std::string(why) + "\r\n";
}

// Cuts the first word off.
std::string_view takeWord(std::string_view& text)
{
    const std::size_t start = std::min(text.find_first_not_of(' '), text.size());
    text.remove_prefix(start);
    const std::string_view word = text.substr(0, text.find(' '));
    text.remove_prefix(std::min(word.size() + 1, text.size()));
    return word;
}

std::optional<double> takeNumber(std::string_view& text)
{
    const std::string_view word = takeWord(text);
    return word == "nan" ? kNone : parseFinite(word);
}

std::string lengthBytes(std::size_t size)
{
    std::string bytes;
    for (int i = 0; i < 4; ++i, size >>= 8) {
        bytes.push_back(static_cast<char>(size & 0xff));
    }
    return bytes;
}

std::string_view groupOf(std::string_view key)
{
    return key.substr(0, key.find('.'));
}

std::string_view keyError(DriveConfig& config, std::string_view key, std::string_view withinGroup)
{
    bool known = false;
    visitFields(config, [&](std::string_view name, ConfigField) { known = known || groupOf(name) == groupOf(key); });
    return known ? withinGroup : "unknown group";
}

ArchiveValue archived(const ConfigField& field)
{
    if (const auto* number = std::get_if<double*>(&field)) {
        return static_cast<float>(**number);
    }
    if (const auto* number = std::get_if<int*>(&field)) {
        return ArchiveSigned{.value = **number, .width = 4};
    }
    if (const auto* flag = std::get_if<bool*>(&field)) {
        return **flag;
    }
    return ArchiveArray{.values = {*std::get<std::uint8_t*>(field)}, .width = 1};
}

// The fields of one group; consecutive numbered keys fold into one array.
std::vector<ArchiveField> archivedGroup(DriveConfig& config, std::string_view group)
{
    std::vector<ArchiveField> fields;
    visitFields(config, [&](std::string_view key, ConfigField field) {
        if (groupOf(key) != group) {
            return;
        }
        std::string name(key.substr(group.size() + 1));
        ArchiveValue value = archived(field);
        auto* element = std::get_if<ArchiveArray>(&value);
        if (element != nullptr) {
            name.resize(name.rfind('.'));
            if (!fields.empty() && fields.back().name == name) {
                std::get<ArchiveArray>(fields.back().value).values.push_back(element->values.front());
                return;
            }
        }
        fields.push_back({std::move(name), std::move(value)});
    });
    return fields;
}

// "p1.5" is kp scale 1.5 and so on. False for a letter that does not exist or is not permitted here.
bool applyOption(ServoCommand& command, std::string_view option, std::string_view permitted)
{
    const std::optional<double> number = option.substr(1) == "nan" ? kNone : parseFinite(option.substr(1));
    if (!number || permitted.find(option[0]) == std::string_view::npos) {
        return false;
    }
    switch (option[0]) {
        case 'p':
            command.kpScale = *number;
            break;
        case 'd':
            command.kdScale = *number;
            break;
        case 'i':
            command.integralLimitScale = *number;
            break;
        case 's':
            command.stopPosition = *number;
            break;
        case 'f':
            command.feedforwardTorque = *number;
            break;
        case 't':
            command.watchdogTimeout = *number;
            break;
        case 'v':
            command.velocityLimit = *number;
            break;
        case 'a':
            command.accelerationLimit = *number;
            break;
        case 'b':
            command.ignorePositionBounds = *number != 0.0;
            break;
        default:  // o, c: fixed voltage and current override the encoder; understood, without effect here
            break;
    }
    return true;
}

bool applyOptions(ServoCommand& command, std::string_view rest, std::string_view permitted)
{
    for (std::string_view option = takeWord(rest); !option.empty(); option = takeWord(rest)) {
        if (!applyOption(command, option, permitted)) {
            return false;
        }
    }
    return true;
}

}  // namespace

void DiagnosticConsole::receive(std::span<const std::uint8_t> text)
{
    for (const std::uint8_t byte : text) {
        if (byte != '\r' && byte != '\n') {
            m_input.push_back(static_cast<char>(byte));
            continue;
        }
        const std::string line = std::exchange(m_input, {});
        if (!line.empty() && line.size() <= kLongestLine) {
            execute(line);
        }
    }
    if (m_input.size() > kLongestLine) {
        m_input.resize(kLongestLine + 1);  // too long whatever follows; dropped at its end
    }
}

void DiagnosticConsole::advance(double dt)
{
    for (auto& [name, channel] : m_channels) {
        if (channel.period <= 0.0) {
            continue;
        }
        channel.elapsed += dt;
        if (channel.elapsed >= channel.period && m_output.size() < kMostPending) {
            channel.elapsed = 0.0;
            m_output += emit(name);
        }
    }
}

void DiagnosticConsole::reset()
{
    m_input.clear();
    m_output.clear();
    m_channels.clear();
}

std::span<const std::uint8_t> DiagnosticConsole::pending() const
{
    return {reinterpret_cast<const std::uint8_t*>(m_output.data()), m_output.size()};
}

void DiagnosticConsole::drop(std::size_t count)
{
    m_output.erase(0, count);
}

void DiagnosticConsole::execute(std::string_view line)
{
    const std::string_view group = takeWord(line);
    const std::string_view command = takeWord(line);
    if (group == "conf") {
        m_output += conf(command, line);
    } else if (group == "tel") {
        m_output += tel(command, line);
    } else if (group == "d") {
        m_output += drive(command, line);
    } else {
        m_output += refusal("unknown command");
    }
}

std::string DiagnosticConsole::conf(std::string_view command, std::string_view rest)
{
    if (command == "get") {
        const Result<std::string> text = configText(m_device.config(), rest);
        return text ? *text + "\r\n" : refusal(keyError(m_device.config(), rest, "error reading"));
    }
    if (command == "set") {
        return confSet(rest);
    }
    if (command == "enumerate") {
        return confEnumerate(takeWord(rest));
    }
    if (command == "list" || command == "schema" || command == "data") {
        return confBinary(command, takeWord(rest));
    }
    if (command == "write") {
        m_device.storeConfig();
    } else if (command == "load") {
        m_device.loadConfig();
    } else if (command == "default") {
        m_device.defaultConfig();
    } else {
        return refusal("unknown subcommand");
    }
    return std::string(kOk);
}

std::string DiagnosticConsole::confSet(std::string_view rest)
{
    const std::string_view key = takeWord(rest);
    if (!setConfigText(m_device.config(), key, takeWord(rest))) {
        return refusal(keyError(m_device.config(), key, "error setting"));
    }
    m_device.configChanged(groupOf(key));
    return std::string(kOk);
}

std::string DiagnosticConsole::confEnumerate(std::string_view group)
{
    std::string text;
    visitFields(m_device.config(), [&](std::string_view key, ConfigField) {
        if (group.empty() || groupOf(key) == group) {
            text += std::string(key) + " " + configText(m_device.config(), key).value_or("") + "\r\n";
        }
    });
    return text.empty() ? refusal("unknown group") : text.append(kOk);
}

std::string DiagnosticConsole::confBinary(std::string_view command, std::string_view group)
{
    if (command == "list") {
        std::string text;
        std::set<std::string, std::less<>> seen;
        visitFields(m_device.config(), [&](std::string_view key, ConfigField) {
            if (seen.emplace(groupOf(key)).second) {
                text += std::string(groupOf(key)) + "\r\n";
            }
        });
        return text.append(kOk);
    }
    const std::vector<ArchiveField> fields = archivedGroup(m_device.config(), group);
    if (fields.empty()) {
        return refusal("unknown group");
    }
    const std::string binary = command == "schema" ? binarySchema(fields) : binaryData(fields);
    return "c" + std::string(command) + " " + std::string(group) + "\r\n" + lengthBytes(binary.size()) + binary;
}

std::string DiagnosticConsole::tel(std::string_view command, std::string_view rest)
{
    if (command == "list") {
        std::string text;
        for (const std::string& name : m_device.telemetryChannels()) {
            text += name + "\r\n";
        }
        return text.append(kOk);
    }
    if (command == "stop") {
        for (auto& [name, channel] : m_channels) {
            channel.period = 0.0;
        }
        return std::string(kOk);
    }
    if (command == "text") {
        for (const std::string& name : m_device.telemetryChannels()) {
            m_channels[name].text = true;
        }
        return std::string(kOk);
    }
    return telFormat(command, rest);
}

// The commands that name a channel.
std::string DiagnosticConsole::telFormat(std::string_view command, std::string_view rest)
{
    const std::string name(takeWord(rest));
    if (command != "schema" && command != "get" && command != "fmt" && command != "rate") {
        return refusal("unknown subcommand");
    }
    const std::vector<ArchiveField> fields = m_device.telemetry(name);
    if (fields.empty()) {
        return refusal("unknown name");
    }
    if (command == "schema") {
        const std::string schema = binarySchema(fields);
        return "schema " + name + "\r\n" + lengthBytes(schema.size()) + schema;
    }
    if (command == "get") {
        const std::string data = emit(name);
        return m_channels[name].text ? data + std::string(kOk) : data;
    }
    const double value = parseFinite(takeWord(rest)).value_or(0.0);
    if (command == "fmt") {
        m_channels[name].text = value != 0.0;
    } else {
        m_channels[name].period = value <= 0.0 ? 0.0 : std::max(value / 1000.0, kShortestPeriod);
    }
    return std::string(kOk);
}

std::string DiagnosticConsole::emit(const std::string& name)
{
    const std::vector<ArchiveField> fields = m_device.telemetry(name);
    const auto channel = m_channels.find(name);
    if (channel != m_channels.end() && channel->second.text) {
        return textLines(name, fields);
    }
    const std::string data = binaryData(fields);
    return "emit " + name + "\r\n" + lengthBytes(data.size()) + data;
}

std::string DiagnosticConsole::drive(std::string_view command, std::string_view rest)
{
    // The console's commands have no watchdog unless one is asked for.
    ServoCommand simple{.watchdogTimeout = kNone};
    if (command == "stop") {
        simple.mode = Mode::Stopped;
    } else if (command == "brake") {
        simple.mode = Mode::Brake;
    } else if (command == "zero") {
        simple.mode = Mode::ZeroVelocity;
    } else if (command == "tmt") {
        simple.mode = Mode::PositionTimeout;
    } else if (command == "pos" || command == "within") {
        return driveMove(command, rest);
    } else {
        return driveOutput(command, rest);
    }
    m_device.consoleCommand(simple);
    return std::string(kOk);
}

std::string DiagnosticConsole::driveMove(std::string_view command, std::string_view rest)
{
    const std::optional<double> first = takeNumber(rest);
    const std::optional<double> second = takeNumber(rest);
    const std::optional<double> torque = takeNumber(rest);
    const bool within = command == "within";
    if (!first || !second || !torque) {
        return refusal(within ? "missing min/max/t" : "missing p/v/i");
    }
    ServoCommand move{.mode = within ? Mode::StayWithin : Mode::Position, .watchdogTimeout = kNone};
    (within ? move.stayWithinLower : move.position) = *first;
    (within ? move.stayWithinUpper : move.velocity) = *second;
    move.maximumTorque = *torque;
    if (!applyOptions(move, rest, within ? "pditfb" : "pdisftavocb")) {
        return refusal("unknown option");
    }
    m_device.consoleCommand(move);
    return std::string(kOk);
}

std::string DiagnosticConsole::driveOutput(std::string_view command, std::string_view rest)
{
    const double position = takeNumber(rest).value_or(0.0);
    if (command == "exact" || command == "index") {
        m_device.setOutputExact(position);
    } else if (command == "nearest" || command == "rezero") {
        m_device.setOutputNearest(position);
    } else if (command == "cfg-set-output") {
        m_device.configureOutput(position);
    } else if (command == "req-reindex") {
        m_device.requireReindex();
    } else if (command == "recapture") {
        m_device.recapture();
    } else {
        return refusal("unknown command");
    }
    return std::string(kOk);
}

}  // namespace boresight::sim
