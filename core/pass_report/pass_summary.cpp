// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/pass_report/pass_summary.h"

#include "core/base/text.h"
#include "core/pointing/beam.h"

#include <algorithm>
#include <cmath>

namespace boresight::pass_report {

namespace {

using recording::Event;
using recording::EventKind;
using recording::EventLevel;
using recording::Recording;
using recording::Tick;

// How long tick `i` lasts.
Seconds lengthOfTick(const std::vector<Tick>& ticks, std::size_t i)
{
    if (i + 1 >= ticks.size()) {
        return i > 0 ? lengthOfTick(ticks, i - 1) : Seconds(0.0);
    }
    return std::clamp(Seconds(ticks[i + 1].utc - ticks[i].utc), Seconds(0.0), kLongestTick);
}

bool knowsBeam(const recording::Header& header)
{
    return header.beamWidth > Angle();
}

struct FirstOnTarget
{
    std::size_t begin = 0;    // the first tick of kSettled with the beam on target
    std::size_t settled = 0;  // the first tick after it
};

// Empty: the beam was never on target.
std::optional<FirstOnTarget> firstOnTarget(const Recording& recording)
{
    const Angle bound = 0.5 * recording.header.beamWidth;
    std::optional<std::size_t> begin;
    Seconds settled{};
    for (std::size_t i = 0; i < recording.ticks.size(); ++i) {
        const std::optional<Angle>& error = recording.ticks[i].error;
        if (!error || (knowsBeam(recording.header) && *error > bound)) {
            begin.reset();
            settled = Seconds(0.0);
            continue;
        }
        begin = begin.value_or(i);
        settled += lengthOfTick(recording.ticks, i);
        if (settled >= kSettled - Seconds(1e-6)) {
            return FirstOnTarget{.begin = *begin, .settled = i + 1};
        }
    }
    return std::nullopt;
}

// Whether the plan is one of the time of the ticks.
bool hasPlanOfTicks(const Recording& recording)
{
    return recording.plan && !recording.plan->moments.empty() && !recording.ticks.empty() &&
           recording.plan->moments.front().utc <= recording.ticks.back().utc &&
           recording.plan->moments.back().utc >= recording.ticks.front().utc;
}

// Before the end of the pass, and not hidden, as far as a plan knows it.
bool isInPass(const Recording& recording, UtcTime utc)
{
    if (!hasPlanOfTicks(recording)) {
        return true;
    }
    const auto& moments = recording.plan->moments;
    const auto after = std::ranges::upper_bound(moments, utc, {}, &plan::PlannedMoment::utc);
    if (after == moments.end()) {
        return utc <= moments.back().utc;
    }
    return after == moments.begin() || !std::prev(after)->isHidden;
}

// The smallest of the sorted errors that `part` of them do not exceed.
Angle rankOf(const std::vector<Angle>& sorted, double part)
{
    const double rank = std::ceil(part * static_cast<double>(sorted.size()) - 1e-9);
    return sorted[static_cast<std::size_t>(std::max(rank, 1.0)) - 1];
}

std::optional<ErrorSummary> errorFrom(const Recording& recording, std::size_t first)
{
    ErrorSummary summary;
    std::vector<Angle> errors;
    double squares = 0.0;
    Seconds beyond{};
    for (std::size_t i = first; i < recording.ticks.size(); ++i) {
        const Tick& tick = recording.ticks[i];
        if (!tick.error || !isInPass(recording, tick.utc)) {
            continue;
        }
        if (errors.empty() || *tick.error > summary.peak) {
            summary.peak = *tick.error;
            summary.peakAt = tick.utc;
            summary.peakTarget = tick.target;
        }
        errors.push_back(*tick.error);
        squares += tick.error->radians() * tick.error->radians();
        const Seconds during = lengthOfTick(recording.ticks, i);
        summary.counted += during;
        beyond += *tick.error > 0.5 * recording.header.beamWidth ? during : Seconds(0.0);
    }
    if (errors.empty()) {
        return std::nullopt;
    }
    std::ranges::sort(errors);
    summary.rms = Angle::fromRadians(std::sqrt(squares / static_cast<double>(errors.size())));
    summary.median = rankOf(errors, 0.5);
    summary.most95 = rankOf(errors, 0.95);
    if (knowsBeam(recording.header)) {
        summary.beyond = beyond;
        summary.peakLoss = pointing::pointingLoss(summary.peak, recording.header.beamWidth);
    }
    return summary;
}

void raise(std::optional<Extreme>& extreme, double value, const Tick& tick, Axis axis)
{
    if (!extreme || std::abs(value) > std::abs(extreme->value)) {
        extreme = Extreme{.value = value, .utc = tick.utc, .position = tick.axis(axis).actual};
    }
}

AxisSummary axisSummary(const std::vector<Tick>& ticks, Axis axis)
{
    AxisSummary summary;
    double sum = 0.0;
    std::size_t count = 0;
    for (const Tick& tick : ticks) {
        const recording::AxisTick& one = tick.axis(axis);
        if (one.torque) {
            raise(summary.torque, *one.torque, tick, axis);
            sum += std::abs(*one.torque);
            ++count;
        }
        if (one.rate) {
            raise(summary.rate, (*one.rate * Seconds(1.0)).degrees(), tick, axis);
        }
    }
    if (count > 0) {
        summary.meanTorque = sum / static_cast<double>(count);
    }
    return summary;
}

void widen(std::optional<Angle>& largest, Angle off)
{
    largest = std::max(largest.value_or(Angle()), abs(off));
}

PlanSummary planSummary(const Recording& recording, std::size_t first)
{
    const plan::PlanVariant& plan = *recording.plan;
    PlanSummary summary{.way = plan.way, .forecast = plan.forecast};
    for (std::size_t i = first; i < recording.ticks.size(); ++i) {
        const Tick& tick = recording.ticks[i];
        if (tick.utc < plan.moments.front().utc || tick.utc > plan.moments.back().utc) {
            continue;
        }
        const AxisPosition planned = plan.placeAt(tick.utc);
        if (tick.axes[0].actual) {
            widen(summary.azimuthOff, *tick.axes[0].actual - planned.azimuth);
        }
        if (tick.axes[1].actual) {
            widen(summary.elevationOff, *tick.axes[1].actual - planned.elevation);
        }
    }
    return summary;
}

void addTimes(PassSummary& summary, const Recording& recording)
{
    const std::vector<Tick>& ticks = recording.ticks;
    for (std::size_t i = 0; i + 1 < ticks.size(); ++i) {
        const Seconds step = ticks[i + 1].utc - ticks[i].utc;
        summary.withoutTicks += std::max(step - kLongestTick, Seconds(0.0));
    }
    summary.lostTicks = lostTicks(recording);
    for (const Tick& tick : ticks) {
        if (tick.target && (!summary.highest || tick.target->elevation > summary.highest->elevation)) {
            summary.highest = tick.target;
        }
        if (tick.wind) {
            summary.wind = std::max(summary.wind.value_or(0.0), *tick.wind);
        }
    }
}

// The reader names a missing end among the problems, too.
std::size_t damagesOf(const Recording& recording)
{
    const auto problems = static_cast<std::size_t>(recording.problems.size());
    return recording.hasEnd || problems == 0 ? problems : problems - 1;
}

bool isOfPass(const Recording& recording, const Event& event)
{
    return recording.ticks.empty() || recording.ticks.front().utc - event.utc <= kBeforeTicks;
}

bool isLevel(const Event& event, EventLevel level)
{
    return event.kind != EventKind::ClientLine && event.level == level;
}

// Smaller: more important.
int importanceRank(const Event& event)
{
    if (event.level == EventLevel::Alarm) {
        return 0;
    }
    if (event.level == EventLevel::Warning) {
        return 1;
    }
    return event.kind == EventKind::MotionStart ? 2 : 3;
}

}  // namespace

std::uint64_t lostTicks(const Recording& recording)
{
    std::uint64_t lost = 0;
    for (const recording::Gap& gap : recording.gaps) {
        lost += gap.ticks;
    }
    return lost;
}

Result<PassSummary> summaryOf(const Recording& recording)
{
    if (recording.ticks.empty()) {
        return failure(ErrorCode::NotAvailable,
                       recording.problems.empty()
                           ? Text::tr("The recording has no ticks. It ended before the mount was measured.")
                           : Text::tr("The recording has no readable ticks. %1").arg(recording.problems.front()));
    }
    const std::vector<Tick>& ticks = recording.ticks;
    PassSummary summary{.header = recording.header,
                        .from = ticks.front().utc,
                        .to = ticks.back().utc,
                        .ticks = ticks.size(),
                        .damages = damagesOf(recording),
                        .hasEnd = recording.hasEnd};
    const std::optional<FirstOnTarget> onTarget = firstOnTarget(recording);
    if (onTarget) {
        summary.untilOnTarget = Seconds(ticks[onTarget->begin].utc - ticks.front().utc);
    }
    const std::size_t first = onTarget ? onTarget->settled : 0;
    summary.error = errorFrom(recording, first);
    for (const Axis axis : kAxes) {
        summary.axes[index(axis)] = axisSummary(ticks, axis);
    }
    if (hasPlanOfTicks(recording)) {
        summary.plan = planSummary(recording, first);
    }
    addTimes(summary, recording);
    for (const Event& event : recording.events) {
        if (!isOfPass(recording, event)) {
            continue;
        }
        summary.alarms += isLevel(event, EventLevel::Alarm) ? 1U : 0U;
        summary.warnings += isLevel(event, EventLevel::Warning) ? 1U : 0U;
        summary.motions += event.kind == EventKind::MotionStart ? 1U : 0U;
    }
    return summary;
}

std::vector<Event> importantEvents(const Recording& recording, std::size_t most)
{
    std::vector<Event> events;
    std::ranges::copy_if(recording.events, std::back_inserter(events), [&recording](const Event& event) {
        return event.kind != EventKind::ClientLine && isOfPass(recording, event);
    });
    std::ranges::stable_sort(events, {}, importanceRank);
    events.resize(std::min(events.size(), most));
    std::ranges::stable_sort(events, {}, &Event::utc);
    return events;
}

}  // namespace boresight::pass_report
