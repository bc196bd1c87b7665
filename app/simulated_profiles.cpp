// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/simulated_profiles.h"

#include "core/base/file_name.h"
#include "core/base/text.h"
#include "core/profile/commissioning.h"
#include "core/profile/profile_diff.h"
#include "core/profile/profile_file.h"

#include <QDir>
#include <QFile>

namespace boresight::app {
namespace {

QString freeNameFor(const QString& file)
{
    QString old = file + QStringLiteral(".old");
    for (int number = 2; QFile::exists(old); ++number) {
        old = file + QStringLiteral(".old%1").arg(number);
    }
    return old;
}

}  // namespace

QString SimulatedProfiles::fileOf(const profile::Profile& own) const
{
    return m_folder + QLatin1Char('/') + safeFileName(toQString(own.mount.name)) + QStringLiteral(".toml");
}

Result<profile::Profile> SimulatedProfiles::open(const profile::Profile& own, const profile::Profile& fresh) const
{
    const QString file = fileOf(own);
    const QString originFile = file + QStringLiteral(".origin");
    const auto origin = profile::loadProfile(originFile);
    auto kept = profile::loadProfile(file);
    if (origin && kept && profile::changedKeys(*origin, own).empty()) {
        kept->bus = own.bus;
        return kept;
    }
    QDir().mkpath(m_folder);
    const bool isUnchanged = origin && kept && profile::changedKeys(profile::withoutBus(*origin), *kept).empty();
    if (!isUnchanged) {
        QFile::rename(file, freeNameFor(file));  // not to MOUNT.toml~, which the next change would overwrite
    }
    // The origin is written last. If it is missing, the copy is made again.
    return profile::saveProfile(profile::withoutBus(fresh), file)
        .and_then([&] { return profile::saveProfile(own, originFile); })
        .map([&] { return fresh; });
}

}  // namespace boresight::app
