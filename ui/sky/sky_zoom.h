// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/units/sky.h"
#include "ui/sky/sky_projection.h"

#include <QRectF>

#include <vector>

// The magnified part of the polar plot: its magnification, its centre, and suitable grid lines. The view stands still
// while the followed direction stays in its inner half, so that not every status redraws the ground. Pure.
namespace boresight::ui {

class SkyZoom
{
public:
    [[nodiscard]] bool isOn() const { return m_magnification > 1.0; }
    [[nodiscard]] double magnification() const { return m_magnification; }
    [[nodiscard]] Angle halfView() const { return 90_deg / m_magnification; }  // from the middle to the edge

    void toggle(Angle beamWidth);           // switches between the whole sky and a few beam widths
    void step(int steps, Angle beamWidth);  // magnifies, or reduces if negative
    bool follow(const SkyPointing& place);  // returns true if the view has moved
    void centreOn(const SkyPointing& place);

    // `whole` is the projection of the whole sky into the same widget.
    [[nodiscard]] SkyProjection projection(const SkyProjection& whole) const;

private:
    double m_magnification = 1.0;
    SkyPointing m_centre{0_deg, 90_deg};
};

// Grid lines in degrees, fine enough for the magnification, for the part shown in `view`.
struct SkyGrid
{
    std::vector<double> azimuths;    // descending
    std::vector<double> elevations;  // descending
    int decimals = 0;                // of their labels

    bool operator==(const SkyGrid&) const = default;
};

[[nodiscard]] SkyGrid wholeSkyGrid();  // every 30°
[[nodiscard]] SkyGrid gridOf(const SkyProjection& sky, const QRectF& view);

}  // namespace boresight::ui
