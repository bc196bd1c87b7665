// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"
#include "core/rotator_box/simulated_box.h"
#include "core/rotctld/session.h"
#include "core/units/sky.h"

#include <array>
#include <deque>
#include <optional>
#include <string>
#include <string_view>

// A simulated rotctld with the dummy rotator of Hamlib: 6 °/s on both axes without ramps, exact arrival, -180…450° and
// 0…90°. It carries out one command at a time, in order. The bytes come from our own server, which answers like that of
// Hamlib. It fails on request. Pure: time is passed in.
//
// More than 15 members: the server and the rotator behind it.
namespace boresight::rotctl {

class RotctldBox final : public SimulatedBox, private rotctld::Rotator
{
public:
    static constexpr AngularRate kSpeed = AngularRate::fromDegrees(6.0);
    static constexpr rotctld::Limits kLimits{.minAzimuth = Angle::fromDegrees(-180.0),
                                             .maxAzimuth = Angle::fromDegrees(450.0),
                                             .minElevation = Angle::fromDegrees(0.0),
                                             .maxElevation = Angle::fromDegrees(90.0)};

    struct Faults
    {
        bool silent = false;                   // acts, but sends no answers
        bool deaf = false;                     // receives nothing
        bool halfAnswers = false;              // every second answer loses its second half
        bool frozen = false;                   // the motors do not move
        bool stuckPlace = false;               // it reports the old position again and again
        bool runsOn = false;                   // a stop is accepted, but the rotator moves on
        Angle offset{};                        // error of the reported azimuth
        Angle sag{};                           // the reported elevation is lower by this angle
        AxisPosition lost{};                   // steps that were lost: the rotator counts more than the truth
        std::chrono::milliseconds works{5};    // for each command
        std::array<double, 2> pace{1.0, 1.0};  // share of its speed that each motor reaches
        // Errors of the rotator behind rotctld: the error of each kind of answer.
        std::optional<ErrorCode> position{};
        std::optional<ErrorCode> order{};
        std::optional<ErrorCode> stop{};
        std::optional<ErrorCode> reset{};
    };

    // `steps`: its axes stop only at multiples of these. 0: anywhere.
    explicit RotctldBox(const AxisPosition& place = {}, const std::array<Angle, 2>& steps = {});
    RotctldBox(const RotctldBox&) = delete;  // its server refers to it
    RotctldBox& operator=(const RotctldBox&) = delete;

    void take(std::string_view bytes, SteadyTime now) override;
    [[nodiscard]] std::string answers(SteadyTime now) override;

    // The program was ended and started again: the rotator stands still, and a client must connect again.
    void restart(SteadyTime now);
    // The client connects again: its commands are carried out, but their answers are lost.
    void reconnect();
    // Moves the rotator like another client.
    void send(const AxisPosition& target) { m_target = target; }
    [[nodiscard]] Faults& faults() { return m_faults; }

    // The true position at the time of the last call.
    [[nodiscard]] AxisPosition truth() const
    {
        return {.azimuth = m_place.azimuth - m_faults.lost.azimuth,
                .elevation = m_place.elevation - m_faults.lost.elevation};
    }
    // Its own switches are at 0°. Its count begins there again.
    [[nodiscard]] int homeRuns() const { return m_homeRuns; }
    [[nodiscard]] int moves() const { return m_moves; }  // commands to move or stop so far, accepted or not
    [[nodiscard]] const std::deque<std::string>& heard() const { return m_heard; }  // received lines
    [[nodiscard]] std::size_t waiting() const { return m_todo.size(); }             // commands that were not begun yet
    void moveOn(SteadyTime now);

private:
    // The server reads this clock for the pauses that a client asks for.
    class HandedClock final : public Clock
    {
    public:
        [[nodiscard]] SteadyTime now() const override { return time; }
        [[nodiscard]] UtcTime utc() const override { return {}; }
        [[nodiscard]] bool synchronised() const override { return false; }
        [[nodiscard]] std::optional<Seconds> error() const override { return {}; }
        [[nodiscard]] Seconds slept() const override { return Seconds(0.0); }
        SteadyTime time{};
    };
    struct Due
    {
        SteadyTime when;
        std::string bytes;
    };
    struct Command
    {
        std::string line;
        bool answered = true;  // false: its client has gone
    };

    void beginSession();
    void work(SteadyTime now);
    void carryOut(const Command& command);
    [[nodiscard]] std::string info() const override { return "Dummy rotator"; }
    [[nodiscard]] rotctld::Limits limits() const override { return kLimits; }
    [[nodiscard]] Result<SkyPointing> position(const rotctld::Client& client) override;
    [[nodiscard]] rotctld::MotionFlags motion() const override;
    [[nodiscard]] Result<SkyPointing> target() const override
    {
        return SkyPointing{.azimuth = m_target.azimuth, .elevation = m_target.elevation};
    }
    Result<QString> pointTo(const rotctld::Client& client, const rotctld::PointRequest& request) override;
    Result<> move(const rotctld::Client& client, rotctld::MoveDirection direction, int speed) override;
    Result<QString> moveAt(const rotctld::Client& client, rotctld::MoveDirection direction,
                           AngularRate /*rate*/) override
    {
        return move(client, direction, 0).map([] { return QString(); });
    }
    Result<> stop(const rotctld::Client& client) override;
    Result<> park(const rotctld::Client& client) override;
    Result<> reset(const rotctld::Client& client, int kind) override;
    [[nodiscard]] int speedLevel() const override { return 2; }
    Result<> setSpeedLevel(const rotctld::Client& /*client*/, int /*level*/) override { return {}; }
    void clientConnected(const rotctld::Client& /*client*/) override {}
    void clientGone(const rotctld::Client& /*client*/, const QString& /*reason*/) override {}
    void clientRemark(const rotctld::Client& /*client*/, const QString& /*text*/) override {}

    std::array<Angle, 2> m_steps;
    HandedClock m_clock;
    AxisPosition m_place;
    AxisPosition m_target;
    AxisPosition m_shown;
    Faults m_faults;
    std::optional<rotctld::Session> m_session;  // never empty after construction
    std::string m_half;                         // the beginning of a line
    std::deque<Command> m_todo;
    SteadyTime m_busy{};  // until this time it works at a command
    std::deque<Due> m_due;
    std::deque<std::string> m_heard;
    bool m_started = false;
    bool m_homes = false;
    int m_homeRuns = 0;
    int m_moves = 0;
    int m_replies = 0;
};

}  // namespace boresight::rotctl
