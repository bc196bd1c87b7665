// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/profile/profile_file.h"

#include "core/profile/setting.h"

#include <QFile>
#include <QSaveFile>

namespace boresight::profile {

Result<Profile> loadProfile(const QString& path)
{
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly)) {
        return failure(ErrorCode::NoDevice, path.toStdString() + ": " + file.errorString().toStdString());
    }
    const QByteArray bytes = file.readAll();
    if (file.error() != QFileDevice::NoError) {
        return failure(ErrorCode::Io, path.toStdString() + ": " + file.errorString().toStdString());
    }
    return parseProfile({bytes.constData(), static_cast<std::size_t>(bytes.size())}, path.toStdString());
}

Result<> saveProfile(const Profile& profile, const QString& path)
{
    QSaveFile file(path);
    const QByteArray bytes = QByteArray::fromStdString(toToml(profile));
    if (!file.open(QIODevice::WriteOnly) || file.write(bytes) != bytes.size() || !file.commit()) {
        return failure(ErrorCode::Io, path.toStdString() + ": " + file.errorString().toStdString());
    }
    return {};
}

}  // namespace boresight::profile
