// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/north/axis_observer.h"
#include "core/north/body_follower.h"
#include "core/north/model_in_force.h"

// Raises and clears the lasting alarms of the calibration: the model in force is of another mount, the history cannot
// be saved, the beam is at the Sun. Station thread only.
namespace boresight {

class CalibrationAlarms
{
public:
    // All arguments must outlive this object.
    CalibrationAlarms(StationControl& control, const profile::InForce& profile, const CalibrationFile& file,
                      const ModelInForce& model, const AxisObserver& axes, BodyFollower& follower)
        : m_control(control), m_profile(profile), m_file(file), m_model(model), m_axes(axes), m_follower(follower)
    {}

    // Call it several times a second.
    void update();
    [[nodiscard]] bool isAtSun() const;

private:
    void warnOfOtherMount();
    void warnOfFile();
    void warnOfSun();
    [[nodiscard]] bool beamAtSun();

    StationControl& m_control;
    const profile::InForce& m_profile;
    const CalibrationFile& m_file;
    const ModelInForce& m_model;
    const AxisObserver& m_axes;
    BodyFollower& m_follower;  // computes where the Sun is
};

}  // namespace boresight
