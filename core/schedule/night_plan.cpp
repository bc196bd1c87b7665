// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/schedule/night_plan.h"

#include <algorithm>
#include <array>
#include <compare>
#include <utility>

namespace boresight::schedule {
namespace {

// "Less" means that the first pass is preferred by this criterion.
std::partial_ordering compare(const WatchedPass& a, const WatchedPass& b, Reason by)
{
    switch (by) {
        case Reason::Priority:
            return a.priority <=> b.priority;
        case Reason::Longer:
            return b.pass.clearTime().count() <=> a.pass.clearTime().count();
        case Reason::Earlier:
            return a.begins().time_since_epoch().count() <=> b.begins().time_since_epoch().count();
        case Reason::LowerNumber:
            break;
    }
    return a.number <=> b.number;
}

using Reasons = std::array<Reason, 4>;

Reasons reasonsOf(OverlapPolicy policy)
{
    switch (policy) {
        case OverlapPolicy::Longest:
            return {Reason::Longer, Reason::Priority, Reason::Earlier, Reason::LowerNumber};
        case OverlapPolicy::First:
            return {Reason::Earlier, Reason::Priority, Reason::Longer, Reason::LowerNumber};
        case OverlapPolicy::Priority:
            break;
    }
    return {Reason::Priority, Reason::Longer, Reason::Earlier, Reason::LowerNumber};
}

bool isPreferred(const WatchedPass& a, const WatchedPass& b, const Reasons& reasons)
{
    for (const Reason by : reasons) {
        if (const auto order = compare(a, b, by); order != std::partial_ordering::equivalent) {
            return order == std::partial_ordering::less;
        }
    }
    return false;
}

Reason reasonFor(const WatchedPass& chosen, const WatchedPass& leftOut, const Reasons& reasons)
{
    const auto* const found = std::ranges::find_if(
        reasons, [&](Reason by) { return compare(chosen, leftOut, by) == std::partial_ordering::less; });
    return found == reasons.end() ? Reason::LowerNumber : *found;
}

bool overlap(const WatchedPass& a, const WatchedPass& b)
{
    return a.begins() < b.ends() && b.begins() < a.ends();
}

bool fitBoth(const WatchedPass& a, const WatchedPass& b, Seconds lead)
{
    const bool isFirst = a.begins() <= b.begins();
    const WatchedPass& first = isFirst ? a : b;
    const WatchedPass& second = isFirst ? b : a;
    return !overlap(a, b) && Seconds(second.begins() - first.ends()) >= lead;
}

// Between two chosen passes, or before the first or after the last one.
struct Gap
{
    passes::Stretch time;
    UtcTime ready{};  // the mount is in place from this time on
};

// The gaps in the time of a pass that the chosen passes leave. The lead before a chosen pass belongs to that pass.
std::vector<Gap> gapsOf(const WatchedPass& pass, const std::vector<WatchedPass>& chosen, Seconds lead)
{
    const auto wait = std::chrono::round<UtcTime::duration>(lead);
    std::vector<Gap> gaps;
    UtcTime from = pass.begins();
    UtcTime ready = from;
    const auto addUntil = [&](UtcTime to) {
        if (from < to) {
            gaps.push_back({.time = {.from = from, .to = to}, .ready = ready});
        }
    };
    for (const WatchedPass& one : chosen) {
        addUntil(std::min(pass.ends(), one.begins() - wait));
        from = std::max(from, one.ends());
        ready = std::max(ready, one.ends() + wait);
    }
    addUntil(pass.ends());
    return gaps;
}

passes::Pass cutTo(const passes::Stretch& time, passes::Pass pass)
{
    std::vector<passes::Stretch> clear;
    for (const passes::Stretch& one : pass.clear) {
        const passes::Stretch part{.from = std::max(one.from, time.from), .to = std::min(one.to, time.to)};
        if (part.from < part.to) {
            clear.push_back(part);
        }
    }
    pass.clear = std::move(clear);
    return pass;
}

// The rests of a pass that is left out. They take no time from the chosen passes.
void chooseRests(Conflict& conflict, std::vector<WatchedPass>& chosen, Seconds lead)
{
    for (const Gap& gap : gapsOf(conflict.leftOut, chosen, lead)) {
        const passes::Stretch inPlace{.from = std::max(gap.time.from, gap.ready), .to = gap.time.to};
        if (cutTo(inPlace, conflict.leftOut.pass).clearTime() >= kShortestRest) {
            WatchedPass rest = conflict.leftOut;
            rest.pass = cutTo(gap.time, rest.pass);
            rest.rest = gap.time;
            conflict.rests.push_back(gap.time);
            chosen.push_back(std::move(rest));
        }
    }
    std::ranges::stable_sort(chosen, {}, &WatchedPass::begins);
}

}  // namespace

// Takes the most preferred pass first. A pass that is left out does not exclude other passes. The rests of these passes
// come last, so that no rest excludes a whole pass.
NightPlan planNight(std::vector<WatchedPass> candidates, const PlanRules& rules)
{
    const Reasons reasons = reasonsOf(rules.policy);
    std::ranges::sort(candidates,
                      [&](const WatchedPass& a, const WatchedPass& b) { return isPreferred(a, b, reasons); });
    NightPlan plan;
    for (WatchedPass& one : candidates) {
        if (one.isHidden()) {
            plan.hidden.push_back(std::move(one));
            continue;
        }
        const auto rival = std::ranges::find_if(
            plan.chosen, [&](const WatchedPass& other) { return !fitBoth(one, other, rules.lead); });
        if (rival == plan.chosen.end()) {
            plan.chosen.push_back(std::move(one));
        } else {
            plan.conflicts.push_back({.leftOut = one,
                                      .chosen = *rival,
                                      .reason = reasonFor(*rival, one, reasons),
                                      .overlaps = overlap(one, *rival)});
        }
    }
    std::ranges::stable_sort(plan.chosen, {}, &WatchedPass::begins);
    for (Conflict& conflict : plan.conflicts) {
        chooseRests(conflict, plan.chosen, rules.lead);
    }
    std::ranges::stable_sort(plan.conflicts, {}, [](const Conflict& one) { return one.leftOut.begins(); });
    std::ranges::stable_sort(plan.hidden, {}, &WatchedPass::begins);
    return plan;
}

}  // namespace boresight::schedule
