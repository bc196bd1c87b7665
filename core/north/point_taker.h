// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/north/calibration_runs.h"
#include "core/north/kept_points.h"

// Takes points by hand: of the body that is centred in the beam, or of a landmark whose direction is known. Reports
// whether a point can be taken now. Station thread only.
namespace boresight {

class PointTaker
{
public:
    // All arguments must outlive this object.
    PointTaker(const StationControl& control, const CalibrationRuns& runs, const AxisObserver& axes,
               const ModelInForce& model, BodyFollower& follower, KeptPoints& points, EventLog& log);

    [[nodiscard]] Result<> mayTakeBody() const;
    Result<> takeBody();
    Result<> takeKnown(const SkyPointing& truth, const QString& label);

    [[nodiscard]] Result<> mayTake() const;

private:
    void warnOfFarPoint(const SkyPointing& truth);

    const StationControl& m_control;
    const CalibrationRuns& m_runs;
    const AxisObserver& m_axes;
    const ModelInForce& m_model;
    BodyFollower& m_follower;  // computes where the body is
    KeptPoints& m_points;
    EventLog& m_log;
};

}  // namespace boresight
