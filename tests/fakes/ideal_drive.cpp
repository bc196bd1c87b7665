// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/fakes/ideal_drive.h"

#include <algorithm>
#include <cmath>
#include <span>

namespace boresight::fakes {
namespace {

constexpr Seconds kWatchdog{0.1};
constexpr double kCountsInReports = 65536.0;

}  // namespace

std::optional<double> Written::find(moteus::Register reg) const
{
    // If a register was written twice, the last value counts.
    for (std::size_t i = m_count; i > 0; --i) {
        if (m_values[i - 1].first == reg) {
            return m_values[i - 1].second;
        }
    }
    return std::nullopt;
}

std::optional<CanFrame> IdealDrive::answer(const CanFrame& frame, SteadyTime now)
{
    const moteus::Arbitration to = moteus::fromCanId(frame.id);
    if (to.destination != m_id || silent) {
        return std::nullopt;
    }
    advanceTo(now);
    const Written fields = written(frame);
    if (fields.contains(moteus::Register::Mode)) {
        m_echo = fields.find(moteus::Register::StayWithinLower).value_or(moteus::kUnset);
    }
    CanFrame reply = stateFrame(now);
    if (!falsePlaces.empty()) {
        falsePlaces.pop_front();
    }
    obey(fields);
    return mute ? std::nullopt : std::optional(reply);
}

void IdealDrive::setExact(double place)
{
    m_set += place - position;
    position = place;
    home = moteus::HomeState::Output;
}

double IdealDrive::state(moteus::Register reg) const
{
    using moteus::Register;
    switch (reg) {
        case Register::Mode:
            return static_cast<double>(mode);
        case Register::Position:
            return falsePlaces.empty() ? position : falsePlaces.front();
        case Register::Velocity:
            return velocity.value_or(0.0);
        case Register::ControlPosition:
            return std::floor(position * kCountsInReports) / kCountsInReports;
        case Register::ControlVelocity:
            return m_running;
        case Register::StayWithinLower:
            return m_echo;
        case Register::Torque:
            return torque;
        case Register::QCurrent:
            return current;
        case Register::DCurrent:
            return dCurrent;
        case Register::Power:
            return power;
        case Register::MotorTemperature:
            return motorTemperature;
        case Register::HomeState:
            return static_cast<double>(home);
        case Register::Voltage:
            return voltage;
        case Register::Temperature:
            return temperature;
        case Register::Fault:
            return static_cast<double>(fault);
        default:
            return 0.0;
    }
}

CanFrame IdealDrive::stateFrame(SteadyTime now) const
{
    std::array<moteus::RegisterValue, 16> values;  // of rotatorQuery()
    std::size_t count = 0;
    for (const moteus::RegisterRead& read : moteus::rotatorQuery()) {
        if (!modeOnly || read.reg == moteus::Register::Mode) {
            values.at(count++) = {read.reg, read.resolution, state(read.reg)};
        }
    }
    moteus::SubframeWriter writer;
    writer.appendReplies(std::span(values).first(count));
    CanFrame reply =
        moteus::makeFrame({.replyWanted = false, .source = m_id, .destination = moteus::kHostId}, writer.bytes());
    reply.received = now;
    return reply;
}

Written IdealDrive::written(const CanFrame& frame)
{
    Written fields;
    moteus::SubframeReader reader(frame.payload());
    while (const auto subframe = reader.next()) {
        if (const auto* const write = std::get_if<moteus::WriteBlock>(&*subframe)) {
            for (std::uint32_t i = 0; i < write->count; ++i) {
                const moteus::RegisterValue value = write->value(i);
                fields.set(value.reg, value.value);
            }
        }
    }
    return fields;
}

void IdealDrive::obey(const Written& fields)
{
    takePlace(fields);
    const auto commanded = fields.find(moteus::Register::Mode);
    if (!commanded) {
        return;
    }
    const auto wanted = static_cast<moteus::Mode>(static_cast<int>(*commanded));
    seen.push_back({wanted, fields});
    const bool latched = mode == moteus::Mode::Fault || mode == moteus::Mode::PositionTimeout;
    if (deaf || (latched && wanted != moteus::Mode::Stopped)) {
        return;
    }
    mode = wanted;
    fault = 0;
    m_ordered = 0.0;
    m_fed = m_now;
    const auto target = fields.find(moteus::Register::CommandPosition);
    if (mode == moteus::Mode::Position && target) {
        if (std::isfinite(*target)) {
            travelled += *target - position;
            position = *target;
            m_running = 0.0;
        } else {
            m_ordered = fields.find(moteus::Register::CommandVelocity).value_or(0.0);
            m_acceleration = fields.find(moteus::Register::CommandAccelerationLimit).value_or(0.0);
        }
    }
}

// Turns with the velocity of the last command until the watchdog ends it.
void IdealDrive::advanceTo(SteadyTime now)
{
    const Seconds passed = std::min(Seconds(now - m_now), std::max(Seconds(m_fed - m_now) + kWatchdog, Seconds{}));
    m_now = now;
    if (mode == moteus::Mode::Position) {
        run(passed.count());
    }
    if (mode != moteus::Mode::Position || now - m_fed > kWatchdog) {
        m_running = m_ordered = 0.0;
    }
}

void IdealDrive::run(double passed)
{
    const double wanted = m_ordered - m_running;
    const double ramp = m_acceleration > 0.0 ? std::min(passed, std::abs(wanted) / m_acceleration) : 0.0;
    const double change = std::copysign(m_acceleration * ramp, wanted);
    const double moved = m_running * passed + change * (passed - 0.5 * ramp);
    m_running += change;
    travelled += moved;
    position += moved;
}

// With a 100:1 gear: the phase of the rotor stays.
void IdealDrive::takePlace(const Written& fields)
{
    constexpr double kRatio = 0.01;
    if (const auto nearest = fields.find(moteus::Register::SetOutputNearest); nearest) {
        setExact(position + std::round((*nearest - position) / kRatio) * kRatio);
    }
    if (const auto exact = fields.find(moteus::Register::SetOutputExact); exact) {
        setExact(*exact);
    }
}

}  // namespace boresight::fakes
