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
// 0…90°. It works at one command at a time, in order. The bytes are those of our own server, which answers as Hamlib's
// does. It fails on request. Pure: time is passed in.
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
        bool silent = false;                   // acts, but answers nothing
        bool deaf = false;                     // takes nothing
        bool halfAnswers = false;              // each second answer loses its second half
        bool frozen = false;                   // the motors stand, whatever it is told
        bool stuckPlace = false;               // it reports what it reported before
        bool runsOn = false;                   // a stop is accepted, and nothing stops
        Angle offset{};                        // of the azimuth that it reports
        Angle sag{};                           // by which it reports the elevation too low
        std::chrono::milliseconds works{5};    // at each command
        std::array<double, 2> pace{1.0, 1.0};  // of each motor, of its speed
        // As the rotator behind it fails: the error of each answer.
        std::optional<ErrorCode> position{};
        std::optional<ErrorCode> order{};
        std::optional<ErrorCode> stop{};
    };

    explicit RotctldBox(const AxisPosition& place = {});
    RotctldBox(const RotctldBox&) = delete;  // its server knows it
    RotctldBox& operator=(const RotctldBox&) = delete;

    void take(std::string_view bytes, SteadyTime now) override;
    [[nodiscard]] std::string answers(SteadyTime now) override;

    // The program was ended and started again: the rotator stands, and a client has to connect anew.
    void restart(SteadyTime now);
    // The client connects anew: what it has sent is carried out, and the answers are lost.
    void reconnect();
    // As another client would.
    void send(const AxisPosition& target) { m_target = target; }
    [[nodiscard]] Faults& faults() { return m_faults; }

    // Where it really stands at the time of the last call.
    [[nodiscard]] AxisPosition truth() const { return m_place; }
    [[nodiscard]] int moves() const { return m_moves; }  // orders to move or stop so far, accepted or not
    [[nodiscard]] const std::deque<std::string>& heard() const { return m_heard; }  // as it came
    [[nodiscard]] std::size_t waiting() const { return m_todo.size(); }             // commands that it has not begun
    void moveOn(SteadyTime now);

private:
    // The server asks for the time of the pauses that a client wants.
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
        bool answered = true;  // its client is still there
    };

    void beginSession();
    void work(SteadyTime now);
    void carryOut(const Command& command);
    [[nodiscard]] std::string info() const override { return "Dummy rotator"; }
    [[nodiscard]] rotctld::Limits limits() const override { return kLimits; }
    [[nodiscard]] Result<SkyPointing> position(const rotctld::Client& client) override;
    [[nodiscard]] rotctld::MotionFlags motion() const override;
    [[nodiscard]] bool follows(const rotctld::Client& /*client*/) const override { return true; }
    Result<QString> pointTo(const rotctld::Client& client, const rotctld::PointRequest& request) override;
    Result<> move(const rotctld::Client& client, rotctld::MoveDirection direction, int speed) override;
    Result<QString> moveAt(const rotctld::Client& client, rotctld::MoveDirection direction,
                           AngularRate /*rate*/) override
    {
        return move(client, direction, 0).map([] { return QString(); });
    }
    Result<> stop(const rotctld::Client& client) override;
    Result<> park(const rotctld::Client& client) override;
    Result<> reset(const rotctld::Client& /*client*/, int /*kind*/) override { return {}; }
    [[nodiscard]] int speedLevel() const override { return 2; }
    Result<> setSpeedLevel(const rotctld::Client& /*client*/, int /*level*/) override { return {}; }
    void clientConnected(const rotctld::Client& /*client*/) override {}
    void clientGone(const rotctld::Client& /*client*/, const QString& /*reason*/) override {}
    void clientRemark(const rotctld::Client& /*client*/, const QString& /*text*/) override {}

    HandedClock m_clock;
    AxisPosition m_place;
    AxisPosition m_target;
    AxisPosition m_shown;
    Faults m_faults;
    std::optional<rotctld::Session> m_session;  // always there
    std::string m_half;                         // of a line
    std::deque<Command> m_todo;
    SteadyTime m_busy{};  // until then
    std::deque<Due> m_due;
    std::deque<std::string> m_heard;
    bool m_started = false;
    int m_moves = 0;
    int m_replies = 0;
};

}  // namespace boresight::rotctl
