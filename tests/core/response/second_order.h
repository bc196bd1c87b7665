// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/response/samples.h"

#include <functional>
#include <vector>

// A second-order system with responses known from textbooks: a'' = w² (wanted - a) - 2 z w a'. Sampled 50 times a
// second.
namespace boresight::response {

inline std::vector<Sample> answerOf(double omega, double damping, double duration,
                                    const std::function<double(double)>& wantedDegrees, double before = 0.0)
{
    constexpr double kStep = 1e-5;
    constexpr int kStepsEach = 2000;  // 20 ms
    double place = 0.0;
    double rate = 0.0;
    std::vector<Sample> samples;
    const int steps = static_cast<int>(duration / kStep);
    for (int i = 0; i < steps; ++i) {
        const double time = i * kStep;
        const double wanted = time < before ? 0.0 : wantedDegrees(time - before);
        if (i % kStepsEach == 0) {
            samples.push_back({.time = Seconds(time),
                               .wanted = Angle::fromDegrees(wanted),
                               .actual = Angle::fromDegrees(place),
                               .torque = rate});
        }
        rate += (omega * omega * (wanted - place) - 2.0 * damping * omega * rate) * kStep;
        place += rate * kStep;
    }
    return samples;
}

}  // namespace boresight::response
