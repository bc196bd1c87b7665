// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/program_lock.h"

#include "core/base/control_characters.h"
#include "core/base/process_name.h"
#include "core/base/text.h"

#include <QCoreApplication>
#include <QFile>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <sys/sysmacros.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <string>

namespace boresight {
namespace {

// Reads lines of /proc/locks, for example "1: FLOCK  ADVISORY  WRITE 1234 00:05:321 0 EOF". On file systems whose
// device number there differs from that of fstat() the holder stays unknown.
QString lockHolder(int descriptor)
{
    struct stat info = {};
    if (fstat(descriptor, &info) != 0) {
        return nameOfProcess({});
    }
    std::array<char, 64> wanted{};
    std::snprintf(wanted.data(), wanted.size(), "%02x:%02x:%llu", major(info.st_dev), minor(info.st_dev),
                  static_cast<unsigned long long>(info.st_ino));
    std::ifstream locks("/proc/locks");
    for (std::string number, kind, mode, access, process, file, rest;
         locks >> number >> kind >> mode >> access >> process >> file && std::getline(locks, rest);) {
        if (kind == "FLOCK" && file == wanted.data()) {
            return nameOfProcess(process);
        }
    }
    return nameOfProcess({});
}

QByteArray ownName()
{
    return QCoreApplication::applicationName().toUtf8() + ' ' + QByteArray::number(QCoreApplication::applicationPid());
}

// The name that the other program wrote into the file. The kernel may hide the name if the user differs.
QString writtenName(int descriptor)
{
    std::array<char, 128> text{};
    const ssize_t size = ::pread(descriptor, text.data(), text.size(), 0);
    const QString name =
        toQString(printable(std::string(text.data(), static_cast<std::size_t>(std::max<ssize_t>(size, 0)))));
    const qsizetype space = name.lastIndexOf(QLatin1Char(' '));
    return space > 0 ? processText(name.left(space), name.mid(space + 1)) : lockHolder(descriptor);
}

}  // namespace

Result<> lockDescriptor(int descriptor)
{
    if (::flock(descriptor, LOCK_EX | LOCK_NB) == 0) {
        return {};
    }
    return errno == EWOULDBLOCK ? failure(ErrorCode::Busy, lockHolder(descriptor))
                                : failure(ErrorCode::Io, toQString(std::strerror(errno)));
}

Result<ProgramLock> ProgramLock::take(const QString& path)
{
    constexpr mode_t kReadableByAll = 0644;
    constexpr int kFlags = O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK;
    const QByteArray name8 = QFile::encodeName(path);
    FileDescriptor file(::open(name8.constData(), O_RDWR | O_CREAT | kFlags, kReadableByAll));
    if (!file.isOpen() && errno == EACCES) {
        // Another user's file can be locked although it is read-only.
        file = FileDescriptor(::open(name8.constData(), O_RDONLY | kFlags));
    }
    if (!file.isOpen()) {
        return failure(errno == EACCES ? ErrorCode::Denied : ErrorCode::Io, toQString(std::strerror(errno)));
    }
    if (const Result<> locked = lockDescriptor(file.number()); !locked) {
        return locked.error().code == ErrorCode::Busy ? failure(ErrorCode::Busy, writtenName(file.number()))
                                                      : tl::unexpected(locked.error());
    }
    const QByteArray name = ownName();
    [[maybe_unused]] const bool named =
        ::ftruncate(file.number(), 0) == 0 &&
        ::pwrite(file.number(), name.constData(), static_cast<std::size_t>(name.size()), 0) > 0;
    return ProgramLock(std::move(file));
}

}  // namespace boresight
