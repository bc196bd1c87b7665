// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/boresightctl/record_table.h"
#include "app/boresightctl/subcommand.h"
#include "core/base/clock.h"
#include "core/base/result.h"
#include "core/ephemeris/refraction.h"
#include "core/ephemeris/sky_object.h"
#include "core/units/site.h"

#include <QString>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

// The command lines of `boresightctl ephemeris`, `boresightctl passes` and `boresightctl plan`, as values. Pure, except
// for the time "now".
namespace boresight::ctl {

struct SkyOptions
{
    std::vector<std::string> elements;  // files, folders and addresses
    std::optional<std::int64_t> number;
    std::optional<ephemeris::SkyObject> object;
    QString table;  // a file
    std::optional<Site> site;
    QString siteFile;     // a .qth file of Gpredict, instead of `site`
    QString profileFile;  // of the mount that is to track the passes; empty: passes are not judged
    QString times;        // a file; "-" is standard input
    std::optional<UtcTime> from;
    std::optional<double> days;
    std::optional<Angle> minimumElevation;
    ephemeris::Refraction refraction = ephemeris::Refraction::None;
    bool doppler = false;        // a column for the Doppler factor
    bool seen = false;           // a column for the parts of each pass that the mount sees
    bool motion = false;         // of a plan: the positions of the axes instead of the variants
    std::optional<Angle> bound;  // of the error of a plan
    TableFormat format = TableFormat::Csv;
};

// Refused if an option is missing, or if an option does not belong to the subcommand.
[[nodiscard]] Result<SkyOptions> parseEphemerisOptions(Arguments arguments);
[[nodiscard]] Result<SkyOptions> parsePassesOptions(Arguments arguments);
[[nodiscard]] Result<SkyOptions> parsePlanOptions(Arguments arguments);

}  // namespace boresight::ctl
