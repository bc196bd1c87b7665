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
    const auto reply = moteus::decodeReply(frame);
    if (!reply || reply->prefix != 0 || reply->destination != moteus::kPinHostId) {
        return;
    }
    if (const auto bits = moteus::pinsIn(*reply)) {
        m_ports[reply->source] = {.received = frame.received, .bits = *bits};
    }
}

std::vector<CanFrame> BoardPins::frames() const
{
    std::set<int> boards;
    for (const std::string& input : m_profile->endSwitches.inputs) {
        if (const auto name = contacts::parseInput(input); name && name->kind == contacts::InputKind::Pin) {
            boards.insert(name->pin.board);
        }
    }
    std::vector<CanFrame> frames;
    frames.reserve(boards.size());
    for (const int board : boards) {
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
    if (now - found->second.received > kLongestAge) {
        return {.problem = Text::tr("board %1 does not reply").arg(pin.board)};
    }
    const unsigned bits = found->second.bits.at(static_cast<std::size_t>(pin.port - 1));
    return {.isOn = (bits >> static_cast<unsigned>(pin.number) & 1U) != 0};
}

}  // namespace boresight
