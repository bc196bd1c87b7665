// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/plan/pass_plan.h"

#include "core/pointing/beam.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace boresight::plan {

namespace {

// Between two moments by their positions and rates, exact for a constant acceleration.
Angle between(Angle from, AngularRate fromRate, Angle to, AngularRate toRate, Seconds step, double part)
{
    const double rest = 1.0 - part;
    return rest * rest * (1.0 + 2.0 * part) * from + part * part * (3.0 - 2.0 * part) * to +
           (part * rest * rest) * (fromRate * step) - (part * part * rest) * (toRate * step);
}

// Keeps the variants whose value is at most `slack` above the least one.
template <class Value, class ValueOf>
void keepLeast(std::vector<std::size_t>& left, Value slack, const ValueOf& valueOf)
{
    const auto best = valueOf(*std::ranges::min_element(left, {}, valueOf));
    std::erase_if(left, [&](std::size_t i) { return valueOf(i) > best + slack; });
}

}  // namespace

AxisPosition PlanVariant::placeAt(UtcTime utc) const
{
    const auto after = std::ranges::upper_bound(moments, utc, {}, &PlannedMoment::utc);
    if (after == moments.begin() || after == moments.end()) {
        return after == moments.end() ? end() : start();
    }
    const PlannedMoment& from = *std::prev(after);
    const PlannedMoment& to = *after;
    const Seconds step = to.utc - from.utc;
    const double part = Seconds(utc - from.utc) / step;
    return {.azimuth = between(from.axes.azimuth, from.rates.azimuth, to.axes.azimuth, to.rates.azimuth, step, part),
            .elevation =
                between(from.axes.elevation, from.rates.elevation, to.axes.elevation, to.rates.elevation, step, part)};
}

QString keyOf(PlanWay way)
{
    constexpr std::array kKeys{"direct",          "over-the-top", "through-the-zenith",
                               "other-way-round", "waits",        "unwraps"};  // in the order of PlanWay
    return QString::fromLatin1(kKeys.at(static_cast<std::size_t>(way)));
}

Forecast forecastOf(const std::vector<PlannedMoment>& moments, Angle bound, Angle beamWidth)
{
    Forecast forecast;
    double squares = 0.0;
    Seconds seen{};
    for (std::size_t i = 0; i < moments.size(); ++i) {
        const PlannedMoment& here = moments[i];
        const Seconds before = i > 0 ? 0.5 * Seconds(here.utc - moments[i - 1].utc) : Seconds(0.0);
        const Seconds after = i + 1 < moments.size() ? 0.5 * Seconds(moments[i + 1].utc - here.utc) : Seconds(0.0);
        if (here.isHidden) {
            forecast.hidden += before + after;
            continue;
        }
        seen += before + after;
        squares += here.error.radians() * here.error.radians() * (before + after).count();
        forecast.peak = std::max(forecast.peak, here.error);
        forecast.beyond += here.error > bound ? before + after : Seconds(0.0);
    }
    forecast.rms = Angle::fromRadians(seen > Seconds(0.0) ? std::sqrt(squares / seen.count()) : 0.0);
    forecast.peakLoss = pointing::pointingLoss(forecast.peak, beamWidth);
    return forecast;
}

ChosenWay choiceFor(const PlanVariant& variant)
{
    return {.way = variant.way, .startAzimuth = variant.start().azimuth};
}

std::optional<std::size_t> indexOf(const PassPlan& plan, const ChosenWay& choice)
{
    std::optional<std::size_t> nearest;
    const auto apart = [&](std::size_t i) { return abs(plan.variants[i].start().azimuth - choice.startAzimuth); };
    for (std::size_t i = 0; i < plan.variants.size(); ++i) {
        if (plan.variants[i].way == choice.way && (!nearest || apart(i) < apart(*nearest))) {
            nearest = i;
        }
    }
    return nearest && apart(*nearest) < 180_deg ? nearest : std::nullopt;
}

std::size_t choiceOf(const std::vector<PlanVariant>& variants, Angle beamWidth, Begins begins)
{
    constexpr Seconds kSameTime{0.5};
    const Angle sameError = std::max(Angle::fromDegrees(0.05), beamWidth * std::sqrt(0.1 / 12.0));  // 0.1 dB
    constexpr Seconds kSameSlew{0.01};
    std::vector<std::size_t> left(variants.size());
    std::iota(left.begin(), left.end(), std::size_t{0});
    keepLeast(left, kSameTime, [&](std::size_t i) {
        return variants[i].forecast.beyond + (begins == Begins::Now ? variants[i].toStart : Seconds(0.0));
    });
    keepLeast(left, sameError, [&](std::size_t i) { return variants[i].forecast.peak; });
    keepLeast(left, 0, [&](std::size_t i) { return static_cast<int>(variants[i].way); });
    keepLeast(left, kSameSlew, [&](std::size_t i) { return variants[i].toStart; });
    return *std::ranges::max_element(left, {}, [&](std::size_t i) { return variants[i].margin; });
}

}  // namespace boresight::plan
