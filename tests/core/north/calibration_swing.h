// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/core/north/calibration_rig.h"

// The swing that the tests ask of a rig, and how far from the hidden north they end.
namespace boresight {

inline const request::StartSwing kSweep{.rate = 3_deg_s, .headings = 0};

// Of what is in force, in degrees.
inline double northError(const CalibrationRig& rig)
{
    return (rig.terms().azimuthOffset - rig.truth.terms.azimuthOffset).wrapped180().degrees();
}

// A mount in the middle of its swing.
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
