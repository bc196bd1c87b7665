// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/outputs/state_file.h"

#include "core/base/file_descriptor.h"
#include "core/base/text.h"

#include <QFile>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <string_view>

namespace boresight::outputs {
namespace {

constexpr mode_t kReadByAll = 0644;

tl::unexpected<Error> fileFailure(const QString& path, int number)
{
    return failure(ErrorCode::Io, QStringLiteral("%1: %2").arg(path, toQString(std::strerror(number))));
}

}  // namespace

Result<> writeState(const QString& path, bool on)
{
    // O_NONBLOCK: opening a named pipe must not wait for its reader.
    constexpr int kFlags = O_WRONLY | O_CREAT | O_CLOEXEC | O_NONBLOCK | O_NOCTTY;
    const FileDescriptor file(::open(QFile::encodeName(path).constData(), kFlags, kReadByAll));
    if (!file.isOpen()) {
        return fileFailure(path, errno);
    }
    struct stat info = {};
    if (::fstat(file.number(), &info) != 0 || !S_ISREG(info.st_mode)) {
        return failure(ErrorCode::InvalidInput, Text::tr("%1 is not a file").arg(path));
    }
    // For "off" the file is emptied first, which works on a full disk, too. For "on" it is not emptied, so that a file
    // that already contains "on" stays readable while its time is renewed.
    if (!on && ::ftruncate(file.number(), 0) != 0) {
        return fileFailure(path, errno);
    }
    constexpr std::string_view kOn = "on\n";
    constexpr std::string_view kOff = "off\n";
    const std::string_view bytes = on ? kOn : kOff;
    const auto size = static_cast<ssize_t>(bytes.size());
    const bool written = ::pwrite(file.number(), bytes.data(), bytes.size(), 0) == size;
    if (!written || ::ftruncate(file.number(), size) != 0) {
        const int number = errno;
        (void)!::ftruncate(file.number(), 0);
        return fileFailure(path, number);
    }
    return {};
}

}  // namespace boresight::outputs
