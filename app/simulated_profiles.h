// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"
#include "core/profile/profile.h"

#include <QString>

// The files of the simulation: FOLDER/MOUNT.toml holds what the operator set and found while this mount was simulated.
// The file begins as a copy of the mount's own profile. MOUNT.toml.origin is the profile that was copied, and the next
// simulation of the same profile continues with the copy. After a change of the mount's own profile, the copy is made
// again. An old copy in which anything was set or found stays as MOUNT.toml.old, .old2 and so on. The copy names no
// bus, so it is never used for a real mount. Nothing here writes the files of a real mount. Blocking file access. Two
// programs may share a file: each reads it again before it writes, and replaces it whole.
namespace boresight::app {

class SimulatedProfiles
{
public:
    explicit SimulatedProfiles(const QString& folder) : m_folder(folder) {}

    [[nodiscard]] QString fileOf(const profile::Profile& own) const;
    // The profile with which the simulation of the mount begins. `own` is the mount's own profile, `fresh` the content
    // of a new copy. A copy that cannot be written is an error.
    [[nodiscard]] Result<profile::Profile> open(const profile::Profile& own, const profile::Profile& fresh) const;

private:
    QString m_folder;
};

}  // namespace boresight::app
