// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/serial/serial_port_check.h"

#include "core/base/text.h"

#include <QFile>
#include <QFileInfo>

#include <fcntl.h>
#include <sys/stat.h>
#include <sys/sysmacros.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

namespace boresight {

Result<> checkSerialPort(const QString& path)
{
    const QByteArray file = QFile::encodeName(path);
    struct stat info = {};
    if (stat(file.constData(), &info) != 0) {
        if (errno == EACCES) {
            return failure(ErrorCode::Denied, Text::tr("%1: no permission to enter its folder").arg(path));
        }
        return failure(
            ErrorCode::NoDevice,
            Text::tr("%1 does not exist. Plug the adapter in. The command ls /dev/serial/by-id lists all adapters")
                .arg(path));
    }
    if (!S_ISCHR(info.st_mode)) {
        return failure(ErrorCode::InvalidInput, Text::tr("%1 is not a serial port").arg(path));
    }
    if (faccessat(AT_FDCWD, file.constData(), R_OK | W_OK, AT_EACCESS) != 0) {
        if (errno == EACCES) {
            return failure(ErrorCode::Denied,
                           Text::tr("%1: no permission. Join the group dialout with `sudo usermod -aG dialout $USER`, "
                                    "then log in again")
                               .arg(path));
        }
        return failure(ErrorCode::Io, QStringLiteral("%1: %2").arg(path, toQString(std::strerror(errno))));
    }
    return {};
}

QString canonicalPort(const QString& path)
{
    const QString canonical = QFileInfo(path).canonicalFilePath();
    return canonical.isEmpty() ? path : canonical;
}

std::optional<PortIdentity> portIdentity(const QString& path)
{
    struct stat info = {};
    if (stat(QFile::encodeName(path).constData(), &info) != 0) {
        return std::nullopt;
    }
    return PortIdentity{.fileSystem = info.st_dev, .file = info.st_ino, .device = info.st_rdev};
}

bool isPseudoTerminal(dev_t device)
{
    constexpr unsigned kFirstMajor = 136;  // UNIX98_PTY_SLAVE_MAJOR of linux/major.h
    constexpr unsigned kLastMajor = 143;
    return major(device) >= kFirstMajor && major(device) <= kLastMajor;
}

bool isPseudoTerminal(int descriptor)
{
    struct stat info = {};
    return fstat(descriptor, &info) == 0 && isPseudoTerminal(info.st_rdev);
}

}  // namespace boresight
