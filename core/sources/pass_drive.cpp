// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/sources/pass_drive.h"

#include <QPromise>
#include <QThreadPool>

#include <algorithm>
#include <memory>
#include <utility>

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

// The mount as it is now: with the keep-outs of the Sun, and no faster than the rotator is.
Result<plan::PlanMount> presentMount(const ControlParts& view)
{
    return plan::planMount(view.profile, view.antenna.inUse()).map([&](plan::PlanMount mount) {
        mount.region = view.motion.region();
        mount.pointing = view.model.pointing();
        mount.azimuth = reduced(view.motion.limits(Axis::Azimuth));
        mount.elevation = reduced(view.motion.limits(Axis::Elevation));
        return mount;
    });
}

bool isWithin(const plan::PlanSpan& span, UtcTime utc)
{
    return span.from <= utc && utc <= span.to;
}

// The variant to drive. Null: the orbit has no answer.
PlanFound chosenOf(plan::PassPlan plan, const std::optional<plan::ChosenWay>& wanted)
{
    if (plan.variants.empty()) {
        return {};
    }
    const auto asWanted = wanted ? plan::indexOf(plan, *wanted) : std::nullopt;
    return {
        .variant = std::make_shared<const plan::PlanVariant>(std::move(plan.variants[asWanted.value_or(plan.chosen)])),
        .isAsWanted = asWanted || !wanted};
}

}  // namespace

// The work owns its promise and its copies, so it can end safely after this object was deleted.
void PassDrive::compute(const targets::TargetPath& path, const plan::PlanTask& task,
                        const std::optional<plan::ChosenWay>& wanted, const ControlParts& view)
{
    m_future.cancel();
    Result<plan::PlanMount> mount = presentMount(view);
    if (!mount) {
        *this = {};
        return;
    }
    const auto promise = std::make_shared<QPromise<PlanFound>>();
    m_future = promise->future();
    QThreadPool::globalInstance()->start([promise, path = path, task, wanted, mount = std::move(*mount)]() mutable {
        promise->start();
        const auto directionAt = [&path](UtcTime utc) -> std::optional<SkyPointing> {
            const Result<SkyPointing> direction = path.at(utc);
            return direction ? std::optional(SkyPointing{direction->azimuth, std::max(direction->elevation, 0_deg)})
                             : std::nullopt;
        };
        if (!promise->isCanceled()) {
            promise->addResult(chosenOf(plan::planPass(directionAt, task, mount), wanted));
        }
        promise->finish();
    });
}

std::optional<bool> PassDrive::hasArrived()
{
    if (!m_future.isValid() || !m_future.isFinished()) {
        return std::nullopt;
    }
    PlanFound found = m_future.takeResult();
    m_variant = std::move(found.variant);
    return found.isAsWanted;
}

std::optional<AxisPosition> PassDrive::placeAt(UtcTime utc) const
{
    const bool waits = m_variant->way == plan::PlanWay::WaitsAtTheEnd;
    const bool isInRamp = m_variant->ramp && isWithin(*m_variant->ramp, utc);
    return waits || isInRamp ? std::optional(m_variant->placeAt(utc)) : std::nullopt;
}

AxisPosition PassDrive::sideAt(UtcTime utc) const
{
    AxisPosition side = m_variant->placeAt(utc);
    side.azimuth = unwrapsAt(utc) ? m_variant->unwrapsTo : side.azimuth;
    return side;
}

bool PassDrive::unwrapsAt(UtcTime utc) const
{
    return m_variant->unwrap && isWithin(*m_variant->unwrap, utc);
}

}  // namespace boresight::sources
