// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/outputs/serial_modem_port.h"

#include "core/base/text.h"
#include "core/serial/port_holder.h"
#include "core/serial/serial_port_check.h"

#include <QFile>

#include <fcntl.h>
#include <sys/ioctl.h>
#include <termios.h>

#include <cerrno>
#include <cstring>

namespace boresight::outputs {
namespace {

tl::unexpected<Error> portFailure(const QString& path, int number)
{
    return failure(ErrorCode::Io, QStringLiteral("%1: %2").arg(path, toQString(std::strerror(number))));
}

// The kernel lowers the lines when the port is closed (HUPCL), also when the program dies.
bool setLowAtTheEnd(int port)
{
    termios settings{};
    if (tcgetattr(port, &settings) != 0) {
        return false;
    }
    settings.c_cflag |= HUPCL | CLOCAL;
    settings.c_cflag &= ~static_cast<tcflag_t>(CRTSCTS);  // with flow control the kernel would switch RTS itself
    return tcsetattr(port, TCSANOW, &settings) == 0;
}

}  // namespace

Result<> SerialModemPort::open()
{
    if (const Result<> usable = checkSerialPort(m_path); !usable) {
        return usable;
    }
    if (const auto holder = portHolder(m_path)) {
        return failure(ErrorCode::Busy, Text::tr("%1 is used by %2").arg(m_path, *holder));
    }
    m_port = FileDescriptor(::open(QFile::encodeName(m_path).constData(), O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC));
    if (!m_port.isOpen() || ::ioctl(m_port.number(), TIOCEXCL) != 0 || !setLowAtTheEnd(m_port.number())) {
        const int number = errno;
        m_port.reset();
        return portFailure(m_path, number);
    }
    return {};
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
