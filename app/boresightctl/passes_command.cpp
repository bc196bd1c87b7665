// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/boresightctl/sky_choice.h"
#include "app/boresightctl/sky_time.h"
#include "app/boresightctl/subcommand.h"
#include "app/log_output.h"
#include "core/base/numbers.h"
#include "core/base/text.h"
#include "core/elements/julian_date.h"
#include "core/passes/pass_finder.h"
#include "core/profile/clear_sky.h"
#include "core/profile/profile_file.h"
#include "core/targets/cable_turns.h"
#include "core/targets/pass_way.h"
#include "core/units/degrees_text.h"

#include <algorithm>
#include <chrono>
#include <functional>
#include <optional>

namespace boresight::ctl {
namespace {

constexpr int kDegreeDecimals = 4;

struct FoundPass
{
    const orbit::ElementSet* set;
    passes::Pass pass;
};

// The mount that is to track the passes, with its main antenna.
struct Mount
{
    std::function<bool(const SkyPointing&)> isClear;
    targets::MountReach reach;
};

Result<std::optional<Mount>> chosenMount(const QString& file)
{
    if (file.isEmpty()) {
        return std::nullopt;
    }
    return profile::loadProfile(file).map([](const profile::Profile& profile) {
        const pointing::Antenna antenna = profile.antenna({});
        return std::optional(
            Mount{.isClear = profile::clearSky(profile, antenna), .reach = targets::reachOf(profile, antenna)});
    });
}

// Flags that show how well the mount can track the pass.
std::string mountFlagsOf(const FoundPass& found, const Site& site, const Mount& mount)
{
    constexpr Seconds kHidden{1.0};
    const auto& [set, pass] = found;
    const targets::CableTurns cable = targets::cableTurns(*targets::wayOf(pass, *set, site), mount.reach);
    return std::string(pass.duration() - pass.clearTime() >= kHidden ? "H" : "") + (cable.turns > 0 ? "U" : "") +
           (cable.fitsOverTheTop ? "F" : "");
}

std::string flagsOf(const FoundPass& found, const Site& site, const std::optional<Mount>& mount)
{
    const passes::Pass& pass = found.pass;
    const std::string flags = std::string(pass.isUpAtStart ? "A" : "") + (pass.isUpAtEnd ? "L" : "") +
                              (pass.maxima > 1 ? "M" : "") + (mount ? mountFlagsOf(found, site, *mount) : "");
    return flags.empty() ? "-" : flags;
}

std::string degreesCell(Angle angle)
{
    return formatFixed(angle.degrees(), kDegreeDecimals);
}

// The parts that the antenna sees, as intervals of ISO 8601.
std::string seenCell(const passes::Pass& pass)
{
    std::string all;
    for (const passes::Stretch& part : pass.clear) {
        all += (all.empty() ? "" : " ") + skyTimeCell(part.from) + "/" + skyTimeCell(part.to);
    }
    return all;
}

RecordTable tableOf(const std::vector<FoundPass>& found, const Site& site, const std::optional<Mount>& mount,
                    bool hasSeen)
{
    RecordTable table{.columns = {{"name"},
                                  {"norad", true},
                                  {"aos_utc"},
                                  {"aos_az", true},
                                  {"tca_utc"},
                                  {"tca_az", true},
                                  {"max_el", true},
                                  {"los_utc"},
                                  {"los_az", true},
                                  {"flags"}}};
    if (hasSeen) {
        table.columns.push_back({"seen_utc"});
    }
    for (const FoundPass& one : found) {
        const auto& [set, pass] = one;
        table.rows.push_back({set->name, std::to_string(set->number), skyTimeCell(pass.aos.utc),
                              degreesCell(pass.aos.direction.azimuth), skyTimeCell(pass.tca.utc),
                              degreesCell(pass.tca.direction.azimuth), degreesCell(pass.tca.direction.elevation),
                              skyTimeCell(pass.los.utc), degreesCell(pass.los.direction.azimuth),
                              flagsOf(one, site, mount)});
        if (hasSeen) {
            table.rows.back().push_back(seenCell(pass));
        }
    }
    return table;
}

// Reports on standard error what the table cannot show about a satellite.
void report(const orbit::ElementSet& set, const passes::PassList& list, const passes::PassSearch& search, bool isAsked)
{
    if (list.end) {
        complain(kPassesCommand,
                 QStringLiteral("%1: no passes after %2. %3")
                     .arg(satelliteText(set), toQString(skyTimeCell(list.end->utc)), orbit::describe(list.end->fault)));
    } else if (list.passes.empty() && isAsked) {
        complain(kPassesCommand, QStringLiteral("%1 does not rise above %2 in this time")
                                     .arg(satelliteText(set), degreesText(search.minimumElevation)));
    }
}

// The longest time between the epoch and the searched time.
Seconds distance(const orbit::ElementSet& set, const passes::PassSearch& search)
{
    const UtcTime epoch = orbit::utcTime(set.epoch);
    return std::max(Seconds(search.to - epoch), Seconds(epoch - search.from));
}

// One line for all satellites: a file of old elements has old elements of each.
void reportOldElements(const std::vector<orbit::ElementSet>& satellites, const passes::PassSearch& search)
{
    constexpr Seconds kLongest = std::chrono::days(30);  // as the station refuses elements by default
    const auto isOld = [&](const orbit::ElementSet& set) { return distance(set, search) > kLongest; };
    const auto first = std::ranges::find_if(satellites, isOld);
    if (first == satellites.end()) {
        return;
    }
    const auto days = std::chrono::duration<double, std::chrono::days::period>(distance(*first, search));
    const auto count = std::ranges::count_if(satellites, isOld);
    const QString others = count == 1 ? QString() : QStringLiteral(" and %1 more satellites").arg(count - 1);
    complain(kPassesCommand, QStringLiteral("%1%2: the elements are up to %3 days from this time. The passes may come "
                                            "minutes earlier or later. Use newer elements")
                                 .arg(satelliteText(*first), others)
                                 .arg(days.count(), 0, 'f', 0));
}

ExitStatus runPasses(Arguments arguments)
{
    const Result<SkyOptions> options = parsePassesOptions(arguments);
    if (!options) {
        return usageError(kPassesCommand, options.error().text);
    }
    const Result<Site> site = chosenSite(*options);
    if (!site) {
        app::printError(site.error().text);
        return kFoundWrong;
    }
    const Result<std::optional<Mount>> mount = chosenMount(options->profileFile);
    if (!mount) {
        app::printError(mount.error().text);
        return kFoundWrong;
    }
    const auto satellites = chosenSatellites(kPassesCommand, *options);
    if (satellites.empty()) {
        return kFoundWrong;
    }
    using Days = std::chrono::duration<double, std::chrono::days::period>;
    const passes::PassSearch search{.site = *site,
                                    .from = *options->from,
                                    .to = *options->from + std::chrono::round<UtcTime::duration>(Days(*options->days)),
                                    .minimumElevation = options->minimumElevation.value_or(0_deg),
                                    .isClear = *mount ? (*mount)->isClear : nullptr};
    std::vector<FoundPass> found;
    for (const orbit::ElementSet& set : satellites) {
        const passes::PassList list = passes::findPasses(orbit::Sgp4(set), search);
        for (const passes::Pass& pass : list.passes) {
            found.push_back({&set, pass});
        }
        report(set, list, search, options->number.has_value());
    }
    reportOldElements(satellites, search);
    std::ranges::stable_sort(found, {}, [](const FoundPass& one) { return one.pass.aos.utc; });
    print(tableOf(found, *site, *mount, options->seen).text(options->format));
    return kDone;
}

}  // namespace

const Subcommand kPassesCommand{
    .name = "passes",
    .arguments =
        "--elements FILE [--norad N] --site LAT,LON,ALT --from UTC --days D [--min-el DEG] [--profile FILE] "
        "[--seen on|off] [--format FORMAT]",
    .summary = "List when satellites are up over a site",
    .details =
        R"(  --elements FILE      element sets: TLE, OMM as JSON, CSV, XML or KVN, or NUMBER.sat of Gpredict. A folder: all files
                       in it. The folder of Gpredict: its satdata. NAME.mod: the satellites of this module of Gpredict. An
                       https address, or celestrak:GROUP: downloaded into the cache, at most every two hours. May be
                       given again. Of several sets of one satellite the newest epoch is used
  --norad N            one satellite, by its number in the catalogue of NORAD. Default: all satellites
  --site LAT,LON,ALT   degrees north, degrees east, metres above the ellipsoid of WGS-84. Or a NAME.qth of Gpredict
  --from UTC           like 2024-05-10T04:50:02Z, 2024-05-10, Unix seconds, or now
  --days D             up to 3660
  --min-el DEG         lowest elevation. Default: 0
  --profile FILE       profile of a mount, for the flags H, U and F. The site is still that of --site
  --seen on|off        on, with --profile: a last column seen_utc has the parts of the pass that the antenna sees, as
                       BEGIN/END BEGIN/END. Horizon, keep-outs and limits of the profile count. Default: off
  --format csv|table|json   default: csv

Columns: name,norad,aos_utc,aos_az,tca_utc,tca_az,max_el,los_utc,los_az,flags, in the order of AOS. At AOS and
LOS the satellite passes the lowest elevation, without refraction. At TCA it is highest. Azimuth counts from true north
through east.
Flags: A already up at the beginning, L still up at the end, M several maxima, - none of these.
With a profile also: H horizon, keep-outs or limits hide a part of the pass. U the azimuth cable ends during the pass, so
Boresight unwraps it and loses a part of the pass. F Boresight goes over the top instead, with elevations above 90°, and loses
no part of the pass.
Each bad element set is reported as FILE:LINE: reason, and the others are used. A satellite that decays within the time is
reported, too, and elements more than 30 days from the time.
Exit status: 0 done, also without any pass, 1 no usable element set, or a site that cannot be read.

Example:
  boresightctl passes --elements weather.tle --site 38.757,-9.117,80 --from now --days 2 --min-el 10 --format table
)",
    .run = runPasses};

}  // namespace boresight::ctl
