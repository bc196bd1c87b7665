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
    profile::Profile profile;                 // with the overrides of the command line
    QString profilePath;                      // empty: there is no profile at all, so the built-in defaults are used
    QString configDir;                        // of the profile store
    QString stateDir;                         // created if absent
    Simulation simulation = Simulation::Off;  // set by the command line, for every profile
    std::vector<std::string> overridden;      // keys that are overridden also in the simulation, and never written
    std::optional<EnteredPlace> standingAt;

    // The simulation that runs with the profile `of` of another mount.
    [[nodiscard]] Simulation simulationFor(const profile::Profile& of) const { return simulationOf(simulation, of); }
    [[nodiscard]] bool isFirstStart() const { return profilePath.isEmpty(); }
    // The profile with which the window begins. Without any profile the directions of the axes are not confirmed.
    // Exception: a requested simulated mount has confirmed directions and a sensor, so that finding north can be tried
    // at once.
    [[nodiscard]] profile::Profile startingProfile() const;
};

// Why a program does not start.
struct NoStart
{
    Error error;
    bool byItsProfile = false;  // the profile is the reason, not the command line: another profile may work
};

// `arguments` begins with the name of the program. Prints help or version and ends the program if requested. The error
// text is ready to print: one or more lines.
[[nodiscard]] tl::expected<Options, NoStart> readOptions(const QStringList& arguments, const QString& description);

}  // namespace boresight::app
