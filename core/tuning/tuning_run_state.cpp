// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tuning/tuning_run_state.h"

#include "core/base/text.h"
#include "core/units/degrees_text.h"

#include <algorithm>
#include <utility>

namespace boresight {
namespace {

constexpr Angle kTuningArrived = Angle::fromDegrees(1e-4);
// Gains with a larger error are not tried any longer.
constexpr Angle kLargestError = Angle::fromDegrees(1.0);
constexpr Seconds kTuningPatience{10.0};  // a run may take this much longer than planned

}  // namespace

TuningRunState::TuningRunState(TuningRun run, Axis axis, TuningWay way, const AxisPosition& here, SteadyTime now)
    : m_run(run), m_axis(axis), m_way(std::move(way)), m_here(here), m_began(now), m_legBegan(now)
{
    for (const TuningLeg& one : m_way.legs) {
        m_parts.resize(std::max(m_parts.size(), one.part ? static_cast<std::size_t>(*one.part) + 1 : 0));
    }
}

std::optional<Request> TuningRunState::step(SteadyTime now, const AxisSample& sample)
{
    record(now, sample);
    if (!done() && isOver(now, sample)) {
        enter(m_leg + 1, now);
    }
    if (done() || (leg().place && m_asked)) {
        return std::nullopt;
    }
    m_asked = true;
    return motionOf(now, sample);
}

Request TuningRunState::motionOf(SteadyTime now, const AxisSample& sample) const
{
    const bool azimuth = m_axis == Axis::Azimuth;
    if (leg().place) {
        AxisPosition place = m_here;
        (azimuth ? place.azimuth : place.elevation) = *leg().place;
        return request::PointAxes{.position = place, .purpose = Text::tr("tuning run, to its start")};
    }
    const AngularRate rate = leg().rate(now - m_legBegan, sample.commanded.value_or(m_way.plan.from) - m_way.plan.from);
    return request::Trial{azimuth ? AxisRates{.azimuth = rate} : AxisRates{.elevation = rate}};
}

void TuningRunState::record(SteadyTime now, const AxisSample& sample)
{
    if (!sample.commanded || !sample.actual) {
        return;
    }
    m_error = *sample.actual - *sample.commanded;
    const response::Sample taken{
        .time = now - m_began, .wanted = *sample.commanded, .actual = *sample.actual, .torque = sample.torque};
    m_all.push_back(taken);
    if (!done() && leg().part && now - m_legBegan >= leg().record) {
        m_parts[static_cast<std::size_t>(*leg().part)].push_back(taken);
    }
}

bool TuningRunState::isOver(SteadyTime now, const AxisSample& sample)
{
    if (!leg().place) {
        return now - m_legBegan >= leg().time;
    }
    const bool there = m_asked && sample.commanded && abs(*sample.commanded - *leg().place) < kTuningArrived;
    m_arrived = there ? std::optional(m_arrived.value_or(now)) : std::nullopt;
    return m_arrived && now - *m_arrived >= leg().time;
}

void TuningRunState::enter(std::size_t leg, SteadyTime now)
{
    m_leg = leg;
    m_legBegan = now;
    m_arrived.reset();
    m_asked = false;
}

QString TuningRunState::obstacle(SteadyTime now) const
{
    if (abs(m_error) > kLargestError) {
        return Text::tr(
                   "The axis was %1 away from its set-point. Put the gains back. Check that nothing blocks the axis")
            .arg(degreesText(abs(m_error), 1));
    }
    if (now - m_began > m_way.plan.duration + kTuningPatience) {
        return Text::tr("The axis is not moving. Something is blocking it, or a limit holds it");
    }
    return {};
}

double TuningRunState::part(SteadyTime now) const
{
    return std::clamp((now - m_began) / m_way.plan.duration, 0.0, 1.0);
}

Seconds TuningRunState::left(SteadyTime now) const
{
    return std::max(m_way.plan.duration - Seconds(now - m_began), Seconds(0.0));
}

}  // namespace boresight
