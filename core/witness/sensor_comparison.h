// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/orientation/orientation.h"
#include "core/witness/sensor_check.h"
#include "core/witness/sensor_curve.h"

// The sensor by one mounting and curve, compared with the axes: how its values become true directions, and whether
// these differ. There is one of what is in force, and one of what is proposed. Pure.
namespace boresight {

// Its compass is tied to magnetic north, its elevation to the vertical.
[[nodiscard]] bool isTiedToNorth(const orientation::Calibration& calibration);
[[nodiscard]] bool isLevel(const orientation::Orientation& value);

class SensorComparison
{
public:
    explicit SensorComparison(const profile::SensorSettings& settings);

    // How far apart and for how long, from the next value on.
    void judgeBy(const profile::SensorSettings& settings);
    // Another mounting or curve. What was compared before is forgotten.
    void convertBy(const SensorToSky& toSky);
    void forget() { m_check.forget(); }
    void leaveOut(Axis axis) { m_check.leaveOut(axis); }

    void take(const orientation::Orientation& value);
    // As those of SensorCheck.
    void note(SteadyTime now, const std::optional<SkyPointing>& axes) { m_check.note(now, axes); }
    void tick(SteadyTime now) { m_check.tick(now); }

    [[nodiscard]] const SensorToSky& toSky() const { return m_toSky; }
    [[nodiscard]] SkyPointing directionOf(const orientation::Orientation& value) const
    {
        return m_toSky.directionOf(value);
    }
    [[nodiscard]] const SensorCheck::Difference& difference(Axis axis) const { return m_check.difference(axis); }

private:
    SensorToSky m_toSky;
    SensorCheck m_check;
};

}  // namespace boresight
