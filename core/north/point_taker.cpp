// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/north/point_taker.h"

#include "core/base/text.h"
#include "core/units/angle_between.h"

#include <algorithm>

namespace boresight {
namespace {

using namespace boresight::literals;

const QString kTakerSource = QStringLiteral("calibration");
// How exactly a person centres the beam on a body by shadow or sight tube.
constexpr Angle kCentred = Angle::fromDegrees(0.03);
// After north was found, a centred target gets a warning if it is farther than this from its expected direction. If 3
// sigmas of north are larger, they are the limit.
constexpr Angle kFarPoint = Angle::fromDegrees(5.0);
// How exactly the direction of a landmark is known from a map, and the beam is pointed at it by hand.
constexpr Angle kKnownPoint = Angle::fromDegrees(0.1);

}  // namespace

PointTaker::PointTaker(const StationControl& control, const CalibrationRuns& runs, const AxisObserver& axes,
                       const ModelInForce& model, BodyFollower& follower, KeptPoints& points, EventLog& log)
    : m_control(control), m_runs(runs), m_axes(axes), m_model(model), m_follower(follower), m_points(points), m_log(log)
{}

Result<> PointTaker::mayTake() const
{
    return m_runs.isIdle()
        .and_then([this] { return m_control.usesMainAntenna(); })
        .and_then([this] { return m_axes.standStill(); })
        .and_then([this] { return m_points.hasRoom(); });
}

Result<> PointTaker::mayTakeBody() const
{
    if (!m_follower.body()) {
        return failure(ErrorCode::Refused, Text::tr("Track the Sun or the Moon first and centre it."));
    }
    return m_follower.direction(*m_follower.body()).and_then([&](const SkyPointing& place) -> Result<> {
        if (place.elevation < Angle{}) {
            return failure(ErrorCode::Refused,
                           Text::tr("The %1 is below the horizon.").arg(bodyName(*m_follower.body())));
        }
        return mayTake();
    });
}

// Uses where the axes are, not where they were commanded, and where the body is at the same time.
Result<> PointTaker::takeBody()
{
    return mayTakeBody().map([&] {
        const ephemeris::Body body = *m_follower.body();
        const SkyPointing truth = *m_follower.direction(body);
        m_points.add({.axes = m_axes.now()->place, .truth = truth, .sigma = kCentred, .label = bodyName(body)});
        warnOfFarPoint(truth);
    });
}

// The operator may see the shadow where the model does not expect it, so the point is taken with a warning.
void PointTaker::warnOfFarPoint(const SkyPointing& truth)
{
    const std::optional<Angle> north = m_model.sheet().sigmas[calibration::indexOf(calibration::Term::AzimuthOffset)];
    const auto beam = m_control.direction();
    if (!north || !beam) {
        return;
    }
    if (const Angle distance = angleBetween(*beam, truth); distance > std::max(kFarPoint, 3.0 * *north)) {
        m_log.add(Severity::Warning, kTakerSource,
                  Text::tr("By the model in force the beam is %1° away from the target. If the target was not centred, "
                           "drop point %2")
                      .arg(distance.degrees(), 0, 'f', 1)
                      .arg(m_points.book().points().size()));
    }
}

Result<> PointTaker::takeKnown(const SkyPointing& truth, const QString& label)
{
    if (!truth.azimuth.isFinite() || abs(truth.azimuth) > 360_deg || !(abs(truth.elevation) <= 90_deg)) {
        return failure(ErrorCode::OutOfRange,
                       Text::tr("The azimuth must be within 360° and the elevation within 90°."));
    }
    return mayTake().map([&] {
        const QString name = label.trimmed();
        m_points.add({.axes = m_axes.now()->place,
                      .truth = {truth.azimuth.wrapped360(), truth.elevation},
                      .sigma = kKnownPoint,
                      .label = name.isEmpty() ? Text::tr("landmark") : name});
    });
}

}  // namespace boresight
