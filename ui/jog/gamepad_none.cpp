// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/jog/gamepad.h"

namespace boresight::ui {

std::unique_ptr<Gamepad> Gamepad::create()
{
    return nullptr;
}

}  // namespace boresight::ui
