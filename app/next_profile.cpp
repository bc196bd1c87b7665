// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/next_profile.h"

#include "app/fitted_box.h"
#include "core/base/text.h"
#include "core/profile/commissioning.h"
#include "core/profile/profile_diff.h"
#include "core/profile/profile_file.h"
#include "core/profile/profile_store.h"
#include "core/profile/setting.h"

#include <QDir>

#include <algorithm>
#include <optional>
#include <utility>

namespace boresight::app {
namespace {

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

NextProfile::NextProfile(const Options& options, KeptProfile& kept)
    : m_configDir(options.configDir),
      m_simulated(QDir::cleanPath(options.stateDir + QStringLiteral("/simulated/") + folderOfBox(options.simulation))),
      m_asked(options.simulation),
      m_overridden(options.overridden),
      m_ownPath(options.profilePath),
      m_kept(kept)
{}

bool NextProfile::simulates(const profile::Profile& of) const
{
    return simulationOf(m_asked, of) != Simulation::Off;
}

void NextProfile::report(const Result<>& done)
{
    if (!done) {
        m_problems << done.error().text;
    }
}

NextProfile::Choice NextProfile::chosen()
{
    return {.profile = m_kept.last(), .problems = std::exchange(m_problems, {})};
}

NextProfile::Choice NextProfile::first()
{
    const profile::Profile starting = m_kept.last();
    if (simulates(starting)) {
        const profile::Profile own = loaded(m_ownPath).value_or(profile::Profile{});
        profile::Profile fresh = m_ownPath.isEmpty() ? starting : own;
        profile::takeOver(fresh, own, m_overridden);
        simulate(own, fresh);
        profile::Profile with = m_kept.last();
        profile::takeOver(with, starting, m_overridden);
        m_kept.begin(with, m_kept.path());
    }
    return chosen();
}

NextProfile::Choice NextProfile::next(const profile::Profile& wanted)
{
    const profile::Profile& last = m_kept.last();
    const bool simulated = simulates(last);
    if (!simulated) {
        m_ownPath = m_kept.path();  // the first change may have created the file
    }
    const bool sameMount = wanted.mount.name == last.mount.name;
    if (wanted == last || (sameMount && simulated && simulates(wanted))) {
        m_kept.begin(wanted, m_kept.path());
    } else if (simulated && !simulates(wanted) && !isListed(wanted)) {
        report(leaveSimulation(wanted));
    } else {
        report(switchTo(wanted));
    }
    return chosen();
}

bool NextProfile::isListed(const profile::Profile& wanted) const
{
    const auto listed = loaded(fileOf(m_configDir, wanted));
    return listed && profile::changedKeys(*listed, wanted).empty();
}

Result<> NextProfile::switchTo(const profile::Profile& wanted)
{
    if (const Result<> fits = simulates(wanted) ? Result<>{} : profile::fitsRealMount(wanted); !fits) {
        return fits;
    }
    Result<> current;
    if (const auto own = loaded(m_ownPath); !own || own->mount.name != wanted.mount.name) {
        m_ownPath = fileOf(m_configDir, wanted);  // empty: this mount has no file yet
        if (!m_ownPath.isEmpty() && m_asked == Simulation::Off) {
            current = profile::ProfileStore(m_configDir).setCurrent(m_ownPath);
        }
    }
    if (simulates(wanted)) {
        simulate(wanted, wanted);
    } else {
        m_kept.begin(wanted, m_ownPath);
    }
    return current;
}

// The simulation also works without its file. Then each change reports that it is not saved.
void NextProfile::simulate(const profile::Profile& own, const profile::Profile& fresh)
{
    const auto opened = m_simulated.open(own, fittedToBox(m_asked, fresh));
    report(opened.map([](const profile::Profile&) {}));
    m_kept.begin(opened.value_or(fittedToBox(m_asked, fresh)), m_simulated.fileOf(own));
}

// If the file cannot be written, the real mount is connected anyway. If the file cannot be read, or the edits do
// not fit it, the file is left unchanged and the simulation continues.
Result<> NextProfile::leaveSimulation(const profile::Profile& wanted)
{
    const Result<profile::Profile> own = m_ownPath.isEmpty() ? profile::Profile{} : profile::loadProfile(m_ownPath);
    return own.and_then([&](const profile::Profile& before) {
        profile::Profile real = profile::forRealMount(before);
        profile::takeOver(real, wanted, profile::changedKeys(m_kept.last(), wanted));
        real.mount.directions = profile::Directions::Unconfirmed;
        return profile::fitsRealMount(real).and_then([&] {
            const Result<> saved = m_kept.write(real, m_ownPath, before.mount.name);
            if (saved || saved.error().code != ErrorCode::Refused) {
                profile::takeOver(real, wanted, m_overridden);
                m_kept.begin(real, m_ownPath);
            }
            return saved;
        });
    });
}

}  // namespace boresight::app
