// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"
#include "core/calibration/estimate.h"
#include "core/units/sky.h"

#include <cstddef>
#include <optional>
#include <span>

// The peak of a source from received power along two lines across it. Powers are in dB: a Gaussian beam is a parabola
// in dB, about its peak. What a source adds to the receiver's own noise is not: readings of a weak source (the Sun in a
// small dish) are turned into the source's part first, given the power beside it. Pure.
namespace boresight::calibration {

struct ScanReading
{
    // From the middle of the scan, on the sky; across: azimuth × cos(elevation). Of a source that moves, the middle has
    // to move with it: the Sun goes a degree in four minutes.
    Angle offset;
    double decibels = 0.0;
};

struct ScanLimits
{
    double depth = 6.0;  // dB below the best reading that still count: a real beam leaves the parabola further down
    double least = 0.5;  // dB that the peak stands above the lower end
    std::optional<double> background;  // dB, of the receiver beside the source
};

struct ScanPeak
{
    Estimate offset;
    double decibels = 0.0;  // at the peak
    Angle halfPowerWidth;   // of beam and source together
    double scatter = 0.0;   // dB rms about the parabola
    std::size_t used = 0;
};

// One line. Refused with the reason where there is no peak, or none inside.
[[nodiscard]] Result<ScanPeak> fitScan(std::span<const ScanReading> readings, const ScanLimits& limits = {});

struct CrossScan
{
    ScanPeak across;  // crossElevation
    ScanPeak elevation;
    AxisPosition peak;  // of the axes
    Angle sigma;        // on the sky, the larger of the two
};

// `middle`: where the axes stood at offset 0 of both lines; of a moving source, where they would for offset 0 at the
// time that the peak is to be told for.
[[nodiscard]] Result<CrossScan> fitCrossScan(const AxisPosition& middle, std::span<const ScanReading> across,
                                             std::span<const ScanReading> elevation, const ScanLimits& limits = {});

}  // namespace boresight::calibration
