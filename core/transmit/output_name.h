// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"

#include <QString>
#include <QStringList>

#include <string>

// The output that permits a transmitter to transmit, by its name in the profile. Pure, any thread.
namespace boresight::transmit {

enum class OutputKind
{
    None,
    File,     // its path
    Mqtt,     // the topic
    Command,  // a program with its arguments
    Dtr,      // a line of a serial port
    Rts
};

struct OutputName
{
    OutputKind kind = OutputKind::None;
    QString place = {};          // path, topic, program or port
    QStringList arguments = {};  // of the program

    bool operator==(const OutputName&) const = default;
};

// "file:/run/transmit", "mqtt:shack/transmit", "command:/usr/local/bin/ptt --line 2", "dtr:/dev/ttyUSB0",
// "rts:/dev/ttyUSB0". Double quotes keep an argument with spaces together. Empty: none.
[[nodiscard]] Result<OutputName> parseOutput(const std::string& text);

}  // namespace boresight::transmit
