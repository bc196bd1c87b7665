// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/sim/diagnostic_console.h"

#include "core/base/numbers.h"
#include "core/sim/console_commands.h"

#include <algorithm>
#include <utility>

namespace boresight::sim {
namespace {

constexpr std::size_t kLongestLine = 100;
constexpr std::size_t kMostPending = 4096;  // when the client does not read, nothing more is sent
constexpr double kShortestPeriod = 0.01;    // s

using console::kOk;
using console::lengthBytes;
using console::refusal;
using console::takeWord;

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
        m_input.resize(kLongestLine + 1);  // the line is too long already and is dropped at its end
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
            m_output += report(name);
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
        m_output += console::config(m_device, command, line);
    } else if (group == "tel") {
        m_output += tel(command, line);
    } else if (group == "d") {
        m_output += console::motion(m_device, command, line);
    } else {
        m_output += refusal("unknown command");
    }
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
        const std::string data = report(name);
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

std::string DiagnosticConsole::report(const std::string& name)
{
    const std::vector<ArchiveField> fields = m_device.telemetry(name);
    const auto channel = m_channels.find(name);
    if (channel != m_channels.end() && channel->second.text) {
        return textLines(name, fields);
    }
    const std::string data = binaryData(fields);
    return "emit " + name + "\r\n" + lengthBytes(data.size()) + data;
}

}  // namespace boresight::sim
