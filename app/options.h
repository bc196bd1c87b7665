// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"
#include "core/mount/entered_place.h"
#include "core/mount/simulation.h"
#include "core/profile/profile.h"

#include <QString>
#include <QStringList>

#include <optional>
#include <string>
#include <vector>

// The command line that boresight and boresightd share: which profile, and what overrides it.
namespace boresight::app {

struct Options
{
    profile::Profile profile;                 // with the overrides applied
    QString profilePath;                      // empty: built-in defaults, because there is no profile at all
    QString configDir;                        // of the profile store
    QString stateDir;                         // created if absent
    Simulation simulation = Simulation::Off;  // what the command line asks for, over every profile
    std::vector<std::string> overridden;      // the keys that hold in the simulation, too, and are never written
    std::optional<EnteredPlace> standingAt;

    // What runs with the profile of another mount.
    [[nodiscard]] Simulation simulationFor(const profile::Profile& of) const { return simulationOf(simulation, of); }
    [[nodiscard]] bool isFirstStart() const { return profilePath.isEmpty(); }
    // What the window begins with. Without any profile nobody has looked yet which way the axes turn; unless it is the
    // simulated mount that was asked for, which has its sensor on it, so that finding north can be tried at once.
    [[nodiscard]] profile::Profile startingProfile() const;
};

// Why a program does not start.
struct NoStart
{
    Error error;
    bool byItsProfile = false;  // and not by what was typed: another profile helps
};

// `arguments` with the program's name first. Prints help or version and ends the program when asked for them. The
// error text is ready to print: one or more lines.
[[nodiscard]] tl::expected<Options, NoStart> readOptions(const QStringList& arguments, const QString& description);

}  // namespace boresight::app
