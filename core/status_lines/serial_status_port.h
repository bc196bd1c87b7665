// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/file_descriptor.h"
#include "core/status_lines/line_reader.h"

#include <QString>

// The status lines of a serial port of this computer. DTR and RTS are high while the port is open, so that they can
// feed the switches. Use from one thread at a time. Calls may block.
namespace boresight::status_lines {

class SerialStatusPort
{
public:
    explicit SerialStatusPort(const QString& path) : m_path(path) {}

    // Opens the port if it is closed. A port that fails is closed.
    [[nodiscard]] Result<StatusLines> read();

private:
    [[nodiscard]] Result<> open();

    QString m_path;
    FileDescriptor m_port;
};

}  // namespace boresight::status_lines
