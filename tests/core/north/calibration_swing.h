// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/core/north/calibration_rig.h"

// The swing that the tests request, and the remaining error of north.
namespace boresight {

inline const request::StartSwing kSweep{.rate = 3_deg_s, .headings = 0};

// Error of the north that is in effect, in degrees.
inline double northError(const CalibrationRig& rig)
{
    return (rig.terms().azimuthOffset - rig.truth.terms.azimuthOffset).wrapped180().degrees();
}

// Brings the mount to the middle of a swing.
inline void swingHalfWay(CalibrationRig& rig)
{
    rig.goTo(200.0, 30.0);
    ASSERT_TRUE(rig.ask(kSweep));
    rig.run(Seconds(80.0));
    ASSERT_EQ(CalibrationRun::Swing, rig.status().progress.run);
    ASSERT_TRUE(rig.desk.moves());
    StationStatus status = rig.control.status();
    rig.desk.fill(status);
    EXPECT_EQ(StationState::Calibrate, status.state);
}

}  // namespace boresight
