// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/gs232/esp32_offsets.h"
#include "core/rotator_box/simulated_box.h"
#include "core/units/sky.h"

#include <array>
#include <deque>
#include <optional>
#include <string>
#include <string_view>

// The ESP32 relay controller at the wire, with its two motors: words, decimals, RPRT replies, and no stop. A relay is
// on while its axis is more than 2° away from its target, which is compared each half second. Time is passed in.
//
// More than 15 members: the state of one program with one loop.
namespace boresight::gs232 {

class Esp32Box final : public SimulatedBox
{
public:
    static constexpr AngularRate kSpeed = AngularRate::fromDegrees(3.0);
    static constexpr Angle kTolerance = Angle::fromDegrees(2.0);

    struct Faults
    {
        bool silent = false;                    // acts, but sends no answers
        std::array<double, 2> pace{1.0, 1.0};   // share of its speed that each motor reaches
        std::array<int, 4> digits{3, 3, 3, 3};  // calibration of its sensor
        esp32::Offsets offsets{.accelerometer = {1, 2, 3},
                               .magnetometer = {4, 5, 6},
                               .gyroscope = {7, 8, 9},
                               .accelerometerRadius = 1000,
                               .magnetometerRadius = 700};
        bool twitches = false;  // runs each relay for 0.3 s when it starts
    };

    explicit Esp32Box(const AxisPosition& place = {}) : m_place{place.azimuth, place.elevation} {}

    void take(std::string_view bytes, SteadyTime now) override;
    [[nodiscard]] std::string answers(SteadyTime now) override;

    // Power off and on. `calibrated`: offsets are stored. Without them it calibrates first, and obeys nothing
    // meanwhile.
    void restart(SteadyTime now, bool calibrated = true);
    // Its own program of motions, which a stop does not end: another target each 13 s.
    void dance(SteadyTime now);
    [[nodiscard]] Faults& faults() { return m_faults; }

    // The true position at the time of the last call.
    [[nodiscard]] AxisPosition truth() const { return {.azimuth = m_place[0], .elevation = m_place[1]}; }
    [[nodiscard]] int moves() const { return m_moves; }  // commands to move or stop so far
    [[nodiscard]] const std::deque<std::string>& heard() const { return m_heard; }

private:
    struct Due
    {
        SteadyTime when;
        std::string bytes;
    };

    void moveOn(SteadyTime now);
    void turn(Seconds time);
    void loop();
    void compareTargets();
    void twitch();
    void danceOn();
    void obey(const std::string& line);
    [[nodiscard]] bool obeyAxis(const std::string& line);
    [[nodiscard]] std::optional<std::string> answerTo(const std::string& command);
    [[nodiscard]] bool move(const std::string& command);
    [[nodiscard]] std::string statistics();
    [[nodiscard]] Angle heading() const { return m_place[0].wrapped360(); }
    [[nodiscard]] Angle readElevation();
    [[nodiscard]] bool isCalibrated() const;
    void reply(const std::string& text);

    Faults m_faults;
    std::array<Angle, 2> m_place;
    std::array<std::optional<Angle>, 2> m_targets;
    std::array<int, 2> m_relays{0, 0};  // -1, 0, 1
    std::array<Angle, 5> m_tilts{};     // the last readings; zeros at first
    std::size_t m_nextTilt = 0;
    bool m_reports = false;
    bool m_calibrates = false;
    bool m_starts = false;
    std::optional<AxisPosition> m_stage;  // where it was when its dance began
    int m_danceLoops = 0;                 // since then
    std::string m_line;
    std::deque<std::string> m_waiting;  // lines that were received while it calibrated
    std::deque<Due> m_due;
    std::deque<std::string> m_heard;
    std::optional<SteadyTime> m_moved;
    SteadyTime m_nextLoop{};
    int m_moves = 0;
    int m_random = 0;
};

}  // namespace boresight::gs232
