// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"

#include <string_view>

// A pin of a motor controller, with the numbers that its configuration has: aux1.pins.0 is port 1, number 0. Pure, any
// thread.
namespace boresight::contacts {

struct BoardPin
{
    int board = 0;
    int port = 1;
    int number = 0;

    bool operator==(const BoardPin&) const = default;
};

// "1:aux1.0"
[[nodiscard]] Result<BoardPin> parsePin(std::string_view text);

}  // namespace boresight::contacts
