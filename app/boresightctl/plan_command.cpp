// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/boresightctl/sky_choice.h"
#include "app/boresightctl/sky_time.h"
#include "app/boresightctl/subcommand.h"
#include "app/log_output.h"
#include "core/base/numbers.h"
#include "core/base/text.h"
#include "core/passes/pass_finder.h"
#include "core/plan/plan_pass.h"
#include "core/profile/profile_file.h"
#include "core/targets/target_path.h"
#include "core/targets/track_rules.h"

#include <algorithm>
#include <chrono>
#include <optional>
#include <tuple>

namespace boresight::ctl {
namespace {

constexpr std::chrono::days kSearchedDays{3};

std::string planDegrees(Angle angle, int decimals = 2)
{
    return formatFixed(angle.degrees(), decimals);
}

std::string secondsCell(Seconds time)
{
    return formatFixed(time.count(), 1);
}

// As an interval of ISO 8601.
std::string spanCell(const std::optional<plan::PlanSpan>& span)
{
    return span ? skyTimeCell(span->from) + "/" + skyTimeCell(span->to) : std::string();
}

// The chosen variant first, then the better ones first.
std::vector<const plan::PlanVariant*> inOrder(const plan::PassPlan& plan)
{
    std::vector<const plan::PlanVariant*> all;
    for (const plan::PlanVariant& variant : plan.variants) {
        all.push_back(&variant);
    }
    std::ranges::stable_sort(all, {}, [&](const plan::PlanVariant* one) {
        return std::tuple(one != &plan.best(), one->forecast.beyond, one->forecast.peak);
    });
    return all;
}

RecordTable tableOfVariants(const plan::PassPlan& plan, const passes::Pass& pass)
{
    RecordTable table{.columns = {{"plan"},
                                  {"chosen"},
                                  {"start_az", true},
                                  {"start_el", true},
                                  {"end_az", true},
                                  {"peak_deg", true},
                                  {"rms_deg", true},
                                  {"peak_db", true},
                                  {"beyond_s", true},
                                  {"hidden_s", true},
                                  {"to_start_s", true},
                                  {"margin_deg", true},
                                  {"ramp_utc"},
                                  {"unwrap_utc"},
                                  {"pass_utc"}}};
    for (const plan::PlanVariant* const variant : inOrder(plan)) {
        const plan::Forecast& forecast = variant->forecast;
        const AxisPosition start = variant->start();
        table.rows.push_back(
            {plan::keyOf(variant->way).toStdString(), variant == &plan.best() ? "yes" : "no",
             planDegrees(start.azimuth), planDegrees(start.elevation), planDegrees(variant->end().azimuth),
             planDegrees(forecast.peak, 3), planDegrees(forecast.rms, 3),
             forecast.peakLoss ? formatFixed(*forecast.peakLoss, 2) : std::string(), secondsCell(forecast.beyond),
             secondsCell(forecast.hidden), secondsCell(variant->toStart), planDegrees(variant->margin),
             spanCell(variant->ramp), spanCell(variant->unwrap), spanCell(plan::PlanSpan{pass.aos.utc, pass.los.utc})});
    }
    return table;
}

// What the axes do in the chosen plan, each second.
RecordTable tableOfMotion(const plan::PlanVariant& variant)
{
    RecordTable table{.columns = {{"t_utc"},
                                  {"az_deg", true},
                                  {"el_deg", true},
                                  {"target_az_deg", true},
                                  {"target_el_deg", true},
                                  {"error_deg", true},
                                  {"hidden"}}};
    UtcTime next = variant.moments.front().utc;
    for (const plan::PlannedMoment& moment : variant.moments) {
        if (moment.utc >= next) {
            next = moment.utc + std::chrono::seconds(1);
            table.rows.push_back({skyTimeCell(moment.utc), planDegrees(moment.axes.azimuth, 3),
                                  planDegrees(moment.axes.elevation, 3), planDegrees(moment.target.azimuth, 3),
                                  planDegrees(moment.target.elevation, 3), planDegrees(moment.error, 3),
                                  moment.isHidden ? "yes" : "no"});
        }
    }
    return table;
}

// The next pass of the satellite. The error names what is missing.
Result<passes::Pass> nextPass(const orbit::ElementSet& set, const Site& site, UtcTime from)
{
    const passes::PassList list = passes::findPasses(
        orbit::Sgp4(set), {.site = site, .from = from, .to = from + kSearchedDays, .isClear = nullptr});
    if (!list.passes.empty()) {
        return list.passes.front();
    }
    return failure(
        ErrorCode::NotAvailable,
        list.end ? QStringLiteral("%1: no passes after %2. %3")
                       .arg(satelliteText(set), toQString(skyTimeCell(list.end->utc)), orbit::describe(list.end->fault))
                 : QStringLiteral("%1 does not rise in the %2 days after this time. Use a later --from")
                       .arg(satelliteText(set))
                       .arg(kSearchedDays.count()));
}

Result<plan::PassPlan> planOf(const targets::Target& target, const passes::Pass& pass, const profile::Profile& profile,
                              const std::optional<Angle>& bound)
{
    return plan::planMount(profile, profile.antenna({})).map([&](const plan::PlanMount& mount) {
        targets::TargetPath path(target, profile.site.place(), profile.orbit.refraction);
        const auto directionAt = [&path](UtcTime utc) -> std::optional<SkyPointing> {
            const Result<SkyPointing> direction = path.at(utc);
            return direction ? std::optional(SkyPointing{direction->azimuth, std::max(direction->elevation, 0_deg)})
                             : std::nullopt;
        };
        return plan::planPass(directionAt,
                              {.from = pass.aos.utc, .to = pass.los.utc, .now = profile.park, .bound = bound}, mount);
    });
}

ExitStatus refused(const QString& text)
{
    complain(kPlanCommand, text);
    return kFoundWrong;
}

ExitStatus runPlan(Arguments arguments)
{
    const Result<SkyOptions> options = parsePlanOptions(arguments);
    if (!options) {
        return usageError(kPlanCommand, options.error().text);
    }
    const Result<profile::Profile> profile = profile::loadProfile(options->profileFile);
    if (!profile) {
        app::printError(profile.error().text);
        return kFoundWrong;
    }
    const auto satellites = chosenSatellites(kPlanCommand, *options);
    if (satellites.empty()) {
        return kFoundWrong;
    }
    const orbit::ElementSet& set = satellites.front();
    const targets::Target target = targets::satelliteTarget(set);
    if (const Result<> has = targets::hasSite(target, profile->site.known); !has) {
        return refused(QStringLiteral("%1: %2").arg(options->profileFile, has.error().text));
    }
    const Result<passes::Pass> pass = nextPass(set, profile->site.place(), *options->from);
    if (!pass) {
        return refused(pass.error().text);
    }
    if (const Result<> fresh = targets::isFresh(target, pass->aos.utc, profile->orbit.oldestDays); !fresh) {
        complain(kPlanCommand, fresh.error().text);
    }
    const Result<plan::PassPlan> plan = planOf(target, *pass, *profile, options->bound);
    if (!plan) {
        return refused(plan.error().text);
    }
    if (plan->variants.empty()) {
        return refused(
            QStringLiteral("%1: the mount of this profile reaches no part of the pass").arg(satelliteText(set)));
    }
    const RecordTable table = options->motion ? tableOfMotion(plan->best()) : tableOfVariants(*plan, *pass);
    print(table.text(options->format));
    return kDone;
}

}  // namespace

const Subcommand kPlanCommand{
    .name = "plan",
    .arguments =
        "--profile FILE --elements FILE --norad N --from UTC [--bound DEG] [--motion on|off] [--format FORMAT]",
    .summary = "Plan the next pass of a satellite for a mount, with the pointing error to expect",
    .details =
        R"(  --profile FILE       profile of the mount: its site, limits, horizon, keep-outs, speeds, accelerations, beam width
  --elements FILE      element sets, as in "boresightctl passes". May be given again
  --norad N            the satellite, by its number in the catalogue of NORAD
  --from UTC           the next pass after this time. Like 2024-05-10T04:50:02Z, 2024-05-10, Unix seconds, or now
  --bound DEG          the time with a larger pointing error is reported. Default: half of the beam width, which is -3 dB
  --motion on|off      on: print the motion of the chosen plan, each second, in place of the variants. Default: off
  --format csv|table|json   default: csv

Each row is one way to track the whole pass. The first row is the chosen plan. Columns:
  plan        direct; over-the-top (elevations above 90°); through-the-zenith (changes between both at the highest point);
              other-way-round (the azimuth goes round through the other side at the highest point); waits (at the end of the
              cable); unwraps (the cable, by 360° in the pass)
  chosen      yes or no
  start_az, start_el, end_az      angles of the axes. The azimuth counts turns of the cable
  peak_deg, rms_deg, peak_db      pointing error. peak_db is the loss for the beam width, empty beyond one beam width
  beyond_s    time with an error above the bound
  hidden_s    time in which limits, horizon or keep-outs hide the satellite. It is not in the error
  to_start_s  time from the park position to the start
  margin_deg  of the cable, at its nearer end
  ramp_utc    the azimuth is too slow near the zenith. It leaves the satellite early and returns late: BEGIN/END
  unwrap_utc  the time of the unwrap: BEGIN/END
  pass_utc    AOS/LOS
With --motion on the columns are t_utc,az_deg,el_deg,target_az_deg,target_el_deg,error_deg,hidden.
Exit status: 0 done, 1 no usable profile or element set, or no pass within 3 days.

Example:
  boresightctl plan --profile mount.toml --elements weather.tle --norad 33591 --from now --format table
)",
    .run = runPlan};

}  // namespace boresight::ctl
