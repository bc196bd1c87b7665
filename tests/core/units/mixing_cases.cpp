// SPDX-License-Identifier: GPL-3.0-or-later
// CMakeLists.txt compiles this file once for each case. The compiler must refuse every case but NO_MISTAKE.
#include "core/units/quantity.h"
#include "core/units/sky.h"

using namespace boresight;

Angle cableAngle(const AxisPosition& axes)
{
    return axes.azimuth;
}

#if defined(NO_MISTAKE)
const Angle result = cableAngle({.azimuth = 10_deg, .elevation = 5_deg}) + (1.5_deg_s * Seconds(2.0));
#elif defined(ANGLE_FROM_DOUBLE)
const Angle result = 10.0;
#elif defined(ANGLE_PLUS_RATE)
const auto result = 10_deg + 1_deg_s;
#elif defined(MOTOR_TURNS_FROM_ANGLE)
const MotorTurns result = 10_deg;
#elif defined(SKY_AS_AXIS)
const SkyPointing sky{.azimuth = 10_deg, .elevation = 5_deg};
const Angle result = cableAngle(sky);
#elif defined(RATE_AS_ANGLE)
const AxisPosition result{.azimuth = 1_deg_s, .elevation = 5_deg};
#else
#error "no case named"
#endif
