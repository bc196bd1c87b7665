// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"
#include "core/budget/servo_record.h"
#include "core/tracking/stream_error.h"
#include "core/units/quantity.h"

#include <optional>
#include <vector>

// All that is known about the pointing error at one moment. Plain values. An unknown value is empty.
namespace boresight::budget {

// Who computes the direction of the target.
enum class TargetOrigin
{
    Fixed,     // a direction that stands still
    Own,       // Boresight, in each tick, by its clock
    Client,    // a client, which sends points
    Reported,  // another program, which reports where something is
};

struct ClockFacts
{
    bool isSynchronised = true;
    std::optional<Seconds> error;  // as reported by the time source
    std::optional<Seconds> ahead;  // the clock was set by this, and the mount is pointed by the old time
};

// The elements of the tracked satellite.
struct ElementFacts
{
    Seconds age{};            // since their epoch
    double kilometres = 0.0;  // the expected error along the orbit
    Seconds time{};           // in which the satellite moves this far
};

// A calibration point, compared with the pointing model in force.
struct PointFacts
{
    Angle residual;  // on the sky
    Angle sigma;     // of the centring
};

struct CalibrationFacts
{
    std::vector<PointFacts> points;  // those in use
    std::optional<Angle> stated;     // of the terms in force, on the sky in the present direction
};

struct WindFacts
{
    bool isRead = false;          // the profile names an anemometer
    std::optional<double> speed;  // m/s; empty: there is no reading, or it is old
};

struct BudgetFacts
{
    Angle beamWidth;
    std::optional<ServoRecord::Summary> servo;
    Angle resolution;  // of the rotator, one sigma on the sky; 0: finer than what is measured
    Angle toTarget;    // from the set-points to the target, on the sky
    TargetOrigin origin = TargetOrigin::Fixed;
    std::optional<tracking::StreamError> stream;  // of the points
    std::optional<AngularRate> skyRate;           // of an own target; empty: its direction depends on no clock
    ClockFacts clock;
    bool isSatellite = false;  // the target is computed from elements
    std::optional<ElementFacts> elements;
    CalibrationFacts calibration;
    WindFacts wind;
};

}  // namespace boresight::budget
