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

// Which profile each station begins with, and which file its changes go to. While a mount is simulated that is the
// simulation's own file of this mount. Blocking file access: not on the gui thread, nor the station's.
namespace boresight::app {

class NextProfile
{
public:
    struct Choice
    {
        profile::Profile profile;
        QStringList problems;  // what could not be read or written for it, for the operator
    };

    // `kept` outlives it.
    NextProfile(const Options& options, KeptProfile& kept);

    // What the first station begins with.
    [[nodiscard]] Choice first();
    // What the next station begins with, when a reconnect with `wanted` was asked for: the profile of another mount,
    // the one that was applied last, or a simulated one with a real bus. The latter leaves the simulation: the real
    // mount gets its own profile with what was changed together with the bus. Its directions are to be confirmed.
    // Where that cannot be, it is the mount of before, and a problem says why.
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
    Simulation m_asked;                     // by the command line
    std::vector<std::string> m_overridden;  // by the command line: they hold in the simulation, too
    QString m_ownPath;                      // of the mount's own profile; empty: no file yet
    KeptProfile& m_kept;
    QStringList m_problems;  // of this choice
};

}  // namespace boresight::app
