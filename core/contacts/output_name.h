// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"
#include "core/contacts/board_pin.h"

#include <QString>
#include <QStringList>

#include <optional>
#include <string>

// The name of an output in the profile, and what the output answers. Pure, any thread.
namespace boresight::contacts {

enum class OutputKind
{
    None,
    File,
    Mqtt,
    Command,  // a program with its arguments
    Dtr,      // the DTR line of a serial port
    Rts,      // the RTS line of a serial port
    Pin       // a pin of a motor controller
};

struct OutputName
{
    OutputKind kind = OutputKind::None;
    QString place = {};          // path, topic, program or port
    QStringList arguments = {};  // of the program
    BoardPin pin = {};

    bool operator==(const OutputName&) const = default;
};

// What an output answers to the last order.
struct OutputAnswer
{
    std::optional<bool> isOn = {};  // empty: it has not answered yet, or it has failed
    QString problem = {};           // empty: none

    bool operator==(const OutputAnswer&) const = default;
};

// "file:/run/transmit", "mqtt:shack/transmit", "command:/usr/local/bin/ptt --line 2", "dtr:/dev/ttyUSB0",
// "rts:/dev/ttyUSB0", "moteus:1:aux1.0". Double quotes keep an argument with spaces together. An empty text means no
// output.
[[nodiscard]] Result<OutputName> parseOutput(const std::string& text);

}  // namespace boresight::contacts
