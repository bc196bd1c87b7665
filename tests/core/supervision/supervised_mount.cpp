// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/core/supervision/supervised_mount.h"

#include "core/moteus/faults.h"
#include "core/moteus_mount/drive_alarms.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace boresight::supervision {
namespace {

SteadyTime steady(Seconds time)
{
    return SteadyTime(std::chrono::hours(1)) + std::chrono::duration_cast<SteadyTime::duration>(time);
}

PlaceBelief::Limits placesOf(const profile::AxisSettings& axis, const profile::Profile& profile)
{
    const Angle allowance = profile.supervision.encoderJump;
    return {.allowance = abs(axis.geometry.toMotor(allowance) - axis.geometry.toMotor(Angle{})),
            .speed = abs(axis.geometry.toMotor(axis.limits.speed))};
}

}  // namespace

SupervisedMount::SupervisedMount(const sim::PairSettings& pair, const profile::Profile& profile)
    : m_profile(profile),
      m_pair(pair),
      m_sides{Side{.axis = Axis::Azimuth,
                   .settings = m_profile.azimuth,
                   .setpoints{m_profile.azimuth.limits, m_profile.azimuth.geometry.travel, Angle{}},
                   .supervisor{Axis::Azimuth, m_inForce},
                   .belief = PlaceBelief(placesOf(m_profile.azimuth, m_profile))},
              Side{.axis = Axis::Elevation,
                   .settings = m_profile.elevation,
                   .setpoints{m_profile.elevation.limits, m_profile.elevation.geometry.travel, Angle{}},
                   .supervisor{Axis::Elevation, m_inForce},
                   .belief = PlaceBelief(placesOf(m_profile.elevation, m_profile))}}
{
    run(Seconds(0.2));
}

void SupervisedMount::run(Seconds time)
{
    for (long i = std::lround(time / kTick); i > 0; --i) {
        tick();
    }
}

void SupervisedMount::engage()
{
    for (Side& side : m_sides) {
        side.setpoints.reset(side.seen.actual);
        side.target.reset();
        side.rate = {};
        side.seen.engaged = true;
    }
    run(Seconds(0.2));
}

void SupervisedMount::release()
{
    for (Side& side : m_sides) {
        side.seen.engaged = false;
        send(side.axis, moteus::Stop{});
    }
}

void SupervisedMount::goTo(Axis axis, Angle target)
{
    side(axis).target = target;
}

void SupervisedMount::turn(Axis axis, AngularRate rate)
{
    side(axis).target.reset();
    side(axis).rate = rate;
}

void SupervisedMount::send(Axis axis, const moteus::Command& command)
{
    exchange(axis, command);
}

sim::FaultSchedule::Handle SupervisedMount::inject(sim::FaultKind kind, Axis axis, std::optional<double> value,
                                                   Seconds duration)
{
    return m_pair.faults().add({.kind = kind, .axis = axis, .at = m_now, .duration = duration, .value = value});
}

std::optional<Found> SupervisedMount::first(Symptom symptom, Weight weight) const
{
    const auto it = std::ranges::find_if(m_found, [&](const Found& found) {
        return found.observed.symptom == symptom && found.observed.weight == weight;
    });
    return it != m_found.end() ? std::optional(*it) : std::nullopt;
}

bool SupervisedMount::stopped() const
{
    return std::ranges::any_of(m_found, [](const Found& found) { return found.observed.weight == Weight::Stop; });
}

std::string SupervisedMount::report() const
{
    std::string text;
    for (const Found& found : m_found) {
        text += std::to_string(found.at.count()) + " s " + (found.observed.weight == Weight::Stop ? "STOP " : "hint ") +
                found.observed.what.toStdString() + "\n";
    }
    return text;
}

void SupervisedMount::tick()
{
    m_now += kTick;
    m_pair.advanceTo(m_now);
    takeReplies();
    for (Side& side : m_sides) {
        judge(side);
        command(side);
    }
    if (onTick) {
        onTick();
    }
}

void SupervisedMount::takeReplies()
{
    for (Side& side : m_sides) {
        side.seen.fresh = false;
        side.seen.placed = false;
        side.seen.jumped.reset();
    }
    std::erase_if(m_replies, [this](const sim::PairReply& reply) {
        if (reply.due > m_now) {
            return false;
        }
        if (const auto decoded = moteus::decodeReply(reply.frame); decoded && !reply.damaged) {
            take(*decoded, reply.due);
        }
        return true;
    });
}

void SupervisedMount::take(const moteus::Reply& reply, Seconds received)
{
    using moteus::Register;
    Side& from = side(reply.source == m_profile.azimuth.id ? Axis::Azimuth : Axis::Elevation);
    const auto turns = reply.value(Register::Position);
    if (!turns) {
        return;
    }
    AxisObservation& seen = from.seen;
    seen.fresh = true;
    seen.received = steady(received);
    from.belief.take({.asked = from.asked, .received = seen.received, .place = MotorTurns::fromTurns(*turns)});
    const auto toAxis = [&](MotorTurns place) { return from.settings.geometry.toAxis(place); };
    if (from.belief.believedLast()) {
        seen.placed = true;
        seen.actual = toAxis(from.belief.place()->position);
    }
    if (const auto leap = from.belief.takeJump()) {
        seen.jumped =
            AngleLeap{.by = toAxis(leap->to) - toAxis(leap->from), .to = toAxis(leap->to), .within = leap->within};
    }
    EXPECT_FALSE(from.belief.takeFalsePlace()) << "nothing here is false";
    seen.torque = reply.value(Register::Torque);
    seen.voltage = reply.value(Register::Voltage);
    seen.boardTemperature = reply.value(Register::Temperature);
    const int code = reply.fault().value_or(0);
    seen.limit = moteus::isLimit(code) ? drive_alarms::limitClause(code) : QString();
    seen.turnKnown = reply.homeState() == moteus::HomeState::Output;
}

void SupervisedMount::judge(Side& side)
{
    if (side.seen.received == SteadyTime{}) {
        return;  // no reply yet
    }
    side.seen.now = steady(m_now);
    for (const Observed& observed : side.supervisor.observe(side.seen)) {
        const bool known = std::ranges::any_of(m_found, [&](const Found& found) {
            return found.axis == side.axis && found.observed.symptom == observed.symptom &&
                   found.observed.weight == observed.weight;
        });
        if (!known) {
            m_found.push_back({.at = m_now, .axis = side.axis, .observed = observed});
        }
    }
}

void SupervisedMount::command(Side& side)
{
    if (!side.seen.engaged) {
        exchange(side.axis, std::nullopt);
        return;
    }
    const tracking::Setpoint next =
        side.target ? side.setpoints.follow(kTick, *side.target) : side.setpoints.run(kTick, side.rate);
    side.seen.commanded = next.position;
    side.seen.commandedRate = next.rate;
    const auto& [geometry, limits] = std::tie(side.settings.geometry, side.settings.limits);
    exchange(side.axis, moteus::PositionCommand{
                            .position = geometry.toMotor(next.position).turns(),
                            .velocity = geometry.toMotor(next.rate).turns(),
                            .maximumTorque = side.settings.maxTorque,
                            .watchdogTimeout = m_profile.control.watchdog.count(),
                            .velocityLimit = std::abs(geometry.toMotor(1.5 * limits.speed).turns()),
                            .accelerationLimit = std::abs(geometry.toMotor(3.0 * limits.acceleration).turns())});
}

void SupervisedMount::exchange(Axis axis, const std::optional<moteus::Command>& command)
{
    side(axis).asked = steady(m_now);
    const auto frame = moteus::encode({.destination = static_cast<std::uint8_t>(side(axis).settings.id),
                                       .command = command,
                                       .query = moteus::rotatorQuery()});
    for (const sim::PairReply& reply : m_pair.exchange(*frame, m_now)) {
        m_replies.push_back(reply);
    }
}

}  // namespace boresight::supervision
