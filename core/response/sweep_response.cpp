// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/response/sweep_response.h"

#include "core/base/text.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <numbers>
#include <utility>

namespace boresight::response {
namespace {

constexpr double kFewestPeriods = 1.5;
// A smaller swing is lost in the steps of an encoder.
constexpr Angle kSmallestSwing = Angle::fromDegrees(0.005);
constexpr std::size_t kUnknowns = 4;  // cosine, sine, place, drift

using Row = std::array<double, kUnknowns + 1>;  // of the normal equations; the last element is the right side

void eliminate(std::array<Row, kUnknowns>& rows)
{
    for (std::size_t pivot = 0; pivot < kUnknowns; ++pivot) {
        const auto largest = std::max_element(
            rows.begin() + static_cast<std::ptrdiff_t>(pivot), rows.end(),
            [pivot](const Row& one, const Row& other) { return std::abs(one[pivot]) < std::abs(other[pivot]); });
        std::iter_swap(rows.begin() + static_cast<std::ptrdiff_t>(pivot), largest);
        for (std::size_t row = 0; row < kUnknowns; ++row) {
            const double factor = row == pivot ? 0.0 : rows[row][pivot] / rows[pivot][pivot];
            for (std::size_t column = pivot; column <= kUnknowns; ++column) {
                rows[row][column] -= factor * rows[pivot][column];
            }
        }
    }
}

// The size and phase of the wave in the values that `place` returns for the samples.
template <class Place>
std::complex<double> waveIn(Samples samples, double omega, Place place)
{
    std::array<Row, kUnknowns> rows{};
    const Seconds middle = 0.5 * (samples.front().time + samples.back().time);
    const double origin = place(samples.front()).radians();
    for (const Sample& one : samples) {
        const double time = (one.time - middle).count();
        const std::array<double, kUnknowns> terms{std::cos(omega * time), std::sin(omega * time), 1.0, time};
        for (std::size_t row = 0; row < kUnknowns; ++row) {
            for (std::size_t column = 0; column < kUnknowns; ++column) {
                rows[row][column] += terms[row] * terms[column];
            }
            rows[row][kUnknowns] += terms[row] * (place(one).radians() - origin);
        }
    }
    eliminate(rows);
    return {rows[0][kUnknowns] / rows[0][0], -rows[1][kUnknowns] / rows[1][1]};
}

}  // namespace

Result<SweepPoint> sweepPoint(Samples samples, double hertz)
{
    const bool longEnough = samples.size() > 2 * kUnknowns &&
                            (samples.back().time - samples.front().time).count() * hertz >= kFewestPeriods;
    if (!longEnough) {
        return failure(ErrorCode::Refused, Text::tr("The swing of the axis was too short."));
    }
    const double omega = 2.0 * std::numbers::pi * hertz;
    const auto wanted = waveIn(samples, omega, [](const Sample& one) { return one.wanted; });
    const auto actual = waveIn(samples, omega, [](const Sample& one) { return one.actual; });
    if (!(std::abs(wanted) >= kSmallestSwing.radians())) {
        return failure(ErrorCode::Refused, Text::tr("The set-point hardly moved."));
    }
    const std::complex<double> ratio = actual / wanted;
    return SweepPoint{.hertz = hertz,
                      .amplitude = Angle::fromRadians(std::abs(wanted)),
                      .gain = std::abs(ratio),
                      .phase = Angle::fromRadians(std::arg(ratio))};
}

}  // namespace boresight::response
