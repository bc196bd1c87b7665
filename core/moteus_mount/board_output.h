// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/can_frame.h"
#include "core/base/clock.h"
#include "core/contacts/board_pin.h"
#include "core/outputs/output.h"

#include <cstdint>
#include <functional>
#include <optional>
#include <utility>

// A pin of a board as an output. One register has all outputs of a port, so the other ones are read first and written
// back unchanged. An order is reached when the board reports it. The board keeps its outputs if this program dies, and
// switches them off when it loses its power. Its owner sends the frames of each tick and passes each received frame in.
// Station thread.
namespace boresight {

class BoardOutput final : public outputs::Output
{
public:
    static constexpr std::chrono::milliseconds kPatience{500};  // without a reply to an order

    // `send`: sends a frame now. It outlives this.
    BoardOutput(const contacts::BoardPin& pin, std::function<void(const CanFrame& frame)> send)
        : m_pin(pin), m_send(std::move(send))
    {}

    // Off is also sent at once, because this object may end next.
    void set(bool on) override;

    // The frame of this tick, until the order is reached. `now`: of the tick.
    [[nodiscard]] std::optional<CanFrame> frame(SteadyTime now);
    void take(const CanFrame& frame);
    // In each tick without a line to the board. An output that is off stays off.
    void restWithoutLine();
    // The last frame before the line is closed. Empty: it is off, or what the board has is not known.
    [[nodiscard]] std::optional<CanFrame> lastFrame() const;

private:
    [[nodiscard]] CanFrame frameOf(const std::optional<std::uint8_t>& bits) const;
    // The outputs of its port, with this pin as wanted. Empty: not known, or it is so already.
    [[nodiscard]] std::optional<std::uint8_t> toWrite(bool on) const;
    [[nodiscard]] bool isOn(std::uint8_t bits) const;
    void fail(const QString& reason);

    contacts::BoardPin m_pin;
    std::function<void(const CanFrame& frame)> m_send;
    bool m_wanted = false;
    bool m_isDue = false;                // the order is not answered yet
    std::optional<bool> m_reached;       // the last order that was reached
    std::optional<SteadyTime> m_since;   // when the first frame for the order was made
    std::optional<std::uint8_t> m_bits;  // the outputs of its port, as last reported
};

}  // namespace boresight
