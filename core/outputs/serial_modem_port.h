// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/file_descriptor.h"
#include "core/outputs/modem_line.h"

// The control lines of a serial port of this computer.
namespace boresight::outputs {

class SerialModemPort final : public ModemPort
{
public:
    explicit SerialModemPort(const QString& path) : m_path(path) {}

    [[nodiscard]] Result<> open() override;
    void close() override;
    // Reads the line back and fails if it did not change.
    [[nodiscard]] Result<> set(Line line, bool high) override;

private:
    QString m_path;
    FileDescriptor m_port;
};

}  // namespace boresight::outputs
