// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"

#include <QString>

#include <memory>

// A control line of a serial port that keys or permits a transmitter. The port is opened once and stays open, because
// the kernel raises both lines for a moment whenever a port is opened. Use from one thread at a time. Calls may block.
namespace boresight::outputs {

enum class Line
{
    Dtr,
    Rts
};

// The functions of a serial port that ModemLine needs.
class ModemPort
{
public:
    ModemPort() = default;
    ModemPort(const ModemPort&) = delete;
    ModemPort& operator=(const ModemPort&) = delete;
    virtual ~ModemPort() = default;

    // From then on the operating system lowers both lines when the program ends, even after a crash.
    [[nodiscard]] virtual Result<> open() = 0;
    virtual void close() = 0;
    [[nodiscard]] virtual Result<> set(Line line, bool high) = 0;
};

class ModemLine
{
public:
    ModemLine(std::unique_ptr<ModemPort> port, Line line) : m_port(std::move(port)), m_line(line) {}

    // Opens the port if it is closed, and lowers both lines first. The other line stays low.
    [[nodiscard]] Result<> set(bool high);

private:
    [[nodiscard]] Result<> open();

    std::unique_ptr<ModemPort> m_port;
    Line m_line;
    bool m_open = false;
};

}  // namespace boresight::outputs
