// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/messages/turn_question.h"
#include "core/mount/sensor_course.h"

#include <optional>

// What a sensor on the antenna that has run through saw of the azimuth's turning: how far the axis has turned since its
// turn was known, whole turns included. It is as good as a compass, some degrees, and so tells one turn from another,
// but no places that are near each other. It speaks in the question of the turn and against a wrong proposal; it never
// answers. Pure.
namespace boresight::memory {

// The last moment at which the turn of the axis was known.
struct CourseAnchor
{
    Angle axis;
    SensorCourse course;
};

// Where the axis is by the sensor; nothing if it could not be followed since.
[[nodiscard]] std::optional<Angle> placeBySensor(const std::optional<CourseAnchor>& anchor,
                                                 const std::optional<SensorCourse>& now);

// Adds a sentence to the evidence, before the sensor's own last one, and takes a proposal back that the sensor speaks
// against.
void addSensorTurning(TurnQuestion& question, Angle bySensor);

}  // namespace boresight::memory
