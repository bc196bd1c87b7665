// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"
#include "core/gs232/box_reply.h"
#include "core/rotator_box/simulated_box.h"
#include "core/units/sky.h"

#include <array>
#include <deque>
#include <optional>
#include <string>
#include <string_view>

// A simulated GS-232 rotator with its box: relays that switch the motors on and off, one speed, a coast after the relay
// opens, a potentiometer with whole degrees. Bytes in, bytes out, as in the data sheets and in the recordings of
// Hamlib. It fails on request. Pure: time is passed in. Angles as the box counts them.
namespace boresight::gs232 {

class Gs232Box final : public SimulatedBox
{
public:
    static constexpr AngularRate kSpeed = AngularRate::fromDegrees(6.0);
    static constexpr Angle kCoast = Angle::fromDegrees(0.5);

    enum class Acknowledge
    {
        None,
        Cr,
        Prompt
    };
    struct Habits
    {
        Dialect dialect = Dialect::B;
        Acknowledge acknowledge = Acknowledge::Cr;
        bool elevation = true;  // false: it has only an azimuth, and refuses commands for the elevation
        std::chrono::milliseconds latency{60};
    };
    struct Faults
    {
        bool silent = false;                   // acts, but sends no answers
        bool deaf = false;                     // receives nothing
        bool echoes = false;                   // sends back what it receives
        bool halfLines = false;                // every second answer to a question is cut in the middle
        bool frozen = false;                   // the motors do not move
        bool refuses = false;                  // refuses every command
        bool stuckMeter = false;               // the potentiometers keep their old values
        bool stuckRelay = false;               // a stop does not open the relays
        Angle offset{};                        // error of the reported azimuth
        bool worn = false;                     // both potentiometers report the right count or one beside it
        Angle coast = kCoast;                  // the way of a motor after its relay has opened
        std::array<double, 2> pace{1.0, 1.0};  // share of its speed that each motor reaches
    };

    Gs232Box(const AxisPosition& place, const Habits& habits);
    explicit Gs232Box(const AxisPosition& place = {}) : Gs232Box(place, Habits{}) {}

    void take(std::string_view bytes, SteadyTime now) override;
    [[nodiscard]] std::string answers(SteadyTime now) override;

    // Off: the rotator stands still, sends no answers and forgets its targets.
    void setPower(bool on, SteadyTime now);
    void restart(SteadyTime now);  // power off and on at once
    [[nodiscard]] Faults& faults() { return m_faults; }

    // The true position at the time of the last call.
    [[nodiscard]] AxisPosition truth() const { return {.azimuth = m_axes[0].place, .elevation = m_axes[1].place}; }
    [[nodiscard]] int moves() const { return m_moves; }  // commands to move or stop, accepted so far
    [[nodiscard]] int starts() const { return starts(Axis::Azimuth) + starts(Axis::Elevation); }
    [[nodiscard]] int starts(Axis axis) const { return m_axes[index(axis)].starts; }  // starts of its motor
    [[nodiscard]] const std::deque<std::string>& heard() const { return m_heard; }    // without line ends
    void moveOn(SteadyTime now);

private:
    struct Motor
    {
        Angle place;
        TravelRange reach;
        std::optional<Angle> target;
        bool runs = false;
        Angle coast{};  // way that is still to come, with its sign
        int starts = 0;
    };
    struct Due
    {
        SteadyTime when;
        std::string bytes;
    };

    void run(Motor& motor, AngularRate speed, Seconds time);
    void obey(const std::string& command, SteadyTime now);
    [[nodiscard]] std::optional<std::string> query(const std::string& command) const;
    [[nodiscard]] bool move(const std::string& command);
    [[nodiscard]] bool send(Axis axis, std::string_view digits);
    void stop(Axis axis);
    void reply(std::string text, SteadyTime now);

    Habits m_habits;
    Faults m_faults;
    std::array<Motor, 2> m_axes;
    AxisPosition m_shown = truth();  // positions that the potentiometers show
    bool m_powered = true;
    std::string m_line;
    std::deque<Due> m_due;
    std::deque<std::string> m_heard;
    std::optional<SteadyTime> m_moved;
    int m_moves = 0;
    int m_questions = 0;
};

}  // namespace boresight::gs232
