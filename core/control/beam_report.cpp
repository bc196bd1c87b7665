// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/control/beam_report.h"

#include <algorithm>
#include <cmath>

namespace boresight {
namespace {

constexpr Angle kPathStep = Angle::fromDegrees(2.0);

}  // namespace

void addBeam(StationStatus& status, const pointing::PointingModel& model)
{
    const auto add = [&](std::optional<Angle> AxisStatus::*axis, std::optional<Angle> BeamAngles::*beam) {
        const std::optional<Angle>& azimuth = status.azimuth.*axis;
        const std::optional<Angle>& elevation = status.elevation.*axis;
        if (model.isIdentity()) {
            status.azimuth.beam.*beam = azimuth;
            status.elevation.beam.*beam = elevation;
        } else if (azimuth && elevation) {
            const SkyPointing direction = model.toSky({*azimuth, *elevation});
            status.azimuth.beam.*beam = direction.azimuth;
            status.elevation.beam.*beam = direction.elevation;
        }
    };
    add(&AxisStatus::actual, &BeamAngles::actual);
    add(&AxisStatus::commanded, &BeamAngles::commanded);
    add(&AxisStatus::target, &BeamAngles::target);
}

std::vector<SkyPointing> beamPath(const pointing::MountModel& model, const std::vector<AxisPosition>& corners)
{
    std::vector<SkyPointing> path;
    for (std::size_t i = 1; i < corners.size(); ++i) {
        const AxisPosition& from = corners[i - 1];
        const AxisPosition& to = corners[i];
        const Angle longest = std::max(abs(to.azimuth - from.azimuth), abs(to.elevation - from.elevation));
        const int steps = std::max(1, static_cast<int>(std::ceil(longest / kPathStep)));
        for (int step = i == 1 ? 0 : 1; step <= steps; ++step) {
            const double part = static_cast<double>(step) / steps;
            path.push_back(model.toSky({.azimuth = from.azimuth + (to.azimuth - from.azimuth) * part,
                                        .elevation = from.elevation + (to.elevation - from.elevation) * part}));
        }
    }
    return path;
}

}  // namespace boresight
