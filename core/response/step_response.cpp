// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/response/step_response.h"

#include "core/base/text.h"

#include <algorithm>

namespace boresight::response {
namespace {

constexpr std::size_t kFewestAfterwards = 8;
constexpr Angle kSamePlace = Angle::fromDegrees(1e-6);

// The index of the first sample from which on the set-point stays at its end.
std::size_t arrivalIn(Samples samples)
{
    const Angle end = samples.back().wanted;
    std::size_t first = samples.size() - 1;
    while (first > 0 && abs(samples[first - 1].wanted - end) <= kSamePlace) {
        --first;
    }
    return first;
}

std::optional<Seconds> settlingIn(Samples afterwards, Angle end, Angle band)
{
    const auto outside = [&](const Sample& one) { return abs(one.actual - end) > band; };
    const auto last = std::find_if(afterwards.rbegin(), afterwards.rend(), outside);
    if (last == afterwards.rbegin()) {
        return std::nullopt;
    }
    const Seconds since = last == afterwards.rend() ? afterwards.front().time : last.base()->time;
    return since - afterwards.front().time;
}

Angle meanError(Samples samples)
{
    Angle sum;
    for (const Sample& one : samples) {
        sum += one.actual - one.wanted;
    }
    return sum / static_cast<double>(samples.size());
}

}  // namespace

Result<StepFigures> stepFigures(Samples samples, Angle band)
{
    const std::size_t arrived = samples.empty() ? 0 : arrivalIn(samples);
    if (samples.size() < arrived + kFewestAfterwards) {
        return failure(ErrorCode::Refused, Text::tr("The recording after the step is too short."));
    }
    const Angle end = samples.back().wanted;
    const Angle size = end - samples.front().wanted;
    if (abs(size) <= band) {
        return failure(ErrorCode::Refused, Text::tr("The step is not larger than the settling band."));
    }
    const double way = size < Angle{} ? -1.0 : 1.0;
    Angle beyond;
    for (const Sample& one : samples) {
        beyond = std::max(beyond, way * (one.actual - end));
    }
    const Samples afterwards = samples.subspan(arrived);
    return StepFigures{.size = size,
                       .overshoot = beyond / abs(size),
                       .settling = settlingIn(afterwards, end, band),
                       .band = band,
                       .left = meanError(afterwards.last(afterwards.size() / 4)),
                       .error = errorFigures(samples),
                       .torque = torqueFigures(samples)};
}

}  // namespace boresight::response
