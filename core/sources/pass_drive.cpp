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

// The time at the end of the cable: there the target is farthest off.
std::optional<plan::PlanSpan> waitIn(const plan::PlanVariant& variant)
{
    const auto isOff = [](const plan::PlannedMoment& moment) { return moment.isHidden ? Angle{} : moment.error; };
    const Angle end = std::ranges::max_element(variant.moments, {}, isOff)->axes.azimuth;
    std::optional<plan::PlanSpan> span;
    for (const plan::PlannedMoment& moment : variant.moments) {
        if (abs(moment.axes.azimuth - end) < Angle::fromDegrees(0.001)) {
            span = plan::PlanSpan{.from = span ? span->from : moment.utc, .to = moment.utc};
        }
    }
    return span;
}

}  // namespace

// The work owns its promise and its copies, so it can end safely after this object was deleted.
void PassDrive::compute(const targets::TargetPath& path, const plan::PlanTask& task, const ControlParts& view)
{
    Result<plan::PlanMount> mount = presentMount(view);
    if (!mount) {
        *this = {};
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

bool PassDrive::hasArrived(const std::optional<plan::ChosenWay>& wanted)
{
    if (!m_future.isValid() || !m_future.isFinished()) {
        return false;
    }
    const plan::PassPlan found = m_future.result();
    m_future = {};
    if (found.variants.empty()) {
        *this = {};
        return false;
    }
    const std::size_t chosen = wanted ? plan::indexOf(found, *wanted).value_or(found.chosen) : found.chosen;
    m_variant = std::make_shared<const plan::PlanVariant>(found.variants[chosen]);
    m_driven = m_variant->way == plan::PlanWay::WaitsAtTheEnd ? waitIn(*m_variant) : m_variant->ramp;
    return true;
}

std::optional<AxisPosition> PassDrive::placeAt(UtcTime utc) const
{
    return m_driven && isWithin(*m_driven, utc) ? std::optional(m_variant->placeAt(utc)) : std::nullopt;
}

AxisPosition PassDrive::sideAt(UtcTime utc) const
{
    return m_variant->placeAt(unwrapsAt(utc) ? m_variant->unwrap->to : utc);
}

bool PassDrive::unwrapsAt(UtcTime utc) const
{
    return m_variant->unwrap && isWithin(*m_variant->unwrap, utc);
}

}  // namespace boresight::sources
