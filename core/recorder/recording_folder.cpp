// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/recorder/recording_folder.h"

#include "core/base/text.h"

#include <QDateTime>
#include <QDir>
#include <QFile>
#include <QFileInfo>

#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>

namespace boresight::recorder {
namespace {

constexpr const char* kEnding = ".recording";
constexpr const char* kTimeForm = "yyyyMMdd'T'HHmmss'Z'";
constexpr int kTimeLength = 16;

std::optional<UtcTime> beganOf(const QString& name)
{
    QDateTime time = QDateTime::fromString(name.left(kTimeLength), QLatin1String(kTimeForm));
    time.setTimeSpec(Qt::UTC);
    return time.isValid() ? std::optional(UtcTime(std::chrono::milliseconds(time.toMSecsSinceEpoch()))) : std::nullopt;
}

}  // namespace

QString recordingName(UtcTime began, const QString& target)
{
    constexpr int kLongest = 40;
    const auto ms = std::chrono::floor<std::chrono::milliseconds>(began.time_since_epoch()).count();
    QString name = QDateTime::fromMSecsSinceEpoch(ms, Qt::UTC).toString(QLatin1String(kTimeForm));
    if (!target.isEmpty()) {
        name += u'_' + target.left(kLongest);
    }
    for (QChar& c : name) {
        const bool isPlain = c.unicode() < 128 && (c.isLetterOrNumber() || c == u'-' || c == u'_');
        c = isPlain ? c : QChar(u'_');
    }
    return name + QLatin1String(kEnding);
}

std::vector<StoredRecording> storedRecordings(const QString& folder)
{
    std::vector<StoredRecording> stored;
    const QFileInfoList files =
        QDir(folder).entryInfoList({u'*' + QLatin1String(kEnding)}, QDir::Files | QDir::NoSymLinks, QDir::Name);
    for (const QFileInfo& file : files) {
        if (const auto began = beganOf(file.fileName())) {
            stored.push_back({.name = file.fileName(), .began = *began, .bytes = file.size()});
        }
    }
    std::ranges::stable_sort(stored, {}, &StoredRecording::began);
    return stored;
}

QStringList expired(const std::vector<StoredRecording>& stored, const KeepLimits& limits, UtcTime now,
                    const QString& inWriting)
{
    qint64 bytes = 0;
    for (const StoredRecording& one : stored) {
        bytes += one.bytes;
    }
    QStringList names;
    for (const StoredRecording& one : stored) {
        const bool isOld = limits.age && now - one.began > *limits.age;
        if (one.name != inWriting && (isOld || bytes > limits.bytes)) {
            bytes -= one.bytes;
            names.append(one.name);
        }
    }
    return names;
}

bool deleteExpired(const QString& folder, const KeepLimits& limits, UtcTime now, const QString& inWriting)
{
    bool isAnyDeleted = false;
    for (const QString& name : expired(storedRecordings(folder), limits, now, inWriting)) {
        isAnyDeleted = QFile::remove(QDir(folder).filePath(name)) || isAnyDeleted;
    }
    return isAnyDeleted;
}

Result<> appendWhole(const QString& path, const QByteArray& bytes)
{
    QFile file(path);
    const auto failed = [&path](const QString& reason) {
        return failure(ErrorCode::Io, Text::tr("cannot write %1: %2").arg(path, reason));
    };
    const bool isNew = !file.exists();
    if (!file.open(QIODevice::Append | QIODevice::Unbuffered)) {
        return failed(file.errorString());
    }
    const qint64 before = file.size();
    const bool isWritten = file.write(bytes) == bytes.size();
    if (isWritten && ::fdatasync(file.handle()) == 0) {
        return {};
    }
    const QString reason = isWritten ? toQString(std::strerror(errno)) : file.errorString();
    file.resize(before);  // removes a half-written block
    if (isNew) {
        file.remove();
    }
    return failed(reason);
}

}  // namespace boresight::recorder
