// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/sources/keyhole_plan.h"

#include <QPromise>
#include <QThreadPool>

#include <algorithm>
#include <memory>

namespace boresight::sources {
namespace {

// The axes catch up with this part of their speed, and the jerk takes a part of their acceleration.
constexpr double kSpeedPart = 0.97;
constexpr double kAccelerationPart = 0.5;

tracking::MotionLimits reduced(tracking::MotionLimits limits)
{
    limits.speed = kSpeedPart * limits.speed;
    limits.acceleration = kAccelerationPart * limits.acceleration;
    return limits;
}

// A mount that can be planned for. The elevations of a client may be above 90°, those of this plan are not.
Result<plan::PlanMount> uprightMount(profile::Profile profile, const pointing::Antenna& antenna)
{
    profile.limits.elevation.max = std::min(profile.limits.elevation.max, 90_deg);
    return plan::planMount(profile, antenna).map([](plan::PlanMount mount) {
        mount.azimuth = reduced(mount.azimuth);
        mount.elevation = reduced(mount.elevation);
        return mount;
    });
}

}  // namespace

// The work owns its promise and its copies, so it can end safely after the plan was deleted.
KeyholePlan::KeyholePlan(const targets::TargetPath& path, const plan::PlanTask& task, const profile::Profile& profile,
                         const pointing::Antenna& antenna)
{
    Result<plan::PlanMount> mount = uprightMount(profile, antenna);
    if (!mount) {
        return;
    }
    const auto promise = std::make_shared<QPromise<plan::PassPlan>>();
    m_future = promise->future();
    QThreadPool::globalInstance()->start([promise, path = path, task, mount = std::move(*mount)]() mutable {
        promise->start();
        const auto directionAt = [&path](UtcTime utc) -> std::optional<SkyPointing> {
            const Result<SkyPointing> direction = path.at(utc);
            return direction ? std::optional(SkyPointing{direction->azimuth, std::max(direction->elevation, 0_deg)})
                             : std::nullopt;
        };
        promise->addResult(plan::planPass(directionAt, task, mount));
        promise->finish();
    });
}

bool KeyholePlan::hasArrived()
{
    if (!m_future.isValid() || !m_future.isFinished()) {
        return false;
    }
    const plan::PassPlan found = m_future.result();
    m_future = {};
    const auto direct = std::ranges::find_if(found.variants, [](const plan::PlanVariant& variant) {
        return variant.way == plan::PlanWay::Direct && variant.ramp;
    });
    if (direct == found.variants.end()) {
        return false;
    }
    m_variant = *direct;
    return true;
}

std::optional<AxisPosition> KeyholePlan::placeAt(UtcTime utc, const std::optional<AxisPosition>& last) const
{
    if (!m_variant || utc < m_variant->ramp->from || utc > m_variant->ramp->to) {
        return std::nullopt;
    }
    AxisPosition place = m_variant->placeAt(utc);
    place.azimuth = last ? place.azimuth.nearestTo(last->azimuth) : place.azimuth;
    return place;
}

}  // namespace boresight::sources
