// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/rotctld_mount/rotctld_box.h"

#include "core/rotator_box/each_step.h"

#include <algorithm>
#include <cmath>

namespace boresight::rotctl {
namespace {

constexpr std::size_t kHeardKept = 1000;

Angle movedTo(Angle place, Angle target, Angle farthest)
{
    return std::clamp(target, place - farthest, place + farthest);
}

// The server parses positions in single precision, where 20.6 is 20.6000004.
Angle asWritten(Angle angle)
{
    constexpr double kDecimals = 1e4;
    return Angle::fromDegrees(std::round(angle.degrees() * kDecimals) / kDecimals);
}

}  // namespace

RotctldBox::RotctldBox(const AxisPosition& place, const std::array<Angle, 2>& steps)
    : m_steps(steps), m_place(place), m_target(place), m_shown(place)
{
    beginSession();
}

void RotctldBox::beginSession()
{
    rotctld::Rotator& self = *this;
    m_session.emplace(rotctld::Client{.id = 1, .address = "simulated"}, self, m_clock,
                      rotctld::DumpStateForm::AsHamlib);
}

void RotctldBox::moveOn(SteadyTime now)
{
    const Angle farthest = m_started ? kSpeed * Seconds(now - m_clock.time) : Angle{};
    m_started = true;
    m_clock.time = now;
    if (!m_faults.frozen) {
        m_place = {.azimuth = movedTo(m_place.azimuth, m_target.azimuth, farthest * m_faults.pace[0]),
                   .elevation = movedTo(m_place.elevation, m_target.elevation, farthest * m_faults.pace[1])};
    }
    if (m_homes && m_place == m_faults.lost) {
        m_place = m_target = {};
        m_faults.lost = {};
        m_homes = false;
    }
    m_shown = m_faults.stuckPlace ? m_shown : m_place;
}

void RotctldBox::take(std::string_view bytes, SteadyTime now)
{
    moveOn(now);
    if (m_faults.deaf || bytes.empty()) {
        return;
    }
    m_heard.emplace_back(bytes);
    if (m_heard.size() > kHeardKept) {
        m_heard.pop_front();
    }
    m_half += bytes;
    for (std::size_t end = m_half.find('\n'); end != std::string::npos; end = m_half.find('\n')) {
        m_todo.push_back({.line = m_half.substr(0, end + 1)});
        m_half.erase(0, end + 1);
    }
    work(now);
}

void RotctldBox::work(SteadyTime now)
{
    while (!m_todo.empty() && m_busy <= now) {
        m_busy = now + m_faults.works;
        const Command command = m_todo.front();
        m_todo.pop_front();
        carryOut(command);
    }
}

void RotctldBox::carryOut(const Command& command)
{
    m_session->receive(command.line);
    std::string reply;
    while (m_session->step(reply)) {
        if (m_faults.halfAnswers && !reply.empty() && ++m_replies % 2 == 0) {
            reply.resize(reply.size() / 2);
        }
        if (!m_faults.silent && command.answered && !reply.empty()) {
            m_due.push_back({.when = m_busy, .bytes = reply});
        }
        reply.clear();
    }
}

std::string RotctldBox::answers(SteadyTime now)
{
    moveOn(now);
    work(now);
    std::string bytes;
    while (!m_due.empty() && m_due.front().when <= now) {
        bytes += m_due.front().bytes;
        m_due.pop_front();
    }
    return bytes;
}

void RotctldBox::reconnect()
{
    m_half.clear();
    m_due.clear();
    for (Command& command : m_todo) {
        command.answered = false;
    }
}

void RotctldBox::restart(SteadyTime now)
{
    moveOn(now);
    m_target = m_place;
    m_half.clear();
    m_todo.clear();
    m_due.clear();
    m_busy = {};
    beginSession();
}

Result<SkyPointing> RotctldBox::position(const rotctld::Client& /*client*/)
{
    if (m_faults.position) {
        return failure(*m_faults.position, {});
    }
    return SkyPointing{.azimuth = m_shown.azimuth + m_faults.offset, .elevation = m_shown.elevation - m_faults.sag};
}

rotctld::MotionFlags RotctldBox::motion() const
{
    return {.movingLeft = m_target.azimuth<m_place.azimuth, .movingRight = m_target.azimuth> m_place.azimuth,
            .movingUp = m_target.elevation > m_place.elevation,
            .movingDown = m_target.elevation < m_place.elevation};
}

Result<QString> RotctldBox::pointTo(const rotctld::Client& /*client*/, const rotctld::PointRequest& request)
{
    ++m_moves;
    if (m_faults.order) {
        return failure(*m_faults.order, {});
    }
    const TravelRange azimuth{.min = kLimits.minAzimuth, .max = kLimits.maxAzimuth};
    const TravelRange elevation{.min = kLimits.minElevation, .max = kLimits.maxElevation};
    if (!azimuth.contains(request.azimuth) || !elevation.contains(request.elevation)) {
        return failure(ErrorCode::OutOfRange, {});
    }
    m_target = {.azimuth = inSteps(asWritten(request.azimuth), m_steps[0]),
                .elevation = inSteps(asWritten(request.elevation), m_steps[1])};
    return QString();
}

Result<> RotctldBox::move(const rotctld::Client& /*client*/, rotctld::MoveDirection direction, int /*speed*/)
{
    ++m_moves;
    switch (direction) {
        case rotctld::MoveDirection::Up:
            m_target.elevation = kLimits.maxElevation;
            break;
        case rotctld::MoveDirection::Down:
            m_target.elevation = kLimits.minElevation;
            break;
        case rotctld::MoveDirection::Left:
            m_target.azimuth = kLimits.minAzimuth;
            break;
        case rotctld::MoveDirection::Right:
            m_target.azimuth = kLimits.maxAzimuth;
            break;
    }
    return {};
}

Result<> RotctldBox::stop(const rotctld::Client& /*client*/)
{
    ++m_moves;
    if (m_faults.stop) {
        return failure(*m_faults.stop, {});
    }
    m_target = m_faults.runsOn ? m_target : m_place;
    m_homes = m_homes && m_faults.runsOn;
    return {};
}

// It drives to where its count and the truth agree.
Result<> RotctldBox::reset(const rotctld::Client& /*client*/, int /*kind*/)
{
    ++m_moves;
    if (m_faults.reset) {
        return failure(*m_faults.reset, {});
    }
    ++m_homeRuns;
    m_homes = true;
    m_target = m_faults.lost;
    return {};
}

Result<> RotctldBox::park(const rotctld::Client& /*client*/)
{
    ++m_moves;
    m_target = {};
    return {};
}

}  // namespace boresight::rotctl
