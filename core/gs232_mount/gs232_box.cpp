// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/gs232_mount/gs232_box.h"

#include "core/base/numbers.h"
#include "core/base/upper.h"
#include "core/gs232/box_command.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace boresight::gs232 {
namespace {

constexpr std::size_t kHeardKept = 1000;

std::string threeDigits(Angle angle)
{
    const std::string digits = std::to_string(static_cast<int>(std::lround(std::max(angle.degrees(), 0.0))));
    return std::string(3 - std::min<std::size_t>(digits.size(), 3), '0') + digits;
}

Angle whole(Angle angle)
{
    return Angle::fromDegrees(std::round(angle.degrees()));
}

}  // namespace

Gs232Box::Gs232Box(const AxisPosition& place, const Habits& habits)
    : m_habits(habits),
      m_axes{Motor{.place = place.azimuth, .reach = kAzimuthReach, .target = {}},
             Motor{.place = place.elevation, .reach = kElevationReach, .target = {}}}
{}

void Gs232Box::moveOn(SteadyTime now)
{
    const Seconds time = m_moved ? Seconds(now - *m_moved) : Seconds(0.0);
    m_moved = now;
    for (const Axis axis : kAxes) {
        run(m_axes[index(axis)], kSpeed * m_faults.pace[index(axis)], time);
    }
    m_shown = m_faults.stuckMeter ? m_shown : truth();
}

// The relay opens as soon as the potentiometer shows the degree of the target. Then the motor coasts.
void Gs232Box::run(Motor& motor, AngularRate speed, Seconds time)
{
    if (m_faults.frozen) {
        motor.coast = {};
        return;
    }
    Angle farthest = speed * time;
    if (motor.runs && motor.target) {
        const Angle way = *motor.target - motor.place;
        const Angle edge = std::max(abs(way) - kCoast, Angle{});
        const Angle done = std::min(edge, farthest);
        motor.place += way < Angle{} ? -done : done;
        farthest -= done;
        if (done == edge) {
            motor.runs = false;
            motor.target.reset();
            const Angle coast = m_faults.coast > kCoast ? m_faults.coast : std::min(kCoast, abs(way));
            motor.coast = way < Angle{} ? -coast : coast;
        }
    }
    const Angle coasted = std::clamp(motor.coast, -farthest, farthest);
    motor.place = std::clamp(motor.place + coasted, motor.reach.min, motor.reach.max);
    motor.coast -= coasted;
}

void Gs232Box::take(std::string_view bytes, SteadyTime now)
{
    moveOn(now);
    if (!m_powered || m_faults.deaf) {
        return;
    }
    if (m_faults.echoes) {
        m_due.push_back({.when = now, .bytes = std::string(bytes)});
    }
    for (const char one : bytes) {
        if (one != '\r' && one != '\n') {
            m_line += upper(one);
        } else if (const std::string command = std::exchange(m_line, {}); !command.empty()) {
            m_heard.push_back(command);
            if (m_heard.size() > kHeardKept) {
                m_heard.pop_front();
            }
            obey(command, now);
        }
    }
}

void Gs232Box::obey(const std::string& command, SteadyTime now)
{
    if (m_faults.refuses) {
        reply("?>\r\n", now);
    } else if (const auto answer = query(command)) {
        ++m_questions;
        const bool half = m_faults.halfLines && m_questions % 2 == 0;
        reply(half ? answer->substr(0, answer->size() / 2) : *answer + "\r\n", now);
    } else if (!move(command)) {
        reply("?>\r\n", now);
    } else {
        ++m_moves;
        if (m_habits.acknowledge != Acknowledge::None) {
            reply(m_habits.acknowledge == Acknowledge::Cr ? "\r" : "\r\n>", now);
        }
    }
}

std::optional<std::string> Gs232Box::query(const std::string& command) const
{
    const bool a = m_habits.dialect == Dialect::A;
    const auto noise = [this](int phase) {
        constexpr std::array<double, 7> kNoise{0.0, 1.0, 1.0, -1.0, 0.0, -1.0, 1.0};
        return Angle::fromDegrees(m_faults.worn ? kNoise[static_cast<std::size_t>(m_questions + phase) % 7] : 0.0);
    };
    const std::string azimuth = (a ? "+0" : "AZ=") + threeDigits(m_shown.azimuth + m_faults.offset + noise(0));
    const std::string elevation = (a ? "+0" : "EL=") + threeDigits(m_shown.elevation + noise(3));
    if (command == "C") {
        return azimuth;
    }
    if (!m_habits.elevation) {
        return std::nullopt;
    }
    if (command == "C2") {
        return azimuth + (a ? "" : "  ") + elevation;
    }
    return command == "B" ? std::optional(elevation) : std::nullopt;
}

// False if the box refuses the command.
bool Gs232Box::move(const std::string& command)
{
    if (command == "S" || command == "A" || command == "E") {
        if (command != "E") {
            stop(Axis::Azimuth);
        }
        if (command != "A") {
            stop(Axis::Elevation);
        }
        return true;
    }
    if (command.size() == 4 && command.front() == 'M') {
        return send(Axis::Azimuth, std::string_view(command).substr(1));
    }
    if (m_habits.elevation && command.size() == 8 && command.front() == 'W' && command[4] == ' ') {
        const auto elevation = parseInteger(std::string_view(command).substr(5));
        return elevation && *elevation >= 0 && *elevation <= 180 &&
               send(Axis::Azimuth, std::string_view(command).substr(1, 3)) &&
               send(Axis::Elevation, std::string_view(command).substr(5));
    }
    return false;
}

bool Gs232Box::send(Axis axis, std::string_view digits)
{
    Motor& motor = m_axes[index(axis)];
    const auto degrees = parseInteger(digits);
    const Angle target = Angle::fromDegrees(static_cast<double>(degrees.value_or(-1)));
    if (!degrees || !motor.reach.contains(target)) {
        return false;
    }
    if (target == whole(motor.place) && !motor.runs) {
        return true;  // the potentiometer already shows this degree
    }
    if (!motor.runs) {
        ++motor.starts;
    }
    motor.target = target;
    motor.runs = true;
    motor.coast = {};
    return true;
}

void Gs232Box::stop(Axis axis)
{
    Motor& motor = m_axes[index(axis)];
    if (m_faults.stuckRelay || !motor.runs) {
        return;
    }
    motor.coast = *motor.target < motor.place ? -m_faults.coast : m_faults.coast;
    motor.target.reset();
    motor.runs = false;
}

void Gs232Box::reply(std::string text, SteadyTime now)
{
    if (!m_faults.silent) {
        m_due.push_back({.when = now + m_habits.latency, .bytes = std::move(text)});
    }
}

std::string Gs232Box::answers(SteadyTime now)
{
    moveOn(now);
    std::string bytes;
    while (!m_due.empty() && m_due.front().when <= now) {
        bytes += m_due.front().bytes;
        m_due.pop_front();
    }
    return bytes;
}

void Gs232Box::setPower(bool on, SteadyTime now)
{
    moveOn(now);
    m_powered = on;
    m_due.clear();
    m_line.clear();
    for (const Axis axis : kAxes) {
        stop(axis);
    }
}

void Gs232Box::restart(SteadyTime now)
{
    setPower(false, now);
    setPower(true, now);
}

}  // namespace boresight::gs232
