// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/boresightctl/sky_options.h"
#include "core/elements/element_set.h"

#include <vector>

// The satellites and the site that a command line names. Blocking: reads files and may download.
namespace boresight::ctl {

// All element sets of the files and addresses, or only the set with the entered number. Reports each bad set, and
// reports when no set is left.
[[nodiscard]] std::vector<orbit::ElementSet> chosenSatellites(const Subcommand& subcommand, const SkyOptions& options);

// The form in messages: "ISS (ZARYA) (25544)".
[[nodiscard]] QString satelliteText(const orbit::ElementSet& set);

// The site from the command line or from Gpredict's file.
[[nodiscard]] Result<Site> chosenSite(const SkyOptions& options);

}  // namespace boresight::ctl
