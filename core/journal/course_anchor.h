// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/messages/turn_question.h"
#include "core/mount/sensor_course.h"

#include <optional>

// How far the azimuth has turned since its wrap was last known, whole turns included, measured by a sensor on the
// antenna that ran without interruption. The accuracy is that of a compass, some degrees. That is enough to distinguish
// wraps, but not places that are close together. The result adds evidence to the question about the wrap and may reject
// a proposal, but it never answers the question. Pure.
namespace boresight::journal {

// The last moment at which the wrap of the axis was known.
struct CourseAnchor
{
    Angle axis;
    SensorCourse course;
};

// The axis angle by the sensor. Empty if the sensor was interrupted since the anchor.
[[nodiscard]] std::optional<Angle> placeBySensor(const std::optional<CourseAnchor>& anchor,
                                                 const std::optional<SensorCourse>& now);

// Adds a sentence to the evidence, before the last sentence of the sensor. Withdraws a proposal that contradicts the
// sensor.
void addSensorTurning(TurnQuestion& question, Angle bySensor);

}  // namespace boresight::journal
