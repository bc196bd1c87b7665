// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/response/samples.h"

#include <algorithm>
#include <cmath>

namespace boresight::response {

ErrorFigures errorFigures(Samples samples)
{
    double squares = 0.0;
    double peak = 0.0;
    for (const Sample& one : samples) {
        const double error = (one.actual - one.wanted).radians();
        squares += error * error;
        peak = std::max(peak, std::abs(error));
    }
    const double count = std::max(static_cast<double>(samples.size()), 1.0);
    return {.rms = Angle::fromRadians(std::sqrt(squares / count)), .peak = Angle::fromRadians(peak)};
}

std::optional<TorqueFigures> torqueFigures(Samples samples)
{
    double squares = 0.0;
    double peak = 0.0;
    double count = 0.0;
    for (const Sample& one : samples) {
        if (one.torque) {
            squares += *one.torque * *one.torque;
            peak = std::max(peak, std::abs(*one.torque));
            count += 1.0;
        }
    }
    return count > 0.0 ? std::optional(TorqueFigures{.rms = std::sqrt(squares / count), .peak = peak}) : std::nullopt;
}

}  // namespace boresight::response
