// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"
#include "core/calibration/estimate.h"
#include "core/units/sky.h"

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

// The peak of a source from received power along two lines across it. Powers are told in dB and fitted as powers: a
// background, the receiver's own noise and the sky, and on top of it a Gaussian beam. The Sun in a small dish adds a
// decibel or three to that background. Pure.
namespace boresight::calibration {

struct ScanReading
{
    // From the middle of the scan, on the sky; across: azimuth × cos(elevation). Of a source that moves, the middle has
    // to move with it: the Sun goes a degree in four minutes.
    Angle offset;
    double decibels = 0.0;
};

struct ScanPeak
{
    Estimate offset;
    double decibels = 0.0;             // at the peak
    std::optional<double> background;  // dB, beside the source; empty: the line did not get down to it
    Angle halfPowerWidth;              // of beam and source together
    double scatter = 0.0;              // dB rms about the curve
    std::size_t used = 0;
    std::vector<ScanReading> readings;  // all, in the order of their offsets
};

// One line. Refused with the reason where there is no peak, or none inside.
[[nodiscard]] Result<ScanPeak> fitScan(std::span<const ScanReading> readings);

// Of the curve that was fitted.
[[nodiscard]] double decibelsAt(const ScanPeak& peak, Angle offset);

struct CrossScan
{
    ScanPeak across;  // crossElevation
    ScanPeak elevation;
    AxisPosition peak;  // of the axes
    Angle sigma;        // on the sky, the larger of the two
};

// `middle`: where the axes stood at offset 0 of both lines; of a moving source, where they would for offset 0 at the
// time that the peak is to be told for. `elevationAt`: where on the line across the one in elevation was run.
[[nodiscard]] Result<CrossScan> fitCrossScan(const AxisPosition& middle, std::span<const ScanReading> across,
                                             std::span<const ScanReading> elevation, Angle elevationAt = {});

}  // namespace boresight::calibration
