// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/sim/trajectory_planner.h"
#include "tests/core/sim/golden_vectors.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

namespace boresight::sim {
namespace {

constexpr double kFactoryAcceleration = 50.0;  // the configured default with which the vectors were made
constexpr double kFactoryMaxVelocity = 500.0;
constexpr double kCount = 1.0 / 65536.0;  // the drive counts positions, and the vectors show the counts

// The limits that the servo derives from a command.
TrajectoryLimits limitsOf(const QJsonObject& command)
{
    const double velocity = golden::number(command, "velocity_limit", NAN);
    double acceleration = golden::number(command, "accel_limit", NAN);
    acceleration = std::isnan(acceleration) ? kFactoryAcceleration : acceleration;
    TrajectoryLimits limits;
    if (acceleration >= 0.0) {
        limits.acceleration = acceleration;
        limits.velocity = kFactoryMaxVelocity;
    }
    if (velocity >= 0.0) {
        limits.velocity = velocity;
    }
    return limits;
}

TrajectoryTarget targetOf(const QJsonObject& command)
{
    const double position = golden::number(command, "position", NAN);
    const double counted = std::trunc(position / kCount) * kCount;
    return {.position = std::isnan(position) ? std::nullopt : std::optional(counted),
            .velocity = golden::number(command, "velocity", 0.0)};
}

PositionBounds boundsOf(const QJsonObject& vector)
{
    PositionBounds bounds;
    const double min = golden::number(vector, "position_min", NAN);
    const double max = golden::number(vector, "position_max", NAN);
    bounds.min = std::isnan(min) ? bounds.min : min;
    bounds.max = std::isnan(max) ? bounds.max : max;
    return bounds;
}

struct Played
{
    double positionError = 0.0;
    double velocityError = 0.0;
    double peakSpeed = 0.0;
    std::optional<double> doneAt;  // first completion after the last command
};

class Player
{
public:
    Player(const QJsonObject& vector, double dt)
        : m_commands(vector[QLatin1String("commands")].toArray()),
          m_samples(vector[QLatin1String("samples")].toArray()),
          m_resend(golden::number(vector, "resend_period_s", 0.0)),
          m_bounds(boundsOf(vector)),
          m_dt(dt)
    {
        m_planner.capture(golden::number(vector, "start_position", 0.0), golden::number(vector, "start_velocity", 0.0));
    }

    Played play()
    {
        const double end = m_samples.last().toArray()[0].toDouble();
        for (int step = 0; step * m_dt <= end; ++step) {
            const double time = step * m_dt;
            command(time);
            const ControlState before = m_planner.state();
            m_planner.step(m_dt, m_limits, m_bounds);
            record(time + m_dt);
            compare(time, before);
        }
        return m_played;
    }

private:
    void command(double time)
    {
        if (m_next < m_commands.size() && m_commands[m_next].toObject()[QLatin1String("t")].toDouble() <= time + 1e-9) {
            m_current = m_commands[m_next++].toObject();
            m_played.doneAt.reset();
            m_lastSent = -1.0;
        }
        const bool due = m_lastSent < 0.0 || (m_resend > 0.0 && time >= m_lastSent + m_resend - 1e-9);
        if (due) {
            m_limits = limitsOf(m_current);
            m_planner.setTarget(targetOf(m_current), 0.0);
            m_lastSent = time;
        }
    }
    void record(double time)
    {
        const ControlState& now = m_planner.state();
        m_played.peakSpeed = std::max(m_played.peakSpeed, std::abs(now.velocity));
        if (now.complete && !m_played.doneAt && m_next == m_commands.size()) {
            m_played.doneAt = time;
        }
    }
    // The drive's sample is taken within its own short step, so the nearer end of the simulator's step is compared.
    void compare(double time, const ControlState& before)
    {
        while (m_sample < m_samples.size() && m_samples[m_sample].toArray()[0].toDouble() < time + m_dt - 1e-9) {
            const QJsonArray sample = m_samples[m_sample++].toArray();
            const auto off = [&](int column, double one, double other) {
                const double expected = sample[column].toDouble();
                return std::min(std::abs(one - expected), std::abs(other - expected));
            };
            const ControlState& after = m_planner.state();
            m_played.positionError = std::max(m_played.positionError, off(1, before.position, after.position));
            m_played.velocityError = std::max(m_played.velocityError, off(2, before.velocity, after.velocity));
        }
    }

    TrajectoryPlanner m_planner;
    QJsonArray m_commands;
    QJsonArray m_samples;
    double m_resend;
    PositionBounds m_bounds;
    double m_dt;
    TrajectoryLimits m_limits;
    QJsonObject m_current;
    int m_next = 0;
    int m_sample = 0;
    double m_lastSent = -1.0;
    Played m_played;
};

// At the drive's own rate and at the coarse rate of the simulator. The vectors suggest 0.002 turns, acceleration times
// step and 10 ms. Here the position tolerance is four times smaller. The drive overshoots a target by about one count
// and turns back. This causes a velocity of sqrt(2·a·count) for a few sqrt(2·count/a) of time.
class TrajectoryGolden : public testing::TestWithParam<double>
{};

// REQ-SIM-01 (TrajectoryGolden.*): Control trajectories agree with the firmware within 0.0005 turns, at 30 kHz and at 1
// kHz.
TEST_P(TrajectoryGolden, FollowsTheFirmware)
{
    const double dt = GetParam();
    for (const QJsonValue& value : golden::vectors("trajectories")) {
        const QJsonObject vector = value.toObject();
        SCOPED_TRACE(vector[QLatin1String("name")].toString().toStdString());
        const Played played = Player(vector, dt).play();
        double acceleration = 0.0;
        for (const QJsonValue& command : vector[QLatin1String("commands")].toArray()) {
            const double limit = limitsOf(command.toObject()).acceleration;
            acceleration = std::max(acceleration, std::isfinite(limit) ? limit : 0.0);
        }
        const double tolerance = acceleration * std::max(dt, 1e-3) + 2.0 * std::sqrt(2.0 * acceleration * kCount);
        const double turningBack = acceleration > 0.0 ? 3.0 * std::sqrt(2.0 * kCount / acceleration) : 0.0;
        EXPECT_LT(played.positionError, 5e-4);
        EXPECT_LE(played.velocityError, tolerance);
        EXPECT_NEAR(played.peakSpeed, vector[QLatin1String("peak_speed")].toDouble(), tolerance);
        if (vector[QLatin1String("done_at_s")].isNull()) {
            EXPECT_FALSE(played.doneAt.has_value());
        } else {
            ASSERT_TRUE(played.doneAt.has_value());
            EXPECT_NEAR(*played.doneAt, vector[QLatin1String("done_at_s")].toDouble(), 0.01 + turningBack);
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Rates, TrajectoryGolden, testing::Values(1.0 / 30000.0, 1.0 / 1000.0),
                         [](const auto& rate) { return rate.param < 1e-3 ? "At30kHz" : "At1kHz"; });

// From standstill to standstill takes d/v + v/a.
TEST(TrajectoryPlanner, CoarseStepsKeepTheClosedFormTime)
{
    for (const double dt : {1.0e-2, 1.0e-3, 1.0e-4}) {
        TrajectoryPlanner planner;
        planner.capture(0.0, 0.0);
        planner.setTarget({.position = 1.0, .velocity = 0.0}, 0.0);
        double time = 0.0;
        while (!planner.state().complete && time < 20.0) {
            planner.step(dt, {.velocity = 0.2, .acceleration = 0.5}, {});
            time += dt;
            ASSERT_LE(std::abs(planner.state().velocity), 0.2 + 1e-12);
            ASSERT_LE(std::abs(planner.state().acceleration), 0.5 * (1.0 + 1.0 / (30000.0 * dt)));
        }
        EXPECT_NEAR(time, 1.0 / 0.2 + 0.2 / 0.5, 2.0 * dt + 3.0 / 30000.0);
        EXPECT_NEAR(planner.state().position, 1.0, kCount) << "the device sees whole counts";
    }
}

TEST(TrajectoryPlanner, TheLineStartsWhenTheCommandArrived)
{
    TrajectoryPlanner planner;
    planner.capture(0.0, 0.1);
    planner.setTarget({.position = 0.0, .velocity = 0.1}, 0.0008);
    for (int i = 0; i < 1000; ++i) {
        planner.step(1e-3, {.velocity = 1.0, .acceleration = 10.0}, {});
    }
    EXPECT_NEAR(planner.state().position, 0.1 * 1.0008, kCount);
}

// The values of the firmware's own planner (commit db1a7623) with the same commands: 5.3°/s² rms, at the limit for 12 %
// of the time. Rounding the distance to whole counts is essential: without it this is 14.5°/s².
// REQ-SIM-300: A planner that gets a position and a velocity every 20 ms, half a millisecond early or late, switches
// its acceleration as the firmware does.
TEST(TrajectoryPlanner, OrdersEarlyOrLateMakeItSwitchAsTheFirmware)
{
    constexpr double kDegree = 1.0 / 360.0;
    std::mt19937 random(1);
    std::uniform_real_distribution<double> late(-0.5e-3, 0.5e-3);
    TrajectoryPlanner planner;
    planner.capture(0.0, 2.0 * kDegree);
    double squares = 0.0;
    int atLimit = 0;
    constexpr int kSteps = 20 * 30000;
    int sent = 0;
    double next = 0.0;
    for (int step = 0; step < kSteps; ++step) {
        if (step / 30000.0 >= next) {
            const double place = std::floor(sent * 0.02 * 2.0 * kDegree / kCount) * kCount;
            planner.setTarget({.position = place, .velocity = 2.0 * kDegree}, 0.0);
            next = ++sent * 0.02 + late(random);
        }
        planner.step(1.0 / 30000.0, {.velocity = 15.0 * kDegree, .acceleration = 15.0 * kDegree}, {});
        const double acceleration = planner.state().acceleration / kDegree;
        squares += acceleration * acceleration;
        atLimit += std::abs(acceleration) > 14.7 ? 1 : 0;
    }
    EXPECT_NEAR(std::sqrt(squares / kSteps), 5.3, 0.3);
    EXPECT_NEAR(100.0 * atLimit / kSteps, 12.0, 2.0);
}

}  // namespace
}  // namespace boresight::sim
