// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/moteus_mount/board_output.h"

#include "core/base/text.h"
#include "core/moteus/pin_query.h"

#include <cassert>

namespace boresight {

void BoardOutput::set(bool on)
{
    m_wanted = on;
    m_isDue = true;
    m_since.reset();
    if (const auto off = on ? std::nullopt : lastFrame()) {
        m_send(*off);
    }
}

bool BoardOutput::isOn(std::uint8_t bits) const
{
    return (static_cast<unsigned>(bits) >> static_cast<unsigned>(m_pin.number) & 1U) != 0;
}

std::optional<std::uint8_t> BoardOutput::toWrite(bool on) const
{
    if (!m_bits || isOn(*m_bits) == on) {
        return std::nullopt;
    }
    const unsigned bit = 1U << static_cast<unsigned>(m_pin.number);
    return static_cast<std::uint8_t>(on ? *m_bits | bit : *m_bits & ~bit);
}

CanFrame BoardOutput::frameOf(const std::optional<std::uint8_t>& bits) const
{
    const auto frame = moteus::encode(
        {.destination = static_cast<std::uint8_t>(m_pin.board),
         .source = moteus::kOutputHostId,
         .command = bits ? std::optional<moteus::Command>(moteus::SetOutputs{.port = m_pin.port, .bits = *bits})
                         : std::nullopt,
         .query = moteus::outputQuery()});
    assert(frame);  // a fixed query and one byte: a test proves that they fit
    return *frame;
}

// The same frame again, until a reply has the wanted state.
std::optional<CanFrame> BoardOutput::frame(SteadyTime now)
{
    if (!m_isDue) {
        return std::nullopt;
    }
    if (!m_since) {
        m_since = now;
    } else if (now - *m_since >= kPatience) {
        m_bits.reset();
        fail(Text::tr("board %1 does not reply").arg(m_pin.board));
        return std::nullopt;
    }
    return frameOf(m_reached == m_wanted ? std::nullopt : toWrite(m_wanted));
}

void BoardOutput::take(const CanFrame& frame)
{
    const auto reply = moteus::decodeReply(frame);
    if (!reply || reply->prefix != 0 || reply->destination != moteus::kOutputHostId || reply->source != m_pin.board) {
        return;
    }
    const auto outputs = moteus::outputsIn(*reply);
    if (!outputs) {
        return;
    }
    m_bits = outputs->at(static_cast<std::size_t>(m_pin.port - 1));
    if (!m_isDue || !m_since || frame.received < *m_since) {
        return;
    }
    if (isOn(*m_bits) == m_wanted) {
        m_isDue = false;
        m_reached = m_wanted;
        Q_EMIT reached(m_wanted);
    } else if (m_reached == m_wanted) {
        fail(m_wanted ? Text::tr("the pin was switched off. Was board %1 without power?").arg(m_pin.board)
                      : Text::tr("the pin was switched on. Does another program use board %1?").arg(m_pin.board));
    }
}

void BoardOutput::restWithoutLine()
{
    if (!m_isDue) {
        return;
    }
    if (!m_wanted && m_reached == false) {
        m_isDue = false;
        Q_EMIT reached(false);
    } else {
        fail(Text::tr("the line to board %1 is closed").arg(m_pin.board));
    }
}

std::optional<CanFrame> BoardOutput::lastFrame() const
{
    const auto bits = toWrite(false);
    return bits ? std::optional(frameOf(bits)) : std::nullopt;
}

void BoardOutput::fail(const QString& reason)
{
    m_isDue = false;
    m_reached.reset();
    Q_EMIT failed(reason);
}

}  // namespace boresight
