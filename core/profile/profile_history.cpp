// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/profile/profile_history.h"

#include "core/profile/profile_file.h"
#include "core/profile/setting.h"
#include "core/profile/small_file.h"

#include <QFileInfo>

namespace boresight::profile {

QString previousOf(const QString& path)
{
    return path + QLatin1Char('~');
}

bool hasPrevious(const QString& path)
{
    return QFileInfo::exists(previousOf(path));
}

Result<> saveKeepingPrevious(const Profile& profile, const QString& path)
{
    if (!QFileInfo::exists(path) || !problemsOf(profile).empty()) {
        return saveProfile(profile, path);  // refuses a profile with problems, so the previous version stays
    }
    return readFile(path).and_then([&](const QByteArray& before) -> Result<> {
        if (before == QByteArray::fromStdString(toToml(profile))) {
            return {};
        }
        return writeFile(previousOf(path), before, readersOf(path)).and_then([&] {
            return saveProfile(profile, path);
        });
    });
}

Result<Profile> undoLastChange(const QString& path)
{
    const Result<QByteArray> now = readFile(path);
    const Result<QByteArray> previous = readFile(previousOf(path));
    if (!now || !previous) {
        return tl::unexpected(now ? previous.error() : now.error());
    }
    // The previous version is restored first. If the second write fails, only this undo cannot be undone.
    return loadProfile(previousOf(path)).and_then([&](const Profile& profile) {
        const Readers before = readersOf(path);
        return writeFile(path, *previous, readersOf(previousOf(path)))
            .and_then([&] { return writeFile(previousOf(path), *now, before); })
            .map([&] { return profile; });
    });
}

}  // namespace boresight::profile
