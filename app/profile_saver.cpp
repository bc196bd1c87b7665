// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/profile_saver.h"

#include "core/profile/profile_diff.h"
#include "core/profile/profile_file.h"
#include "core/profile/profile_history.h"
#include "core/profile/profile_store.h"

#include <algorithm>

namespace boresight::app {
namespace {

Result<> saveNew(const QString& configDir, const profile::Profile& profile, QString& path)
{
    const profile::ProfileStore store(configDir);
    return store.add(profile).and_then([&](const QString& added) {
        path = added;
        return store.setCurrent(added);
    });
}

Result<> saveChanges(const QString& configDir, const QString& path, const profile::Profile& wanted,
                     const std::vector<std::string>& keys)
{
    return profile::loadProfile(path).and_then([&](profile::Profile kept) {
        const std::string name = kept.mount.name;
        profile::takeOver(kept, wanted, keys);
        // A new name must not be another mount's.
        return kept.mount.name == name ? profile::saveKeepingPrevious(kept, path)
                                       : profile::ProfileStore(configDir).save(kept, path);
    });
}

QString fileOf(const profile::ProfileStore& store, const QString& mountName)
{
    const auto mounts = store.list();
    const auto found = std::ranges::find(mounts, mountName, &profile::StoredProfile::mountName);
    return found != mounts.end() ? found->path : QString();
}

}  // namespace

ProfileSaver::ProfileSaver(const QString& configDir, const QString& path, const profile::Profile& inForce,
                           QObject* parent)
    : QObject(parent), m_configDir(configDir), m_path(std::make_shared<QString>(path)), m_last(inForce)
{
    m_writer.setMaxThreadCount(1);
    m_writer.setExpiryTimeout(-1);
}

ProfileSaver::~ProfileSaver()
{
    m_writer.waitForDone();
}

void ProfileSaver::save(const profile::Profile& wanted)
{
    const auto keys = profile::changedKeys(std::exchange(m_last, wanted), wanted);
    m_writer.start([this, wanted, keys, configDir = m_configDir, path = m_path] {
        const Result<> saved =
            path->isEmpty() ? saveNew(configDir, wanted, *path) : saveChanges(configDir, *path, wanted, keys);
        if (!saved) {
            Q_EMIT failed(QString::fromStdString(saved.error().text));
        }
    });
}

void ProfileSaver::follow(const profile::Profile& connected)
{
    m_last = connected;
    m_writer.start([this, name = QString::fromStdString(connected.mount.name), configDir = m_configDir, path = m_path] {
        const auto kept = profile::loadProfile(*path);
        if (kept && QString::fromStdString(kept->mount.name) == name) {
            return;
        }
        const profile::ProfileStore store(configDir);
        *path = fileOf(store, name);
        if (path->isEmpty()) {
            return;  // of a mount that is not kept yet; its first change makes its file
        }
        if (const Result<> chosen = store.setCurrent(*path); !chosen) {
            Q_EMIT failed(QString::fromStdString(chosen.error().text));
        }
    });
}

}  // namespace boresight::app
