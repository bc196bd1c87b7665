// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/boresightctl/record_table.h"
#include "app/boresightctl/subcommand.h"
#include "core/base/result.h"
#include "core/profile/profile.h"

#include <optional>
#include <vector>

// The arguments of the subcommands that ask a running station for something.
namespace boresight::ctl {

struct StationOptions
{
    std::optional<profile::ListenAddress> station;  // as given; empty: the one on this computer
    bool json = false;
    std::vector<std::string> places;  // what is no option
};

// `count` is how many arguments that are no options the subcommand has.
[[nodiscard]] Result<StationOptions> parseStationOptions(Arguments arguments, std::size_t count);

// Those of `track`: its places are the words of the target.
[[nodiscard]] Result<StationOptions> parseTrackOptions(Arguments arguments);

// Those of `antenna`: its places are the words of the name, or none.
[[nodiscard]] Result<StationOptions> parseAntennaOptions(Arguments arguments);

struct SatellitesOptions
{
    profile::ListenAddress station{};
    TableFormat format = TableFormat::Csv;
};
[[nodiscard]] Result<SatellitesOptions> parseSatellitesOptions(Arguments arguments);

// What both protocols take: an azimuth of any wrap, -3600°…3600°, and an elevation of -90°…180°.
[[nodiscard]] Result<SkyPointing> parseDirection(const std::string& azimuth, const std::string& elevation);

}  // namespace boresight::ctl
