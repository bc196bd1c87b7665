// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/journal/journal_file.h"

#include "core/base/file_descriptor.h"
#include "core/base/file_name.h"
#include "core/base/text.h"
#include "core/journal/journal_text.h"

#include <QDateTime>
#include <QFile>
#include <QFileInfo>
#include <QSaveFile>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <utility>

namespace boresight::journal {
namespace {

const QString kPrevious = QStringLiteral(".previous");

Error ioError(const QString& path, const QString& reason)
{
    return {ErrorCode::Io, QStringLiteral("%1: %2").arg(path, reason)};
}

// Replaces `to` in one step. QFile::rename would refuse to replace a file.
Result<> replaceByRenaming(const QString& from, const QString& to)
{
    if (std::rename(QFile::encodeName(from).constData(), QFile::encodeName(to).constData()) != 0) {
        return tl::unexpected(ioError(from, qt_error_string()));
    }
    return {};
}

// Makes the new names survive a power cut. A file system that cannot sync a folder reports EINVAL, which is not an
// error.
Result<> syncFolder(const QString& folder)
{
    const FileDescriptor descriptor(::open(QFile::encodeName(folder).constData(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
    if (!descriptor.isOpen() || (::fsync(descriptor.number()) != 0 && errno != EINVAL)) {
        return tl::unexpected(ioError(folder, qt_error_string()));
    }
    return {};
}

// Writes the text to a file beside `path` and syncs it before anything is renamed, because QSaveFile would not report a
// failed sync. Between the two renamings only the previous generation exists; load() then takes that.
Result<> write(const QString& path, const MountJournal& journal)
{
    const Result<QByteArray> text = toText(journal);
    if (!text) {
        return tl::unexpected(text.error());
    }
    QSaveFile file(path);
    if (!file.open(QIODevice::WriteOnly) || file.write(*text) != text->size() || !file.flush()) {
        return tl::unexpected(ioError(path, file.errorString()));
    }
    if (::fsync(file.handle()) != 0) {
        return tl::unexpected(ioError(path, qt_error_string()));
    }
    if (QFile::exists(path)) {
        if (Result<> kept = replaceByRenaming(path, path + kPrevious); !kept) {
            return kept;
        }
    }
    if (!file.commit()) {
        return tl::unexpected(ioError(path, file.errorString()));
    }
    return syncFolder(QFileInfo(path).absolutePath());
}

// Never waits or reads for ever: a pipe without a writer and /dev/zero are refused at once.
Result<MountJournal> read(const QString& path)
{
    constexpr qint64 kLargest = 1 << 20;  // a journal file has 2 kB
    const FileDescriptor descriptor(
        ::open(QFile::encodeName(path).constData(), O_RDONLY | O_NONBLOCK | O_NOCTTY | O_CLOEXEC));
    struct stat info = {};
    if (!descriptor.isOpen() || ::fstat(descriptor.number(), &info) != 0) {
        return failure(errno == ENOENT ? ErrorCode::NoDevice : ErrorCode::Io, qt_error_string());
    }
    if (!S_ISREG(info.st_mode)) {
        return failure(ErrorCode::InvalidInput, Text::tr("it is not a regular file"));
    }
    QFile file;
    if (!file.open(descriptor.number(), QIODevice::ReadOnly)) {
        return failure(ErrorCode::Io, file.errorString());
    }
    const QByteArray text = file.read(kLargest + 1);
    if (text.size() > kLargest) {
        return failure(ErrorCode::InvalidInput, Text::tr("it is too large for a position journal"));
    }
    return parseJournal(text);
}

bool isThere(const QString& path)
{
    struct stat info
    {};
    return ::lstat(QFile::encodeName(path).constData(), &info) == 0;
}

// Renames the file and returns the new name. Empty if that failed. The file is never deleted, because it may contain
// the only true record.
std::optional<QString> keepAside(const QString& path)
{
    QString aside;
    QDateTime time = QDateTime::currentDateTimeUtc();
    do {
        aside = QStringLiteral("%1.corrupt-%2").arg(path, time.toString(QStringLiteral("yyyyMMdd'T'HHmmss.zzz'Z'")));
        time = time.addMSecs(1);
    } while (isThere(aside));
    return replaceByRenaming(path, aside) ? std::optional(aside) : std::nullopt;
}

QString whatIsWrong(const QString& path, const Error& error)
{
    if (error.code == ErrorCode::NoDevice) {
        return Text::tr("The journal file %1 is missing").arg(path);
    }
    // Also for a file that cannot be read at the moment. Left in its place, the next two saves would overwrite it.
    if (const auto aside = keepAside(path)) {
        return Text::tr("The journal file %1 cannot be used: %2. Boresight keeps it as %3")
            .arg(path, error.text, *aside);
    }
    return Text::tr("The journal file %1 cannot be used: %2. Boresight could not rename it").arg(path, error.text);
}

}  // namespace

JournalFile::JournalFile(const QString& stateDir, const QString& mountName, QObject* parent)
    : QObject(parent), m_path(QStringLiteral("%1/%2.memory.json").arg(stateDir, safeFileName(mountName)))
{
    connect(&m_writer, &NewestWriter::written, this, &JournalFile::saved);
    connect(&m_writer, &NewestWriter::failed, this, &JournalFile::saveFailed);
}

Result<> JournalFile::claim()
{
    const QString path = m_path + QStringLiteral(".lock");
    Result<ProgramLock> lock = ProgramLock::take(path);
    if (lock) {
        m_lock = *std::move(lock);
    } else if (lock.error().code == ErrorCode::Busy) {
        return failure(
            ErrorCode::Busy,
            Text::tr("%1 already controls this mount. Its journal %2 is in use").arg(lock.error().text, m_path));
    } else if (lock.error().code == ErrorCode::Denied && QFileInfo::exists(path)) {
        return failure(
            ErrorCode::Denied,
            Text::tr("%1 cannot be locked (%2). A program of another user may control this mount. Start Boresight as "
                     "that user, or with another --state-dir")
                .arg(path, lock.error().text));
    }
    return {};
}

LoadedJournal JournalFile::load()
{
    QStringList problems;
    if (Result<MountJournal> newest = read(m_path)) {
        return {*newest, {}};
    } else {
        problems.push_back(whatIsWrong(m_path, newest.error()));
    }
    const QString previous = m_path + kPrevious;
    Result<MountJournal> found = read(previous);
    if (found) {
        for (auto& turn : found->turns) {
            if (turn) {
                turn->proveNothing();  // the lost file may have contained a doubt
            }
        }
        problems.push_back(Text::tr("Boresight uses the previous version: %1").arg(previous));
    } else if (found.error().code != ErrorCode::NoDevice) {
        problems.push_back(whatIsWrong(previous, found.error()));
    }
    return {found.value_or(MountJournal()), problems.join(QStringLiteral(". "))};
}

void JournalFile::save(const MountJournal& journal)
{
    m_writer.write([path = m_path, journal] { return write(path, journal); });
}

Result<> JournalFile::flush()
{
    return m_writer.flush();
}

}  // namespace boresight::journal

#include "moc_journal_file.cpp"
