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

const std::string kProfileSaverBus = "bus.name";

// Started with --simulate, a bus for later: until the end it stays the simulated mount, and nothing of that one goes
// into the real one's file.
Result<> leaveForLater(profile::Profile& kept, const profile::Profile& before)
{
    if (profile::leaveSimulatedMount(kept, before).empty()) {
        return {};
    }
    return failure(ErrorCode::Refused,
                   Text::tr("\"%1\" is a real mount from the next start on: what was found of the simulated one is set "
                            "back in its file, and its directions are to be confirmed")
                       .arg(toQString(kept.mount.name)));
}

Result<> saveNew(const QString& configDir, profile::Profile profile, const profile::Profile& before, bool onlySimulated,
                 QString& path)
{
    Result<> all = onlySimulated ? leaveForLater(profile, before) : Result<>{};
    const profile::ProfileStore store(configDir);
    return store.add(profile)
        .and_then([&](const QString& added) {
            path = added;
            return store.setCurrent(added);
        })
        .and_then([&] { return all; });
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

bool isOfOneMount(const std::string& key)
{
    return profile::isFoundOfOneMount(key) || key == "mount.directions" || key == kProfileSaverBus;
}

// The zero of an axis is not where its profile has it.
bool countsOtherwise(const std::vector<std::string>& differing, const std::string& axis)
{
    return contains(differing, axis + ".offset_deg") || contains(differing, axis + ".sign") ||
           contains(differing, axis + ".id");
}

// Of a mount that was simulated with the profile of a real one: what is left for that one. Not what can only be seen
// on the mount itself, either: which motor is which and how it turns, nor that somebody has looked at it; nor ends
// that are counted from a zero which is not the real one's; nor its bus, where one that was typed for later is taken
// back: whose file it was before is not known any more.
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
    if (profile::isSimulated(wanted)) {
        simulatedOnes.push_back(kProfileSaverBus);
    }
    const auto isOfTheSimulated = [&simulatedOnes](const std::string& key) {
        return profile::isFoundOfOneMount(key) || contains(simulatedOnes, key);
    };
    if (std::erase_if(keys, isOfTheSimulated) == 0) {
        return {};
    }
    return failure(
        ErrorCode::Refused,
        Text::tr("this holds for the simulated mount until the program ends; the profile of \"%1\" keeps its own bus, "
                 "motors, zeros and the ends counted from them, north, pointing model and sensor mounting: start "
                 "without --simulate to set them")
            .arg(toQString(kept.mount.name)));
}

// With all that is known of the mount that the file is now of.
void takeMount(profile::Profile& kept, const profile::Profile& wanted)
{
    std::vector<std::string> ofTheMount = profile::changedKeys(kept, wanted);
    std::erase_if(ofTheMount, [](const std::string& key) { return !isOfOneMount(key) && key != "sensor.source"; });
    profile::takeOver(kept, wanted, ofTheMount);
}

// What is left of the changes for the file; an error says what is not.
Result<> fit(std::vector<std::string>& keys, profile::Profile& kept, const profile::Profile& wanted, bool onlySimulated)
{
    const bool simulatedFile = profile::isSimulated(kept);
    // A real mount, with the profile of the simulated one: what is found of it, and another bus, makes the file its
    // own. Kept beside the simulated bus it would be left again at the next start; beside another bus the simulated
    // mount's would be the real one's.
    const bool becomesReal = !onlySimulated && simulatedFile && !profile::isSimulated(wanted);
    if (becomesReal && std::ranges::any_of(keys, isOfOneMount)) {
        takeMount(kept, wanted);
        return {};
    }
    return onlySimulated && !simulatedFile ? leaveOutFound(keys, kept, wanted) : Result<>{};
}

Result<> saveChanges(const QString& configDir, const QString& path, const profile::Profile& wanted,
                     std::vector<std::string> keys, bool onlySimulated)
{
    return profile::loadProfile(path).and_then([&](profile::Profile kept) -> Result<> {
        const profile::Profile before = kept;
        Result<> all = fit(keys, kept, wanted, onlySimulated);
        profile::takeOver(kept, wanted, keys);
        if (onlySimulated && profile::isSimulated(before)) {
            all = leaveForLater(kept, before);
        }
        // A new name must not be another mount's.
        const Result<> saved = kept.mount.name == before.mount.name ? profile::saveKeepingPrevious(kept, path)
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
    const profile::Profile before = std::exchange(m_last, wanted);
    m_writer.start([this, wanted, before, onlySimulated = m_keepsSimulated, configDir = m_configDir, path = m_path] {
        const Result<> saved = path->isEmpty() ? saveNew(configDir, wanted, before, onlySimulated, *path)
                                               : saveChanges(configDir, *path, wanted,
                                                             profile::changedKeys(before, wanted), onlySimulated);
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
