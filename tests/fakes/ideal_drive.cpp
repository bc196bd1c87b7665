// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/fakes/ideal_drive.h"

#include <cmath>

namespace boresight::fakes {

std::optional<CanFrame> IdealDrive::answer(const CanFrame& frame, SteadyTime now)
{
    const moteus::Arbitration to = moteus::fromCanId(frame.id);
    if (to.destination != m_id || silent) {
        return std::nullopt;
    }
    CanFrame reply = stateFrame(now);
    if (!falsePlaces.empty()) {
        falsePlaces.pop_front();
    }
    obey(frame);
    return mute ? std::nullopt : std::optional(reply);
}

void IdealDrive::setExact(double place)
{
    m_set += place - position;
    position = place;
    home = moteus::HomeState::Output;
}

CanFrame IdealDrive::stateFrame(SteadyTime now) const
{
    using moteus::Register;
    std::map<Register, double> state{{Register::Mode, static_cast<double>(mode)},
                                     {Register::Position, falsePlaces.empty() ? position : falsePlaces.front()},
                                     {Register::Torque, torque},
                                     {Register::QCurrent, current},
                                     {Register::HomeState, static_cast<double>(home)},
                                     {Register::Voltage, voltage},
                                     {Register::Temperature, temperature},
                                     {Register::Fault, static_cast<double>(fault)}};
    if (velocity) {
        state[Register::Velocity] = *velocity;
    }
    std::vector<moteus::RegisterValue> values;
    for (const moteus::RegisterRead& read : moteus::rotatorQuery()) {
        if (modeOnly && read.reg != Register::Mode) {
            continue;
        }
        const auto known = state.find(read.reg);
        values.push_back({read.reg, read.resolution, known == state.end() ? 0.0 : known->second});
    }
    moteus::SubframeWriter writer;
    writer.appendReplies(values);
    CanFrame reply =
        moteus::makeFrame({.replyWanted = false, .source = m_id, .destination = moteus::kHostId}, writer.bytes());
    reply.received = now;
    return reply;
}

void IdealDrive::obey(const CanFrame& frame)
{
    std::map<moteus::Register, double> fields;
    moteus::SubframeReader reader(frame.payload());
    while (const auto subframe = reader.next()) {
        if (const auto* const write = std::get_if<moteus::WriteBlock>(&*subframe)) {
            for (std::uint32_t i = 0; i < write->count; ++i) {
                const moteus::RegisterValue value = write->value(i);
                fields[value.reg] = value.value;
            }
        }
    }
    takePlace(fields);
    const auto commanded = fields.find(moteus::Register::Mode);
    if (commanded == fields.end()) {
        return;
    }
    const auto wanted = static_cast<moteus::Mode>(static_cast<int>(commanded->second));
    seen.push_back({wanted, fields});
    const bool latched = mode == moteus::Mode::Fault || mode == moteus::Mode::PositionTimeout;
    if (deaf || (latched && wanted != moteus::Mode::Stopped)) {
        return;
    }
    mode = wanted;
    fault = 0;
    const auto target = fields.find(moteus::Register::CommandPosition);
    if (mode == moteus::Mode::Position && target != fields.end() && std::isfinite(target->second)) {
        travelled += target->second - position;
        position = target->second;
    }
}

// Of a 100:1 gear: the phase of the rotor stays.
void IdealDrive::takePlace(const std::map<moteus::Register, double>& fields)
{
    constexpr double kRatio = 0.01;
    if (const auto nearest = fields.find(moteus::Register::SetOutputNearest); nearest != fields.end()) {
        setExact(position + std::round((nearest->second - position) / kRatio) * kRatio);
    }
    if (const auto exact = fields.find(moteus::Register::SetOutputExact); exact != fields.end()) {
        setExact(exact->second);
    }
}

}  // namespace boresight::fakes
