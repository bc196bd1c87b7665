// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/station/motion.h"

namespace boresight {
namespace {

tracking::AxisProfile profileOf(const profile::AxisSettings& axis)
{
    return {axis.limits, axis.geometry.travel, axis.geometry.travel.clamped(Angle{})};
}

}  // namespace

Motion::Motion(const profile::Profile& profile)
    : m_azimuth(profileOf(profile.azimuth)), m_elevation(profileOf(profile.elevation))
{}

void Motion::start(Axis axis, Angle measured)
{
    (axis == Axis::Azimuth ? m_azimuth : m_elevation).reset(measured);
}

void Motion::rest()
{
    m_wanted = Resting{};
}

void Motion::goTo(const AxisPosition& place)
{
    m_wanted = place;
}

void Motion::follow(const AxisPosition& point, SteadyTime now)
{
    if (auto* const stream = std::get_if<tracking::TargetStream>(&m_wanted)) {
        stream->add(now, point);
        return;
    }
    m_wanted.emplace<tracking::TargetStream>().restart(now, point);
}

void Motion::confirmStream(SteadyTime now)
{
    if (auto* const stream = std::get_if<tracking::TargetStream>(&m_wanted)) {
        stream->confirm(now);
    }
}

void Motion::settleStream()
{
    if (const auto* const stream = std::get_if<tracking::TargetStream>(&m_wanted)) {
        if (const auto last = stream->lastPoint()) {
            goTo(*last);
        }
    }
}

void Motion::run(const AxisRates& rates)
{
    m_wanted = rates;
}

std::optional<tracking::MovingTarget> Motion::movingTarget(SteadyTime now) const
{
    if (const auto* const place = std::get_if<AxisPosition>(&m_wanted)) {
        return tracking::MovingTarget{.position = *place, .rates = {}, .streaming = false};
    }
    if (const auto* const stream = std::get_if<tracking::TargetStream>(&m_wanted)) {
        return stream->target(now);
    }
    return std::nullopt;
}

void Motion::advance(SteadyTime now, Seconds step)
{
    if (const auto target = movingTarget(now)) {
        m_azimuth.follow(step, target->position.azimuth, target->rates.azimuth);
        m_elevation.follow(step, target->position.elevation, target->rates.elevation);
    } else if (const auto* const rates = std::get_if<AxisRates>(&m_wanted)) {
        m_azimuth.run(step, rates->azimuth);
        m_elevation.run(step, rates->elevation);
    } else {
        brake(step);
    }
}

void Motion::brake(Seconds step)
{
    m_azimuth.brake(step);
    m_elevation.brake(step);
}

const tracking::Setpoint& Motion::setpoint(Axis axis) const
{
    return (axis == Axis::Azimuth ? m_azimuth : m_elevation).setpoint();
}

AxisPosition Motion::place() const
{
    return {.azimuth = m_azimuth.setpoint().position, .elevation = m_elevation.setpoint().position};
}

std::optional<AxisPosition> Motion::target(SteadyTime now) const
{
    const auto target = movingTarget(now);
    return target ? std::optional(target->position) : std::nullopt;
}

bool Motion::streaming(SteadyTime now) const
{
    const auto target = movingTarget(now);
    return target && target->streaming;
}

bool Motion::atRest() const
{
    return m_azimuth.atRest() && m_elevation.atRest();
}

}  // namespace boresight
