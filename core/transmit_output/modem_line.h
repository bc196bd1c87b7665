// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"

#include <QString>

#include <memory>

// A control line of a serial port that keys or permits a transmitter. The port is opened once and stays open: to open
// it raises both lines for a moment, whatever a program does. One thread at a time; may block.
namespace boresight::transmit {

enum class Line
{
    Dtr,
    Rts
};

// A port, as ModemLine needs it.
class ModemPort
{
public:
    ModemPort() = default;
    ModemPort(const ModemPort&) = delete;
    ModemPort& operator=(const ModemPort&) = delete;
    virtual ~ModemPort() = default;

    // Both lines are low at the end of the program, however it ends.
    [[nodiscard]] virtual Result<> open() = 0;
    virtual void close() = 0;
    [[nodiscard]] virtual Result<> set(Line line, bool high) = 0;
};

class ModemLine
{
public:
    ModemLine(std::unique_ptr<ModemPort> port, Line line) : m_port(std::move(port)), m_line(line) {}

    // Opens the port where it is not open. Both lines are low then, and the other one stays so.
    [[nodiscard]] Result<> set(bool high);

private:
    [[nodiscard]] Result<> open();

    std::unique_ptr<ModemPort> m_port;
    Line m_line;
    bool m_open = false;
};

}  // namespace boresight::transmit
