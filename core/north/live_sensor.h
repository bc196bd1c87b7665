// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"
#include "core/base/result.h"
#include "core/messages/sensor_status.h"
#include "core/profile/in_force.h"

#include <cstdint>
#include <optional>

// The present report of the orientation sensor, and whether a calibration can rely on it. Pure; station thread.
namespace boresight {

class LiveSensor
{
public:
    // Profile and clock must outlive it.
    LiveSensor(const profile::InForce& profile, const Clock& clock) : m_profile(profile), m_clock(clock) {}

    // The value, or null if it was already taken.
    const orientation::Orientation* take(const SensorStatus& sensor);

    // A value came within the time that the profile allows.
    [[nodiscard]] Result<> isHeard() const;
    // There is a sensor, its data arrive, and it does not report an uncalibrated compass.
    [[nodiscard]] Result<> isUsable() const;
    // isUsable(), and the sensor does not report that its heading has lost magnetic north. Then an average is possible.
    [[nodiscard]] Result<> isTiedToNorth() const;
    [[nodiscard]] Angle declination() const { return m_declination; }
    [[nodiscard]] std::uint64_t restarts() const { return m_restarts; }

private:
    const profile::InForce& m_profile;
    const Clock& m_clock;
    std::optional<orientation::Orientation> m_last;
    QString m_problem;  // of its port or broker
    Angle m_declination;
    std::uint64_t m_restarts = 0;
};

}  // namespace boresight
