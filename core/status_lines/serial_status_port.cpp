// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/status_lines/serial_status_port.h"

#include "core/base/text.h"
#include "core/serial/control_lines.h"

#include <sys/ioctl.h>
#include <termios.h>

#include <cerrno>

namespace boresight::status_lines {

Result<> SerialStatusPort::open()
{
    if (m_port.isOpen()) {
        return {};
    }
    return openForLines(m_path).map([this](FileDescriptor&& port) {
        m_port = std::move(port);
        const int feeding = TIOCM_DTR | TIOCM_RTS;
        // A port without these lines fails when its status is read.
        (void)::ioctl(m_port.number(), TIOCMBIS, &feeding);
    });
}

Result<StatusLines> SerialStatusPort::read()
{
    if (const Result<> opened = open(); !opened) {
        return tl::unexpected(opened.error());
    }
    int lines = 0;
    if (::ioctl(m_port.number(), TIOCMGET, &lines) != 0) {
        const int number = errno;
        m_port.reset();
        // A pseudo-terminal has no such lines.
        return number == ENOTTY || number == EINVAL
                   ? failure(ErrorCode::NotAvailable, Text::tr("%1 has no lines CTS, DSR, DCD and RI").arg(m_path))
                   : portFailure(m_path, number);
    }
    return StatusLines{.cts = (lines & TIOCM_CTS) != 0,
                       .dsr = (lines & TIOCM_DSR) != 0,
                       .dcd = (lines & TIOCM_CAR) != 0,
                       .ri = (lines & TIOCM_RNG) != 0};
}

}  // namespace boresight::status_lines
