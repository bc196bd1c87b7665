// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/cross_check/sensor_check.h"
#include "core/cross_check/sensor_curve.h"
#include "core/orientation/orientation.h"

// Converts the sensor's values to true directions by one mounting and curve, and compares them with the axes. One
// object uses the mounting in force, another the proposed one. Pure.
namespace boresight {

// isTiedToNorth: the compass is related to magnetic north. isLevel: the elevation is related to the vertical.
[[nodiscard]] bool isTiedToNorth(const orientation::Calibration& calibration);
[[nodiscard]] bool isLevel(const orientation::Orientation& value);

class SensorComparison
{
public:
    explicit SensorComparison(const profile::SensorSettings& settings);

    // Sets the threshold and the time of a difference, from the next value on.
    void judgeBy(const profile::SensorSettings& settings);
    // Sets another mounting or curve. Earlier comparisons are forgotten.
    void convertBy(const SensorToSky& toSky);
    void forget() { m_check.forget(); }
    void leaveOut(Axis axis) { m_check.leaveOut(axis); }

    void take(const orientation::Orientation& value);
    // As in SensorCheck.
    void note(SteadyTime now, const std::optional<SkyPointing>& axes) { m_check.note(now, axes); }
    void tick(SteadyTime now) { m_check.tick(now); }

    // The azimuth at which the value was measured: that of the axes, because iron deflects that of the sensor. If the
    // position of the axes is unknown, it is that of the sensor.
    [[nodiscard]] Angle azimuthOf(const orientation::Orientation& value) const { return measuredAt(value).mean; }
    // False if the swing found iron that disturbs the compass where the value was measured.
    [[nodiscard]] bool isReliable(const orientation::Orientation& value) const;
    [[nodiscard]] const SensorToSky& toSky() const { return m_toSky; }
    [[nodiscard]] SkyPointing directionOf(const orientation::Orientation& value) const
    {
        return m_toSky.directionOf(value);
    }
    [[nodiscard]] const SensorCheck::Difference& difference(Axis axis) const { return m_check.difference(axis); }

private:
    [[nodiscard]] SensorCheck::Passed measuredAt(const orientation::Orientation& value) const;

    SensorToSky m_toSky;
    SensorCheck m_check;
};

}  // namespace boresight
