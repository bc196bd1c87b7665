// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/north/calibration_permission.h"

#include "ui/kit/axes.h"
#include "ui/kit/format.h"
#include "ui/link/motion_permission.h"
#include "ui/north/calibration_words.h"

#include <QCoreApplication>

#include <algorithm>

namespace boresight::ui {

namespace {

class CalibrationPermission
{
    Q_DECLARE_TR_FUNCTIONS(CalibrationPermission)
};

QString whyNoOther(const StationStatus& status)
{
    return calibrationOf(status).progress.run == CalibrationRun::None
               ? QString()
               : CalibrationPermission::tr("a calibration is running: end it first");
}

QString firstOf(const QString& one, const QString& other)
{
    return one.isEmpty() ? other : one;
}

}  // namespace

const BodyNow* bodyNow(const StationStatus& status, ephemeris::Body body)
{
    const auto& bodies = calibrationOf(status).bodies;
    const auto found = std::ranges::find(bodies, body, &BodyNow::body);
    return found == bodies.end() ? nullptr : &*found;
}

QString whyNoSensorAverage(const StationStatus& status)
{
    return firstOf(whyNoOther(status), calibrationOf(status).sensorObstacle);
}

QString whyNoSwing(const StationStatus& status)
{
    return firstOf(firstOf(whyNoOther(status), whyNoPointing(status)), calibrationOf(status).swingPlan.obstacle);
}

QString whyNoBody(const StationStatus& status, ephemeris::Body body, bool overTheTop)
{
    const QString reason = firstOf(firstOf(whyNoOther(status), whyNoPointing(status)), calibrationOf(status).noSite);
    const BodyNow* const now = bodyNow(status, body);
    if (!reason.isEmpty()) {
        return reason;
    }
    if (now == nullptr) {
        return CalibrationPermission::tr("it is not known where the %1 is").arg(bodyName(body));
    }
    return overTheTop ? now->obstacleOverTheTop : now->obstacle;
}

QString whyNoScan(const StationStatus& status, ephemeris::Body body)
{
    const CalibrationStatus& calibration = calibrationOf(status);
    const QString reason = whyNoBody(status, body, calibration.overTheTop);
    return !reason.isEmpty() || (calibration.following && calibration.body == body)
               ? reason
               : CalibrationPermission::tr("follow the %1 first").arg(bodyName(body));
}

QString whyNoPower(const StationStatus& status)
{
    return calibrationOf(status).wantsPower ? QString() : CalibrationPermission::tr("no scan waits for a power now");
}

QString whyNoBodyPoint(const StationStatus& status, ephemeris::Body body)
{
    const CalibrationStatus& calibration = calibrationOf(status);
    return calibration.body == body ? firstOf(whyNoOther(status), calibration.pointObstacle)
                                    : CalibrationPermission::tr("follow the %1 first").arg(bodyName(body));
}

QString whyNoLandmark(const StationStatus& status)
{
    if (const QString reason = whyNoOther(status); !reason.isEmpty()) {
        return reason;
    }
    for (const Axis axis : kAxes) {
        if (const QString reason = whyNoPlace(status, axis); !reason.isEmpty()) {
            return reason;
        }
    }
    return {};
}

QString whyNoPointChange(const StationStatus& status)
{
    return calibrationOf(status).points.empty() ? CalibrationPermission::tr("there are no points") : whyNoOther(status);
}

QString whyNoGivenTerms(const StationStatus& status)
{
    return status.calibration ? whyNoOther(status) : CalibrationPermission::tr("the station does not calibrate");
}

QString whyNoApply(const StationStatus& status)
{
    const auto& proposal = calibrationOf(status).proposal;
    return proposal ? proposal->obstacle : CalibrationPermission::tr("nothing is proposed yet");
}

QString whyNoDiscard(const StationStatus& status)
{
    return calibrationOf(status).proposal ? QString() : CalibrationPermission::tr("nothing is proposed yet");
}

QString whyNoUndo(const StationStatus& status)
{
    return calibrationOf(status).canUndo ? whyNoOther(status)
                                         : CalibrationPermission::tr("nothing applied here can be taken back");
}

QString whyNoRedo(const StationStatus& status)
{
    return calibrationOf(status).canRedo ? whyNoOther(status) : CalibrationPermission::tr("nothing was taken back");
}

}  // namespace boresight::ui
