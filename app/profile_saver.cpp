// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/profile_saver.h"

#include "core/base/bus_name.h"
#include "core/base/text.h"
#include "core/profile/profile_diff.h"
#include "core/profile/profile_file.h"
#include "core/profile/profile_history.h"
#include "core/profile/profile_store.h"

#include <algorithm>

namespace boresight::app {
namespace {

const std::string kSimulated = toString(BusName{});

Result<> saveNew(const QString& configDir, const profile::Profile& profile, QString& path)
{
    const profile::ProfileStore store(configDir);
    return store.add(profile).and_then([&](const QString& added) {
        path = added;
        return store.setCurrent(added);
    });
}

// Where north is, how the axes lean, what iron does to the compass: found by calibrating, and true of one mount alone.
bool isFound(const std::string& key)
{
    return key.starts_with("pointing.") || key.starts_with("sensor.deviation_") || key == "sensor.azimuth_sense" ||
           key == "sensor.azimuth_offset_deg" || key == "sensor.elevation_offset_deg";
}

// Of a mount that was simulated with the profile of a real one: what is left for that one.
Result<> leaveOutFound(std::vector<std::string>& keys, const std::string& mountName)
{
    if (std::erase_if(keys, isFound) == 0) {
        return {};
    }
    return failure(
        ErrorCode::Refused,
        Text::tr("this holds for the simulated mount until the program ends; the profile of \"%1\" keeps its "
                 "own north, pointing model and sensor mounting: start without --simulate to calibrate it")
            .arg(toQString(mountName)));
}

Result<> saveChanges(const QString& configDir, const QString& path, const profile::Profile& wanted,
                     std::vector<std::string> keys, const std::string& busInForce)
{
    return profile::loadProfile(path).and_then([&](profile::Profile kept) -> Result<> {
        const std::string name = kept.mount.name;
        Result<> all;
        if (busInForce == kSimulated && kept.bus != kSimulated) {
            all = leaveOutFound(keys, name);
        }
        profile::takeOver(kept, wanted, keys);
        // A new name must not be another mount's.
        const Result<> saved = kept.mount.name == name ? profile::saveKeepingPrevious(kept, path)
                                                       : profile::ProfileStore(configDir).save(kept, path);
        return saved.and_then([&] { return all; });
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
    : QObject(parent),
      m_configDir(configDir),
      m_path(std::make_shared<QString>(path)),
      m_last(inForce),
      m_bus(inForce.bus)
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
    m_writer.start([this, wanted, keys, bus = m_bus, configDir = m_configDir, path = m_path] {
        const Result<> saved =
            path->isEmpty() ? saveNew(configDir, wanted, *path) : saveChanges(configDir, *path, wanted, keys, bus);
        if (!saved) {
            Q_EMIT failed(QString::fromStdString(saved.error().text));
        }
    });
}

void ProfileSaver::follow(const profile::Profile& connected)
{
    m_last = connected;
    m_bus = connected.bus;
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
