// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/kept_profile.h"

#include "core/profile/commissioning.h"
#include "core/profile/profile_diff.h"
#include "core/profile/profile_file.h"
#include "core/profile/profile_history.h"
#include "core/profile/profile_store.h"

#include <algorithm>
#include <utility>

namespace boresight::app {
namespace {

// A file without the name of a real bus belongs to the real mount as soon as it holds a value of that mount. Otherwise
// such a value would look like one that an older version found on the simulated mount.
void becomeReal(profile::Profile& kept, std::vector<std::string>& keys)
{
    if (std::ranges::any_of(keys, profile::isOfOneMount)) {
        kept = profile::forRealMount(kept);
        keys.insert(keys.end(), {"bus.name", "mount.directions"});
    }
}

}  // namespace

KeptProfile::KeptProfile(const Options& options)
    : m_configDir(options.configDir),
      m_asked(options.simulation),
      m_overridden(options.overridden),
      m_path(options.profilePath),
      m_last(options.profile)
{}

void KeptProfile::begin(const profile::Profile& profile, const QString& path)
{
    m_last = profile;
    m_path = path;
}

Result<> KeptProfile::save(const profile::Profile& wanted)
{
    const profile::Profile before = std::exchange(m_last, wanted);
    const auto keys = profile::changedKeys(before, wanted);
    return m_path.isEmpty() ? saveNew(wanted, keys) : saveChanges(wanted, keys);
}

Result<> KeptProfile::saveNew(const profile::Profile& wanted, const std::vector<std::string>& keys)
{
    profile::Profile made = wanted;
    profile::takeOver(made, profile::Profile{}, m_overridden);
    profile::takeOver(made, wanted, keys);
    return write(made, m_path, {});
}

Result<> KeptProfile::saveChanges(const profile::Profile& wanted, std::vector<std::string> keys)
{
    return profile::loadProfile(m_path).and_then([&](profile::Profile kept) {
        const std::string nameBefore = kept.mount.name;
        if (simulationOf(m_asked, wanted) == Simulation::Off && profile::namesNoBus(kept)) {
            becomeReal(kept, keys);
        }
        profile::takeOver(kept, wanted, keys);
        return write(kept, m_path, nameBefore);
    });
}

// A new name must not be the name of another mount.
Result<> KeptProfile::write(const profile::Profile& whole, QString& path, const std::string& nameBefore) const
{
    const profile::ProfileStore store(m_configDir);
    if (!path.isEmpty()) {
        return whole.mount.name == nameBefore ? profile::saveKeepingPrevious(whole, path) : store.save(whole, path);
    }
    return store.add(whole).and_then([&](const QString& added) {
        path = added;
        return store.setCurrent(added);
    });
}

}  // namespace boresight::app
