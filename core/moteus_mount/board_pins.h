// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/can_frame.h"
#include "core/base/clock.h"
#include "core/contacts/input_name.h"
#include "core/moteus_mount/pin_modes.h"
#include "core/profile/in_force.h"

#include <array>
#include <cstdint>
#include <map>
#include <vector>

// The pins of the boards that the profile names as inputs. Each board with such a pin is asked once per tick, in a
// frame of its own: the reply to the query of a rotator is full. After each connection the console of the board is
// asked whether the pins are inputs. Nothing is commanded. Pure: time is passed in.
namespace boresight {

class BoardPins
{
public:
    // A reading that is older than this does not count.
    static constexpr std::chrono::milliseconds kLongestAge{200};

    // The profile outlives this.
    explicit BoardPins(const profile::InForce& profile) : m_profile(profile) {}

    void take(const CanFrame& frame);
    // The queries of this tick. `areConsolesFree`: nobody else uses the console of a board.
    [[nodiscard]] std::vector<CanFrame> frames(SteadyTime now, bool areConsolesFree);
    [[nodiscard]] contacts::InputReading read(const contacts::BoardPin& pin, SteadyTime now) const;

private:
    struct Ports
    {
        SteadyTime received{};
        std::array<std::uint8_t, 2> bits{};  // of aux port 1 and 2; bit 0 is pin 0
    };

    [[nodiscard]] std::vector<contacts::BoardPin> named() const;
    [[nodiscard]] bool answers(int board, SteadyTime now) const;

    const profile::InForce& m_profile;
    std::map<int, Ports> m_ports;  // by the id of the board
    PinModes m_modes;
};

}  // namespace boresight
