// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/profile_saver.h"

#include "core/base/text.h"
#include "core/profile/commissioning.h"
#include "core/profile/profile_diff.h"
#include "core/profile/profile_file.h"
#include "core/profile/profile_history.h"
#include "core/profile/profile_store.h"

#include <algorithm>
#include <iterator>

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

// Which keys say of an axis where its zero is: the angles that are counted from it were changed with it.
std::vector<std::string> countedFrom(const std::string& axis)
{
    const std::string limits = "limits." + axis;
    return {axis + ".travel_min_deg", axis + ".travel_max_deg", limits + "_min_deg", limits + "_max_deg",
            "park." + axis + "_deg"};
}

bool contains(const std::vector<std::string>& keys, const std::string& key)
{
    return std::ranges::find(keys, key) != keys.end();
}

// The zero of an axis is not where its profile has it.
bool countsOtherwise(const std::vector<std::string>& differing, const std::string& axis)
{
    return contains(differing, axis + ".offset_deg") || contains(differing, axis + ".sign") ||
           contains(differing, axis + ".id");
}

// Of a mount that was simulated with the profile of a real one: what is left for that one. Not what can only be seen
// on the mount itself, either: which motor is which and how it turns, nor that somebody has looked at it; nor ends
// that are counted from a zero which is not the real one's.
Result<> leaveOutFound(std::vector<std::string>& keys, const profile::Profile& kept, const profile::Profile& wanted)
{
    const std::vector<std::string> differing = profile::changedKeys(kept, wanted);
    std::vector<std::string> simulatedOnes = {"mount.directions", "azimuth.id", "elevation.id", "azimuth.sign",
                                              "elevation.sign"};
    for (const std::string axis : {"azimuth", "elevation"}) {
        if (countsOtherwise(differing, axis)) {
            std::ranges::copy(countedFrom(axis), std::back_inserter(simulatedOnes));
        }
    }
    if (wanted.sensor.source == profile::SensorSource::Simulated) {
        simulatedOnes.push_back("sensor.source");
    }
    const auto isOfTheSimulated = [&simulatedOnes](const std::string& key) {
        return profile::isFoundOfOneMount(key) || contains(simulatedOnes, key);
    };
    if (std::erase_if(keys, isOfTheSimulated) == 0) {
        return {};
    }
    return failure(
        ErrorCode::Refused,
        Text::tr("this holds for the simulated mount until the program ends; the profile of \"%1\" keeps its own "
                 "motors, zeros and the ends counted from them, north, pointing model and sensor mounting: start "
                 "without --simulate to set them")
            .arg(toQString(kept.mount.name)));
}

// A real mount, with the profile of the simulated one: what is found of it, and another bus, makes the file its own,
// with all that is known of that mount. Kept beside the simulated bus it would be left again at the next start; beside
// another bus the simulated mount's would be the real one's.
void becomeReal(profile::Profile& kept, const profile::Profile& wanted, const std::vector<std::string>& keys)
{
    const auto isOfOneMount = [](const std::string& key) {
        return profile::isFoundOfOneMount(key) || key == "mount.directions" || key == "bus.name";
    };
    if (std::ranges::any_of(keys, isOfOneMount)) {
        std::vector<std::string> ofTheMount = profile::changedKeys(kept, wanted);
        std::erase_if(ofTheMount, [&](const std::string& key) { return !isOfOneMount(key) && key != "sensor.source"; });
        profile::takeOver(kept, wanted, ofTheMount);
    }
}

Result<> saveChanges(const QString& configDir, const QString& path, const profile::Profile& wanted,
                     std::vector<std::string> keys, bool onlySimulated)
{
    return profile::loadProfile(path).and_then([&](profile::Profile kept) -> Result<> {
        const std::string name = kept.mount.name;
        Result<> all;
        if (onlySimulated && !profile::isSimulated(kept)) {
            all = leaveOutFound(keys, kept, wanted);
        } else if (!profile::isSimulated(wanted) && profile::isSimulated(kept)) {
            becomeReal(kept, wanted, keys);
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
    m_writer.start([this, wanted, keys, onlySimulated = m_keepsSimulated, configDir = m_configDir, path = m_path] {
        const Result<> saved = path->isEmpty() ? saveNew(configDir, wanted, *path)
                                               : saveChanges(configDir, *path, wanted, keys, onlySimulated);
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
