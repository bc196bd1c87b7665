// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/kept_profile.h"
#include "app/options.h"
#include "app/simulated_profiles.h"
#include "core/base/result.h"
#include "core/profile/profile.h"

#include <QString>
#include <QStringList>

#include <string>
#include <vector>

// Chooses the profile with which each station begins, and the file that gets its changes. For a simulated mount this is
// the simulation's own file of that mount. Blocking file access: neither on the gui thread nor on the station thread.
namespace boresight::app {

class NextProfile
{
public:
    struct Choice
    {
        profile::Profile profile;
        QStringList problems;  // what could not be read or written, for the operator
    };

    // `kept` must outlive it.
    NextProfile(const Options& options, KeptProfile& kept);

    // The choice for the first station.
    [[nodiscard]] Choice first();
    // The choice for the next station, after a request to reconnect with `wanted`. That is the profile of another
    // mount, the profile that was applied last, or a simulated profile with a real bus. A real bus ends the simulation:
    // the real mount gets its own profile with the values that were changed together with the bus, and its directions
    // must be confirmed. If this fails, the previous mount stays, and a problem says why.
    [[nodiscard]] Choice next(const profile::Profile& wanted);

private:
    [[nodiscard]] Choice chosen();
    void simulate(const profile::Profile& own, const profile::Profile& fresh);
    [[nodiscard]] bool isListed(const profile::Profile& wanted) const;
    [[nodiscard]] Result<> switchTo(const profile::Profile& wanted);
    [[nodiscard]] Result<> leaveSimulation(const profile::Profile& wanted);
    [[nodiscard]] bool simulates(const profile::Profile& of) const;
    void report(const Result<>& done);

    QString m_configDir;
    SimulatedProfiles m_simulated;
    Simulation m_asked;                     // of the command line
    std::vector<std::string> m_overridden;  // keys that the command line overrides, also in the simulation
    QString m_ownPath;                      // the file of the mount's own profile; empty: no file yet
    KeptProfile& m_kept;
    QStringList m_problems;  // of this choice
};

}  // namespace boresight::app
