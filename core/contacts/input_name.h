// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"
#include "core/contacts/board_pin.h"

#include <QString>

#include <optional>
#include <string>
#include <string_view>

// The name of an input in the profile, and what the input reads. Pure, any thread.
namespace boresight::contacts {

enum class InputKind
{
    None,
    Pin,   // a pin of a motor controller
    Mqtt,  // a topic of the broker
    Cts,   // a line of a serial port, as the three below
    Dsr,
    Dcd,
    Ri
};

struct InputName
{
    InputKind kind = InputKind::None;
    QString place = {};  // topic or serial port
    BoardPin pin = {};

    [[nodiscard]] bool isLine() const { return kind >= InputKind::Cts; }
    bool operator==(const InputName&) const = default;
};

struct InputReading
{
    std::optional<bool> isOn = {};  // empty: it has not been read yet, or it cannot be read
    QString problem = {};           // why it cannot be read; empty: no problem is known

    bool operator==(const InputReading&) const = default;
};

// "moteus:1:aux1.0", "mqtt:shack/switch", "cts:/dev/ttyUSB0", "dsr:…", "dcd:…", "ri:…". An empty text means no input.
[[nodiscard]] Result<InputName> parseInput(const std::string& text);

// A message about a contact: on or off, in any case, or 1, 0, true or false. White space around it is ignored.
[[nodiscard]] Result<bool> readContact(std::string_view message);

}  // namespace boresight::contacts
