// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/outputs/serial_modem_port.h"

#include "core/base/text.h"
#include "core/serial/control_lines.h"

#include <sys/ioctl.h>
#include <termios.h>

#include <cerrno>
#include <utility>

namespace boresight::outputs {

Result<> SerialModemPort::open()
{
    return openForLines(m_path).map([this](FileDescriptor&& port) { m_port = std::move(port); });
}

void SerialModemPort::close()
{
    m_port.reset();
}

Result<> SerialModemPort::set(Line line, bool high)
{
    const int bit = line == Line::Dtr ? TIOCM_DTR : TIOCM_RTS;
    int lines = 0;
    if (::ioctl(m_port.number(), high ? TIOCMBIS : TIOCMBIC, &bit) != 0 ||
        ::ioctl(m_port.number(), TIOCMGET, &lines) != 0) {
        // A pseudo-terminal has no such lines: the error is ENOTTY or EINVAL.
        return errno == ENOTTY || errno == EINVAL
                   ? failure(ErrorCode::NotAvailable, Text::tr("%1 has no lines DTR and RTS").arg(m_path))
                   : portFailure(m_path, errno);
    }
    return ((lines & bit) != 0) == high ? Result<>{}
                                        : failure(ErrorCode::Io, Text::tr("%1: the line did not change").arg(m_path));
}

}  // namespace boresight::outputs
