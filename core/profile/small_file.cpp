// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/profile/small_file.h"

#include "core/base/save_whole.h"
#include "core/base/text.h"

#include <QFile>
#include <QFileInfo>
#include <QSaveFile>

namespace boresight::profile {

namespace {

constexpr qint64 kMaxSize = 4 << 20;  // a horizon with a point per 0.1° and long comments needs 300 kB

constexpr auto kOwnerOnly = QFileDevice::ReadOwner | QFileDevice::WriteOwner;

QString told(const QString& path, const QString& reason)
{
    return QStringLiteral("%1: %2").arg(path, reason);
}

}  // namespace

Result<QByteArray> readFile(const QString& path)
{
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly)) {
        return failure(ErrorCode::NoDevice, told(path, file.errorString()));
    }
    const QByteArray bytes = file.read(kMaxSize + 1);
    if (file.error() != QFileDevice::NoError) {
        return failure(ErrorCode::Io, told(path, file.errorString()));
    }
    if (bytes.size() > kMaxSize) {
        return failure(ErrorCode::Io, Text::tr("%1: The file is larger than 4 MB").arg(path));
    }
    return bytes;
}

Result<> writeFile(const QString& path, const QByteArray& bytes, Readers readers)
{
    QSaveFile file(path);
    const auto protect = [&] { return readers == Readers::Anybody || file.setPermissions(kOwnerOnly); };
    if (!file.open(QIODevice::WriteOnly) || !protect() || file.write(bytes) != bytes.size()) {
        return failure(ErrorCode::Io, told(path, file.errorString()));
    }
    if (const auto why = saveWhole(file)) {
        return failure(ErrorCode::Io, told(path, *why));
    }
    return {};
}

Readers readersOf(const QString& path)
{
    constexpr auto kOthers = QFileDevice::ReadGroup | QFileDevice::ReadOther;
    const QFileInfo file(path);
    return file.exists() && (file.permissions() & kOthers) == 0 ? Readers::OnlyOwner : Readers::Anybody;
}

}  // namespace boresight::profile
