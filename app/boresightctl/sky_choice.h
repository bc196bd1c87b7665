// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/boresightctl/sky_options.h"
#include "core/elements/element_set.h"

#include <vector>

// The satellites and the site that a command line means. Blocking: they are in files, or downloaded.
namespace boresight::ctl {

// The element sets of the files and addresses, or the one of the number. Reports each bad set, and when none is left.
[[nodiscard]] std::vector<orbit::ElementSet> chosenSatellites(const Subcommand& subcommand, const SkyOptions& options);

// "ISS (ZARYA) (25544)" in messages.
[[nodiscard]] QString satelliteText(const orbit::ElementSet& set);

// As it is typed, or of the file of Gpredict.
[[nodiscard]] Result<Site> chosenSite(const SkyOptions& options);

}  // namespace boresight::ctl
