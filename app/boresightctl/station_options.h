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
    std::optional<profile::ListenAddress> station;  // as entered; empty: the station on this computer
    bool json = false;
    std::vector<std::string> places;  // the arguments that are not options
};

// `count`: the number of arguments of the subcommand that are not options.
[[nodiscard]] Result<StationOptions> parseStationOptions(Arguments arguments, std::size_t count);

// The arguments of `track`: its places are the words of the target.
[[nodiscard]] Result<StationOptions> parseTrackOptions(Arguments arguments);

// The arguments of `antenna`: its places are the words of the name, or empty.
[[nodiscard]] Result<StationOptions> parseAntennaOptions(Arguments arguments);

// The arguments of `console`: its places are the words of the line.
[[nodiscard]] Result<StationOptions> parseConsoleOptions(Arguments arguments);

struct SatellitesOptions
{
    profile::ListenAddress station{};
    TableFormat format = TableFormat::Csv;
};
[[nodiscard]] Result<SatellitesOptions> parseSatellitesOptions(Arguments arguments);

// The range of both protocols: an azimuth of any wrap, -3600°…3600°, and an elevation of -90°…180°.
[[nodiscard]] Result<SkyPointing> parseDirection(const std::string& azimuth, const std::string& elevation);

}  // namespace boresight::ctl
