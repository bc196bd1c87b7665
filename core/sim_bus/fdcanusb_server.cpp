// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/sim_bus/fdcanusb_server.h"

#include "core/can/line_checksum.h"
#include "core/sim_bus/fdcanusb_request.h"

#include <algorithm>

namespace boresight::sim {
namespace {

std::string_view firstWord(std::string_view text)
{
    return text.substr(0, text.find(' '));
}

std::string_view afterFirstWord(std::string_view text)
{
    return text.substr(std::min(firstWord(text).size() + 1, text.size()));
}

}  // namespace

FdcanusbServer::FdcanusbServer(SimulatedPair& pair)
    : m_pair(pair), m_config{{"can.bitrate", "1000000"},       {"can.fd_bitrate", "5000000"},
                             {"can.sample_point", "0.666000"}, {"can.fd_sample_point", "0.666000"},
                             {"can.termination", "1"},         {"can.autostart", "1"},
                             {"can.autorecover", "0"}}
{}

std::string FdcanusbServer::receive(std::string_view bytes, Seconds now)
{
    m_splitter.add(bytes, [this, now](std::string_view line) { handleLine(line, now); });
    return takeDue(now);
}

std::string FdcanusbServer::takeDue(Seconds now)
{
    while (const auto late = m_late.takeDue(now)) {
        answer(late->reply, late->style);
    }
    return std::exchange(m_output, {});
}

void FdcanusbServer::clientGone()
{
    m_splitter.clear();
    m_late.clear();
    m_output.clear();
}

void FdcanusbServer::handleLine(std::string_view line, Seconds now)
{
    const fdcanusb::CheckedLine checked = fdcanusb::splitChecksum(line);
    switch (checked.checksum) {
        case fdcanusb::Checksum::Absent:
            execute(checked.text, Style::Plain, now);
            break;
        case fdcanusb::Checksum::Right:
            execute(checked.text, Style::WithChecksum, now);
            break;
        case fdcanusb::Checksum::Wrong:
            answer("ERR checksum", Style::WithChecksum);
            break;
    }
}

void FdcanusbServer::execute(std::string_view text, Style style, Seconds now)
{
    m_pair.advanceTo(now);
    followBus(now);
    if (firstWord(text) == "can") {
        can(firstWord(afterFirstWord(text)), text, style, now);
    } else if (firstWord(text) == "conf") {
        configure(afterFirstWord(text), style);
    } else {
        answer("ERR unknown command", style);
    }
}

// Bus-off lasts until the host switches the bus off and on again: by factory default, autorecover of the adapter is
// off.
void FdcanusbServer::followBus(Seconds now)
{
    if (isInjected(FaultKind::BusOff, now)) {
        m_busOn = false;
    }
}

void FdcanusbServer::can(std::string_view subcommand, std::string_view text, Style style, Seconds now)
{
    if (subcommand == "send" || subcommand == "std" || subcommand == "ext") {
        send(text, style, now);
    } else if (subcommand == "on") {
        m_busOn = !isInjected(FaultKind::BusOff, now);
        answer("OK", style);
    } else if (subcommand == "off") {
        m_busOn = false;
        answer("OK", style);
    } else if (subcommand == "status") {
        const bool off = isInjected(FaultKind::BusOff, now);
        answer(off ? "lec=3 dlec=3 err=1 warn=1 busoff=1" : "lec=0 dlec=0 err=0 warn=0 busoff=0", style);
    } else {
        answer("ERR unknown subcommand", style);
    }
}

void FdcanusbServer::send(std::string_view text, Style style, Seconds now)
{
    const auto frame = parseSendRequest(text);
    if (!frame) {
        answer("ERR " + frame.error(), style);
        return;
    }
    if (!m_busOn) {
        answer("ERR not in BusOn state", style);
        return;
    }
    if (isInjected(FaultKind::AdapterError, now)) {
        answer("ERR invalid data", style);
        return;
    }
    if (!isInjected(FaultKind::MissingOk, now)) {
        answer("OK", style);
    }
    for (const PairReply& reply : m_pair.exchange(*frame, now)) {
        if (reply.due <= now) {
            answer(reply, style);
        } else {
            m_late.add(reply.due, {.reply = reply, .style = style});
        }
    }
}

void FdcanusbServer::configure(std::string_view text, Style style)
{
    const std::string_view command = firstWord(text);
    const std::string_view rest = afterFirstWord(text);
    const auto found = m_config.find(firstWord(rest));
    if (command == "write" || command == "load" || command == "default") {
        answer("OK", style);
    } else if (command == "enumerate") {
        for (const auto& [key, value] : m_config) {
            answer(key + " " + value, style);
        }
        answer("OK", style);
    } else if (command != "get" && command != "set") {
        answer("ERR unknown subcommand", style);
    } else if (found == m_config.end()) {
        answer(command == "get" ? "ERR error reading" : "ERR error setting", style);
    } else if (command == "get") {
        answer(found->second, style);
    } else {
        found->second = afterFirstWord(rest);
        answer("OK", style);
    }
}

void FdcanusbServer::answer(std::string_view line, Style style)
{
    m_output += style == Style::WithChecksum ? fdcanusb::withChecksum(line) : std::string(line);
    m_output += "\r\n";
}

// In a damaged line one character in the middle is replaced, after the checksum was computed.
void FdcanusbServer::answer(const PairReply& reply, Style style)
{
    const std::size_t start = m_output.size();
    answer(receivedLine(reply.frame), style);
    if (reply.damaged) {
        m_output[start + (m_output.size() - start) / 2] = '~';
    }
}

bool FdcanusbServer::isInjected(FaultKind kind, Seconds now) const
{
    return m_pair.faults().isActive(kind, Axis::Azimuth, now) || m_pair.faults().isActive(kind, Axis::Elevation, now);
}

}  // namespace boresight::sim
