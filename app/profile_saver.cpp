// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/profile_saver.h"

#include "core/base/text.h"
#include "core/profile/commissioning.h"
#include "core/profile/profile_diff.h"
#include "core/profile/profile_file.h"
#include "core/profile/profile_history.h"
#include "core/profile/profile_store.h"
#include "core/profile/setting.h"

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

// A file that names no real bus becomes the real mount's as soon as it holds anything of it. Otherwise what was found
// of it would be taken for what an older version found of the simulated mount.
void becomeReal(profile::Profile& kept, std::vector<std::string>& keys)
{
    if (std::ranges::any_of(keys, profile::isOfOneMount)) {
        kept = profile::forRealMount(kept);
        keys.insert(keys.end(), {"bus.name", "mount.directions"});
    }
}

// A new name must not be another mount's.
Result<> saveOver(const QString& configDir, const QString& path, const profile::Profile& profile,
                  const std::string& nameBefore)
{
    return profile.mount.name == nameBefore ? profile::saveKeepingPrevious(profile, path)
                                            : profile::ProfileStore(configDir).save(profile, path);
}

Result<> saveChanges(const QString& configDir, const QString& path, const profile::Profile& wanted,
                     std::vector<std::string> keys, bool simulated)
{
    return profile::loadProfile(path).and_then([&](profile::Profile kept) {
        const std::string nameBefore = kept.mount.name;
        if (!simulated && profile::namesNoBus(kept)) {
            becomeReal(kept, keys);
        }
        profile::takeOver(kept, wanted, keys);
        return saveOver(configDir, path, kept, nameBefore);
    });
}

QString fileOf(const QString& configDir, const profile::Profile& profile)
{
    const auto mounts = profile::ProfileStore(configDir).list();
    const auto found = std::ranges::find(mounts, toQString(profile.mount.name), &profile::StoredProfile::mountName);
    return found != mounts.end() ? found->path : QString();
}

std::optional<profile::Profile> loaded(const QString& path)
{
    if (path.isEmpty()) {
        return std::nullopt;
    }
    const auto read = profile::loadProfile(path);
    return read ? std::optional(*read) : std::nullopt;
}

}  // namespace

ProfileSaver::ProfileSaver(const Options& options, QObject* parent)
    : QObject(parent),
      m_configDir(options.configDir),
      m_simulated(options.stateDir + QStringLiteral("/simulated")),
      m_asked(options.simulation),
      m_overridden(options.overridden),
      m_ownPath(options.profilePath),
      m_path(std::make_shared<QString>(options.profilePath)),
      m_last(options.profile)
{
    m_writer.setMaxThreadCount(1);
    m_writer.setExpiryTimeout(-1);
    if (simulates(options.profile)) {
        const profile::Profile own = loaded(m_ownPath).value_or(profile::Profile{});
        profile::Profile fresh = options.isFirstStart() ? options.profile : own;
        profile::takeOver(fresh, own, m_overridden);
        m_last = simulate(own, fresh);
        profile::takeOver(m_last, options.profile, m_overridden);
    }
}

ProfileSaver::~ProfileSaver()
{
    m_writer.waitForDone();
}

bool ProfileSaver::simulates(const profile::Profile& of) const
{
    return simulationOf(m_asked, of) != Simulation::Off;
}

void ProfileSaver::report(const Result<>& done)
{
    if (!done) {
        Q_EMIT failed(done.error().text);
    }
}

void ProfileSaver::save(const profile::Profile& wanted)
{
    const profile::Profile before = std::exchange(m_last, wanted);
    const auto keys = profile::changedKeys(before, wanted);
    profile::Profile made = wanted;
    profile::takeOver(made, profile::Profile{}, m_overridden);
    profile::takeOver(made, wanted, keys);
    m_writer.start([this, wanted, made, keys, simulated = simulates(wanted), configDir = m_configDir, path = m_path] {
        report(path->isEmpty() ? saveNew(configDir, made, *path)
                               : saveChanges(configDir, *path, wanted, keys, simulated));
    });
}

profile::Profile ProfileSaver::next(const profile::Profile& wanted)
{
    m_writer.waitForDone();
    const bool simulated = simulates(m_last);
    if (!simulated) {
        m_ownPath = *m_path;  // the first change may have made it
    }
    const bool sameMount = wanted.mount.name == m_last.mount.name;
    if (wanted == m_last || (sameMount && simulated && simulates(wanted))) {
        m_last = wanted;
    } else if (simulated && !simulates(wanted) && !isListed(wanted)) {
        report(leaveSimulation(wanted));
    } else {
        report(switchTo(wanted));
    }
    return m_last;
}

bool ProfileSaver::isListed(const profile::Profile& wanted) const
{
    const auto listed = loaded(fileOf(m_configDir, wanted));
    return listed && profile::changedKeys(*listed, wanted).empty();
}

Result<> ProfileSaver::switchTo(const profile::Profile& wanted)
{
    if (const Result<> fits = simulates(wanted) ? Result<>{} : profile::fitsRealMount(wanted); !fits) {
        return fits;
    }
    Result<> chosen;
    if (const auto own = loaded(m_ownPath); !own || own->mount.name != wanted.mount.name) {
        m_ownPath = fileOf(m_configDir, wanted);  // empty: of a mount that is not kept yet
        if (!m_ownPath.isEmpty() && m_asked == Simulation::Off) {
            chosen = profile::ProfileStore(m_configDir).setCurrent(m_ownPath);
        }
    }
    *m_path = m_ownPath;
    m_last = simulates(wanted) ? simulate(wanted, wanted) : wanted;
    return chosen;
}

// The simulation works without its file too: then each change reports that it is not kept.
profile::Profile ProfileSaver::simulate(const profile::Profile& own, const profile::Profile& fresh)
{
    *m_path = m_simulated.fileOf(own);
    const auto opened = m_simulated.open(own, fresh);
    report(opened.map([](const profile::Profile&) {}));
    return opened.value_or(fresh);
}

// Where the file cannot be written the real mount is connected all the same. A file that cannot be read, or that the
// edits do not go with, is left alone, and the simulation goes on.
Result<> ProfileSaver::leaveSimulation(const profile::Profile& wanted)
{
    const Result<profile::Profile> own = m_ownPath.isEmpty() ? profile::Profile{} : profile::loadProfile(m_ownPath);
    return own.and_then([&](const profile::Profile& kept) {
        profile::Profile real = profile::forRealMount(kept);
        profile::takeOver(real, wanted, profile::changedKeys(m_last, wanted));
        real.mount.directions = profile::Directions::Unconfirmed;
        return profile::fitsRealMount(real).and_then([&] {
            const Result<> saved = m_ownPath.isEmpty() ? saveNew(m_configDir, real, m_ownPath)
                                                       : saveOver(m_configDir, m_ownPath, real, kept.mount.name);
            if (saved || saved.error().code != ErrorCode::Refused) {
                m_last = real;
                profile::takeOver(m_last, wanted, m_overridden);
                *m_path = m_ownPath;
            }
            return saved;
        });
    });
}

}  // namespace boresight::app

#include "moc_profile_saver.cpp"
