// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/file_descriptor.h"
#include "core/transmit_output/modem_line.h"

// The lines of a serial port of this computer. Not by QSerialPort: it wants an event loop, and leaves to chance what
// the lines do when the program dies.
namespace boresight::transmit {

class SerialModemPort final : public ModemPort
{
public:
    explicit SerialModemPort(const QString& path) : m_path(path) {}

    [[nodiscard]] Result<> open() override;
    void close() override;
    // Reads back what was set.
    [[nodiscard]] Result<> set(Line line, bool high) override;

private:
    QString m_path;
    FileDescriptor m_port;
};

}  // namespace boresight::transmit
