// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/response/ramp_response.h"

#include "core/base/text.h"

#include <algorithm>

namespace boresight::response {
namespace {

constexpr Seconds kShortest{1.0};
// After the rate became constant, the axis still settles. This time belongs to `error`, not to `steady`.
constexpr Seconds kSwingsIn{0.3};
constexpr double kSameRate = 0.01;  // share of the fastest rate

AngularRate rateAt(Samples samples, std::size_t i)
{
    return (samples[i].wanted - samples[i - 1].wanted) / (samples[i].time - samples[i - 1].time);
}

AngularRate fastestOf(Samples samples)
{
    AngularRate fastest;
    for (std::size_t i = 1; i < samples.size(); ++i) {
        const AngularRate rate = rateAt(samples, i);
        fastest = abs(rate) > abs(fastest) ? rate : fastest;
    }
    return fastest;
}

// The longest part of the samples at this rate.
Samples constantPart(Samples samples, AngularRate rate)
{
    std::size_t best = 0;
    std::size_t length = 0;
    std::size_t begun = 1;
    for (std::size_t i = 1; i < samples.size(); ++i) {
        if (abs(rateAt(samples, i) - rate) > abs(rate) * kSameRate) {
            begun = i + 1;
        } else if (i + 1 - begun > length) {
            best = begun;
            length = i + 1 - begun;
        }
    }
    return samples.subspan(best, length);
}

}  // namespace

Result<RampFigures> rampFigures(Samples samples)
{
    const AngularRate rate = fastestOf(samples);
    Samples steady = constantPart(samples, rate);
    const Seconds begun = steady.empty() ? Seconds(0.0) : steady.front().time;
    while (!steady.empty() && steady.front().time - begun < kSwingsIn) {
        steady = steady.subspan(1);
    }
    if (rate == AngularRate{} || steady.empty() || steady.back().time - steady.front().time < kShortest) {
        return failure(ErrorCode::Refused, Text::tr("The axis did not move at a constant rate for 1 s."));
    }
    Angle behind;
    for (const Sample& one : steady) {
        behind += one.wanted - one.actual;
    }
    const double way = rate < AngularRate{} ? -1.0 : 1.0;
    return RampFigures{.rate = rate,
                       .lag = way * behind / static_cast<double>(steady.size()),
                       .steady = errorFigures(steady),
                       .error = errorFigures(samples),
                       .torque = torqueFigures(steady)};
}

}  // namespace boresight::response
