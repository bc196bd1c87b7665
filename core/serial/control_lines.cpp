// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/serial/control_lines.h"

#include "core/base/text.h"
#include "core/serial/port_holder.h"
#include "core/serial/serial_port_check.h"

#include <QFile>

#include <fcntl.h>
#include <sys/ioctl.h>
#include <termios.h>

#include <cerrno>
#include <cstring>

namespace boresight {
namespace {

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

tl::unexpected<Error> portFailure(const QString& path, int number)
{
    return failure(ErrorCode::Io, QStringLiteral("%1: %2").arg(path, toQString(std::strerror(number))));
}

Result<FileDescriptor> openForLines(const QString& path)
{
    if (const Result<> usable = checkSerialPort(path); !usable) {
        return tl::unexpected(usable.error());
    }
    if (const auto holder = portHolder(path)) {
        return failure(ErrorCode::Busy, Text::tr("%1 is used by %2").arg(path, *holder));
    }
    FileDescriptor port(::open(QFile::encodeName(path).constData(), O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC));
    if (!port.isOpen() || ::ioctl(port.number(), TIOCEXCL) != 0 || !setLowAtTheEnd(port.number())) {
        return portFailure(path, errno);
    }
    return port;
}

}  // namespace boresight
