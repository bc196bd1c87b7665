// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/pointing/beam.h"

#include <algorithm>
#include <cmath>

namespace boresight::pointing {

namespace {

constexpr double kLightSpeed = 299'792'458.0;  // m/s
constexpr double kDishFactor = 70.0;           // degrees
constexpr double kGainTimesArea = 26'000.0;    // square degrees
constexpr double kLossAtWidth = 12.0;          // dB at an offset of one beam width; 3 dB at half of it

}  // namespace

Angle beamWidthOfDish(double diameter, double frequency)
{
    return std::min(Angle::fromDegrees(kDishFactor * kLightSpeed / frequency / diameter), Angle::fromDegrees(180.0));
}

Angle beamWidthOfGain(double gain)
{
    const double factor = std::pow(10.0, gain / 10.0);
    return std::min(Angle::fromDegrees(std::sqrt(kGainTimesArea / factor)), Angle::fromDegrees(180.0));
}

std::optional<double> pointingLoss(Angle off, Angle beamWidth)
{
    const double share = off / beamWidth;
    return std::abs(share) > 1.0 ? std::nullopt : std::optional(kLossAtWidth * share * share);
}

}  // namespace boresight::pointing
