// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"
#include "core/profile/profile.h"
#include "core/supervision/finding.h"
#include "core/units/sky.h"

#include <QString>

#include <optional>
#include <vector>

// Looks at one axis once per tick and says what is wrong with it, independently of the drive's own fault codes. Pure:
// time is passed in; mechanical angles, Nm, V, °C. Decides nothing: the station stops the mount, raises the alarm and
// asks for a re-arm. What is judged and how: README.md.
namespace boresight::supervision {

// One axis as seen in one tick.
struct AxisObservation
{
    SteadyTime now{};
    SteadyTime received{};  // when the last reply came
    bool fresh = false;     // a new reply since the last tick
    Angle actual;           // of the last reply
    bool engaged = false;   // set-points are sent
    Angle commanded;        // the set-point last sent; these two count only while engaged
    AngularRate commandedRate;
    double torque = 0.0;
    double voltage = 0.0;
    double boardTemperature = 0.0;
    std::optional<double> motorTemperature;  // empty without a sensor
    bool turnKnown = false;                  // else `actual` is right but for whole turns of the rotor
};

class AxisSupervisor
{
public:
    AxisSupervisor(Axis axis, const profile::AxisSettings& limits, const profile::SupervisionSettings& settings);

    // Once per tick, from the first reply on. Everything that is wrong now, at most one of each kind, worst first. A
    // text keeps the numbers of the moment when it began or became worse.
    [[nodiscard]] std::vector<Observed> observe(const AxisObservation& seen);

    // Call when the reported angle was changed on purpose (the turn was set), when the drive was power-cycled, and
    // with every re-arm: forgets what was commanded and measured before. Trends go on.
    void forgetMotion();
    // Of the profile, while the mount runs.
    void setSettings(const profile::AxisSettings& limits, const profile::SupervisionSettings& settings);

private:
    QString m_name;  // "the azimuth"
    profile::AxisSettings m_limits;
    profile::SupervisionSettings m_settings;
};

}  // namespace boresight::supervision
