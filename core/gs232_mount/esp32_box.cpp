// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/gs232_mount/esp32_box.h"

#include "core/base/numbers.h"
#include "core/base/upper.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <numeric>
#include <utility>

namespace boresight::gs232 {
namespace {

constexpr std::chrono::milliseconds kEsp32Latency{20};
constexpr std::chrono::milliseconds kEsp32Loop{500};
constexpr std::chrono::milliseconds kEsp32Calibration{300};  // from one line to the next

const char* const kEsp32Greeting = "Ready! Type HELP for list of commands.\r\n";
const char* const kEsp32Help =
    "\nAvailable Commands:\r\nAZ <deg>: Set azimuth\r\nAZ: Get azimuth\r\nEL <deg>: Set elevation\r\nEL: Get "
    "elevation\r\n"
    "P: Get position\r\nSA: Stop azimuth\r\nSE: Stop elevation\r\nHOME: Go to 180, 45\r\n"
    "DANCE: \xE2\x86\x90 \xE2\x86\x92 \xE2\x86\x91 \xE2\x86\x93\r\nCALIBRATE: Calibrate\r\nCALSTATS: Offsets\r\n"
    "DEBUG: Switch reports\r\nVE: Version\r\nQ: Quit\r\nHELP: This text\r\nRPRT 0\r";

std::string trimmed(std::string_view text)
{
    const auto from = text.find_first_not_of(" \t");
    return from == std::string_view::npos ? std::string()
                                          : std::string(text.substr(from, text.find_last_not_of(" \t") - from + 1));
}

// The number at the front, 0 if there is none.
Angle leadingNumber(std::string_view text)
{
    text.remove_prefix(std::min(text.find_first_not_of(' '), text.size()));
    double degrees = 0.0;
    std::from_chars(text.data(), text.data() + text.size(), degrees);
    return Angle::fromDegrees(degrees);
}

std::string oneDecimal(Angle angle)
{
    return formatFixed(angle.degrees(), 1);
}

}  // namespace

void Esp32Box::turn(Seconds time)
{
    for (const Axis axis : kAxes) {
        const std::size_t i = index(axis);
        m_place[i] += kSpeed * time * (m_relays[i] * m_faults.pace[i]);
    }
}

void Esp32Box::moveOn(SteadyTime now)
{
    if (!m_moved) {
        m_moved = now;
        m_nextLoop = now + kEsp32Loop;
    }
    while (m_nextLoop <= now) {
        turn(m_nextLoop - *m_moved);
        m_moved = m_nextLoop;
        loop();
    }
    turn(now - *m_moved);
    m_moved = now;
}

// While it calibrates, nothing else runs. The relays stay as they are.
void Esp32Box::loop()
{
    const std::array<int, 4>& digits = m_faults.digits;
    const auto digit = [&digits](std::size_t i) { return std::to_string(digits[i]); };
    if (m_calibrates) {
        reply("CALIB: SYS=" + digit(0) + " GYR=" + digit(1) + " ACC=" + digit(2) + " MAG=" + digit(3) + "\r\n");
        if (isCalibrated()) {
            m_calibrates = false;
            reply(statistics() + (std::exchange(m_starts, false) ? kEsp32Greeting : "RPRT 0\r"));
        }
        m_nextLoop += kEsp32Calibration;
        return;
    }
    while (!m_waiting.empty() && !m_calibrates) {
        obey(m_waiting.front());
        m_waiting.pop_front();
    }
    danceOn();
    compareTargets();
    if (m_reports) {
        reply("DEBUG | RawX:" + oneDecimal((heading() - Angle::fromDegrees(90.0)).wrapped360()) +
              " | CalcAZ:" + oneDecimal(heading()) + " | Calib[S:" + digit(0) + " G:" + digit(1) + " A:" + digit(2) +
              " M:" + digit(3) + "]\r\n");
    }
    m_nextLoop += kEsp32Loop;
}

// Its relays for up, down, left and right, one after the other. The way back is a little shorter than the way there.
void Esp32Box::twitch()
{
    constexpr Seconds kTwitch{0.05};
    for (const Axis axis : kAxes) {
        m_place[index(axis)] += kSpeed * kTwitch * (axis == Axis::Azimuth ? -1.0 : 1.0);
    }
}

void Esp32Box::dance(SteadyTime now)
{
    moveOn(now);
    m_stage = {.azimuth = m_place[0], .elevation = m_place[1]};
    m_danceLoops = 0;
    reply("Starting Dance... Type SA or SE to abort.\r\nRPRT 0\r");
}

void Esp32Box::danceOn()
{
    constexpr int kLoopsOfAStep = 26;  // 10 s of motion and a pause of 3 s
    constexpr std::array<AxisPosition, 5> kSteps{{{.azimuth = 30_deg, .elevation = 0_deg},
                                                  {.azimuth = -30_deg, .elevation = 0_deg},
                                                  {.azimuth = 0_deg, .elevation = 20_deg},
                                                  {.azimuth = 0_deg, .elevation = -20_deg},
                                                  {.azimuth = 0_deg, .elevation = 0_deg}}};
    if (!m_stage || m_danceLoops++ % kLoopsOfAStep != 0) {
        return;
    }
    const auto step = static_cast<std::size_t>(m_danceLoops / kLoopsOfAStep);
    if (step == kSteps.size()) {
        m_stage.reset();
        return;
    }
    m_targets = {(m_stage->azimuth + kSteps[step].azimuth).wrapped360(), m_stage->elevation + kSteps[step].elevation};
    reply("Dance step " + std::to_string(step + 1) + "\r\n");
}

void Esp32Box::compareTargets()
{
    const std::array<Angle, 2> measured{heading(), readElevation()};
    for (const Axis axis : kAxes) {
        const std::size_t i = index(axis);
        Angle way = m_targets[i] ? *m_targets[i] - measured[i] : Angle{};
        way = axis == Axis::Azimuth ? way.wrapped180() : way;
        m_relays[i] = abs(way) <= kTolerance ? 0 : way < Angle{} ? -1 : 1;
    }
}

Angle Esp32Box::readElevation()
{
    m_tilts[m_nextTilt++ % m_tilts.size()] = m_place[1];
    return std::accumulate(m_tilts.begin(), m_tilts.end(), Angle{}) / static_cast<double>(m_tilts.size());
}

bool Esp32Box::isCalibrated() const
{
    return std::ranges::all_of(m_faults.digits, [](int digit) { return digit == 3; });
}

void Esp32Box::take(std::string_view bytes, SteadyTime now)
{
    moveOn(now);
    for (const char one : bytes) {
        if (one != '\r' && one != '\n') {
            m_line += one;
        } else if (const std::string line = std::exchange(m_line, {}); !line.empty()) {
            m_heard.push_back(line);
            if (m_calibrates) {
                m_waiting.push_back(line);
            } else {
                obey(line);
            }
        }
    }
}

void Esp32Box::obey(const std::string& line)
{
    const std::string text = trimmed(line);
    if (obeyAxis(text)) {
        return;
    }
    const std::string command = upper(text);
    if (command == "Q") {
        return;
    }
    if (const auto answer = answerTo(command)) {
        reply(*answer);
    } else {
        reply(move(command) ? "RPRT 0\r" : "RPRT -1\r");
    }
}

// The names of the axes must be in upper case.
bool Esp32Box::obeyAxis(const std::string& line)
{
    const bool isAzimuth = line.starts_with("AZ");
    if (!isAzimuth && !line.starts_with("EL")) {
        return false;
    }
    const std::string rest = line.substr(2);
    if (rest.empty() || (rest.front() != ' ' && std::isdigit(static_cast<unsigned char>(rest.front())) == 0)) {
        reply((isAzimuth ? "AZ " : "EL ") + oneDecimal(isAzimuth ? heading() : readElevation()) + "\r");
        return true;
    }
    m_targets[index(isAzimuth ? Axis::Azimuth : Axis::Elevation)] = leadingNumber(rest);
    ++m_moves;
    reply("RPRT 0\r");
    return true;
}

std::optional<std::string> Esp32Box::answerTo(const std::string& command)
{
    if (command == "HELP") {
        return kEsp32Help;
    }
    if (command == "DEBUG") {
        m_reports = !m_reports;
        return m_reports ? "DEBUG ON\r" : "DEBUG OFF\r";
    }
    if (command == "P") {
        return oneDecimal(heading()) + " " + oneDecimal(readElevation()) + "\r";
    }
    if (command == "CALSTATS") {
        return statistics() + "RPRT 0\r";
    }
    if (command == "CALIBRATE") {
        m_calibrates = true;
        return "Starting Calibration...\r\n";
    }
    return command == "VE" ? std::optional<std::string>("VEAdamESP32v1.0\r") : std::nullopt;
}

// False if there is no such command. A stop switches the relay off and keeps the target.
bool Esp32Box::move(const std::string& command)
{
    if (command == "HOME") {
        m_targets = {Angle::fromDegrees(180.0), Angle::fromDegrees(45.0)};
    } else if (command == "SA") {
        m_relays[0] = 0;
    } else if (command == "SE") {
        m_relays[1] = 0;
    } else {
        return false;
    }
    ++m_moves;
    return true;
}

// The numbers are random until the sensor is calibrated.
std::string Esp32Box::statistics()
{
    m_random = isCalibrated() ? 0 : (m_random * 31 + 4711) % 20000;
    const esp32::Offsets& offsets = m_faults.offsets;
    const auto three = [this](const std::array<int, 3>& values) {
        return std::to_string(values[0] + m_random) + ',' + std::to_string(values[1] + m_random) + ',' +
               std::to_string(values[2] - m_random) + "\r\n";
    };
    return "--- Calibration Offsets ---\r\nAccel Off: " + three(offsets.accelerometer) +
           "Mag   Off: " + three(offsets.magnetometer) + "Gyro  Off: " + three(offsets.gyroscope) +
           "Accel Rad: " + std::to_string(offsets.accelerometerRadius + m_random) +
           "\r\nMag   Rad: " + std::to_string(offsets.magnetometerRadius + m_random) +
           "\r\n---------------------------\r\n";
}

void Esp32Box::reply(const std::string& text)
{
    if (!m_faults.silent) {
        m_due.push_back({.when = *m_moved + kEsp32Latency, .bytes = text});
    }
}

std::string Esp32Box::answers(SteadyTime now)
{
    moveOn(now);
    std::string bytes;
    while (!m_due.empty() && m_due.front().when <= now) {
        bytes += m_due.front().bytes;
        m_due.pop_front();
    }
    return bytes;
}

void Esp32Box::restart(SteadyTime now, bool calibrated)
{
    moveOn(now);
    m_targets = {};
    m_relays = {0, 0};
    m_tilts = {};
    m_reports = false;
    m_line.clear();
    m_waiting.clear();
    m_due.clear();
    m_stage.reset();
    m_calibrates = m_starts = !calibrated;
    if (m_faults.twitches) {
        twitch();
    }
    if (calibrated) {
        reply(kEsp32Greeting);
    }
}

}  // namespace boresight::gs232
