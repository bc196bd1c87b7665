// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/profile/profile_file.h"

#include "core/base/text.h"
#include "core/profile/setting.h"
#include "core/profile/small_file.h"

#include <QFileInfo>
#include <QStringList>

namespace boresight::profile {

Result<Profile> loadProfile(const QString& path)
{
    return readFile(path).and_then([&](const QByteArray& bytes) {
        return parseProfile({bytes.constData(), static_cast<std::size_t>(bytes.size())}, path);
    });
}

QString exposedSecret(const Profile& profile, const QString& path)
{
    if (!hasSecrets(profile) || (QFileInfo(path).permissions() & QFileDevice::ReadOther) == 0) {
        return {};
    }
    return Text::tr(
               "%1 holds a password, and every user of this computer can read the file. Remove that right: "
               "chmod o-r %1")
        .arg(path);
}

Result<> saveProfile(const Profile& profile, const QString& path)
{
    QStringList all;
    for (const Problem& problem : problemsOf(profile)) {
        all << toText(problem);
    }
    if (!all.isEmpty()) {
        return failure(ErrorCode::InvalidInput, all.join(u'\n'));
    }
    return writeFile(path, QByteArray::fromStdString(toToml(profile)),
                     hasSecrets(profile) ? Readers::OnlyOwner : Readers::Anybody);
}

}  // namespace boresight::profile
