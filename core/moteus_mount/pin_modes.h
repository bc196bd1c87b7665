// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/can_frame.h"
#include "core/base/clock.h"
#include "core/contacts/input_name.h"
#include "core/drive_check/console_run.h"

#include <QString>

#include <functional>
#include <map>
#include <optional>
#include <set>
#include <vector>

// Whether the pins of the boards are configured as inputs. A pin with another function always reads the same, so a
// switch at it would never be seen. The consoles of the boards are asked once after each connection. A board that does
// not tell the modes of its pins is asked again later. Pure: time is passed in.
namespace boresight {

class PinModes
{
public:
    static constexpr int kDigitalInput = 14;  // as the configuration of the board counts it

    void take(const CanFrame& frame);
    // The frames of this tick. `pins`: those that the profile names. `mayAsk`: the board answers, and nobody else uses
    // its console.
    [[nodiscard]] std::vector<CanFrame> frames(const std::vector<contacts::BoardPin>& pins,
                                               const std::function<bool(int board)>& mayAsk, SteadyTime now);
    // The board was away, so its configuration may be another one.
    void forget(int board) { m_boards.erase(board); }

    // Why this pin is no input. Empty: it is one, or its mode is not known.
    [[nodiscard]] QString problem(const contacts::BoardPin& pin) const;

private:
    struct Board
    {
        std::vector<contacts::BoardPin> asked;  // in the order of the answers
        std::optional<drive_check::ConsoleRun> run;
        std::vector<std::optional<int>> modes;  // of `asked`; empty: unknown
        SteadyTime nextTry{};
    };

    static void begin(Board& board);
    static void finish(Board& board, SteadyTime now);

    std::map<int, Board> m_boards;  // by their ids
};

}  // namespace boresight
