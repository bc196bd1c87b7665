// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/moteus_mount/board_pins.h"

#include "core/base/text.h"
#include "core/moteus/codec.h"
#include "core/moteus/pin_query.h"

#include <cassert>
#include <set>

namespace boresight {

void BoardPins::take(const CanFrame& frame)
{
    m_modes.take(frame);
    const auto reply = moteus::decodeReply(frame);
    if (!reply || reply->prefix != 0 || reply->destination != moteus::kPinHostId) {
        return;
    }
    if (const auto bits = moteus::pinsIn(*reply)) {
        m_ports[reply->source] = {.received = frame.received, .bits = *bits};
    }
}

std::vector<contacts::BoardPin> BoardPins::named() const
{
    std::vector<contacts::BoardPin> pins;
    for (const std::string& input : m_profile->endSwitches.inputs) {
        if (const auto name = contacts::parseInput(input); name && name->kind == contacts::InputKind::Pin) {
            pins.push_back(name->pin);
        }
    }
    return pins;
}

bool BoardPins::answers(int board, SteadyTime now) const
{
    const auto found = m_ports.find(board);
    return found != m_ports.end() && now - found->second.received <= kLongestAge;
}

std::vector<CanFrame> BoardPins::frames(SteadyTime now, bool areConsolesFree)
{
    const std::vector<contacts::BoardPin> pins = named();
    std::set<int> boards;
    for (const contacts::BoardPin& pin : pins) {
        boards.insert(pin.board);
    }
    const auto mayAsk = [&](int board) { return areConsolesFree && answers(board, now); };
    std::vector<CanFrame> frames = m_modes.frames(pins, mayAsk, now);
    for (const int board : boards) {
        if (!answers(board, now)) {
            m_modes.forget(board);
        }
        const auto frame = moteus::encode({.destination = static_cast<std::uint8_t>(board),
                                           .source = moteus::kPinHostId,
                                           .query = moteus::pinQuery()});
        assert(frame);  // a fixed query: a test proves that it fits
        frames.push_back(*frame);
    }
    return frames;
}

contacts::InputReading BoardPins::read(const contacts::BoardPin& pin, SteadyTime now) const
{
    const auto found = m_ports.find(pin.board);
    if (found == m_ports.end()) {
        return {.problem = Text::tr("board %1 has not replied yet").arg(pin.board)};
    }
    if (const QString problem = m_modes.problem(pin); !problem.isEmpty()) {
        return {.problem = problem};
    }
    if (now - found->second.received > kLongestAge) {
        return {.problem = Text::tr("board %1 does not reply").arg(pin.board)};
    }
    const unsigned bits = found->second.bits.at(static_cast<std::size_t>(pin.port - 1));
    return {.isOn = (bits >> static_cast<unsigned>(pin.number) & 1U) != 0};
}

}  // namespace boresight
