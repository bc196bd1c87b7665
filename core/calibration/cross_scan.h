// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"
#include "core/calibration/estimate.h"
#include "core/units/sky.h"

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

// The peak of a source from received power along two lines across it. Powers are given in dB and fitted as powers: a
// Gaussian beam above a background of the receiver's noise and the sky. The Sun in a small dish is 1 to 3 dB above that
// background. Pure.
namespace boresight::calibration {

struct ScanReading
{
    // From the middle of the scan, on the sky. Across means azimuth × cos(elevation). For a moving source the middle
    // must move with the source: the Sun moves a degree in four minutes.
    Angle offset;
    double decibels = 0.0;
};

struct ScanPeak
{
    Estimate offset;
    double decibels = 0.0;             // at the peak
    std::optional<double> background;  // dB, beside the source; empty: the line did not reach the background
    Angle halfPowerWidth;              // of beam and source together
    double scatter = 0.0;              // dB rms about the curve
    std::size_t used = 0;
    std::vector<ScanReading> readings;  // all, sorted by offset
};

// Fits one line. Refused with the reason if the line has no peak, or its peak is outside.
[[nodiscard]] Result<ScanPeak> fitScan(std::span<const ScanReading> readings);

// The power of the fitted curve.
[[nodiscard]] double decibelsAt(const ScanPeak& peak, Angle offset);

struct CrossScan
{
    ScanPeak across;  // crossElevation
    ScanPeak elevation;
    AxisPosition peak;  // of the axes
    Angle sigma;        // on the sky, the larger of the two
};

// `middle`: the position of the axes at offset 0 of both lines. For a moving source: their position for offset 0 at the
// time for which the peak is wanted. `elevationAt`: where the line in elevation crosses the line across.
[[nodiscard]] Result<CrossScan> fitCrossScan(const AxisPosition& middle, std::span<const ScanReading> across,
                                             std::span<const ScanReading> elevation, Angle elevationAt = {});

}  // namespace boresight::calibration
