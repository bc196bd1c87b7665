// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/sim/servo.h"
#include "tests/core/sim/golden_vectors.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace boresight::sim {
namespace {

struct Transition
{
    double time = 0.0;
    int mode = 0;
    int fault = 0;
};

ServoCommand commandOf(const QJsonObject& fields)
{
    ServoCommand command;
    command.mode = static_cast<moteus::Mode>(fields[QLatin1String("mode")].toInt());
    command.position = golden::number(fields, "position", 0.0);
    command.velocity = golden::number(fields, "velocity", 0.0);
    command.watchdogTimeout = golden::number(fields, "watchdog_timeout", 0.0);
    command.maximumTorque = golden::number(fields, "maximum_torque", 100.0);
    command.stopPosition = golden::number(fields, "stop_position", NAN);
    command.velocityLimit = golden::number(fields, "velocity_limit", NAN);
    command.accelerationLimit = golden::number(fields, "accel_limit", NAN);
    command.ignorePositionBounds = golden::number(fields, "ignore_position_bounds", 0.0) != 0.0;
    command.stayWithinLower = golden::number(fields, "lower_bound", 0.0);
    command.stayWithinUpper = golden::number(fields, "upper_bound", 0.0);
    return command;
}

void setCondition(ServoInputs& inputs, const QString& name, double value)
{
    if (name == QLatin1String("bus_V")) {
        inputs.busVoltage = value;
    } else if (name == QLatin1String("driver_fault")) {
        inputs.gateDriverFault = value != 0.0;
    } else if (name == QLatin1String("fet_temp_C")) {
        inputs.fetTemperature = value;
    } else if (name == QLatin1String("position")) {
        inputs.position = value;
    } else if (name == QLatin1String("position_valid")) {
        inputs.positionValid = value != 0.0;
    } else if (name == QLatin1String("theta_valid")) {
        inputs.commutationValid = value != 0.0;
    } else if (name == QLatin1String("encoder_error")) {
        inputs.encoderError = value != 0.0;
    } else {
        ADD_FAILURE() << "unknown condition " << name.toStdString();
    }
}

class SequencePlayer
{
public:
    SequencePlayer(const QJsonObject& vector, double dt) : m_events(vector[QLatin1String("events")].toArray()), m_dt(dt)
    {
        m_inputs = {.position = 0.1, .busVoltage = 24.0, .fetTemperature = 30.0};
        m_config.positionMin = kNone;
        m_config.positionMax = kNone;
        const QJsonObject config = vector[QLatin1String("config")].toObject();
        for (auto item = config.begin(); item != config.end(); ++item) {
            const std::string key = item.key().toStdString();
            if (key.find('.') == std::string::npos) {
                setCondition(m_inputs, item.key(), golden::number(item.value()));
            } else {
                EXPECT_TRUE(setConfigText(m_config, key, std::to_string(golden::number(item.value())))) << key;
            }
        }
    }

    std::vector<Transition> play(double end)
    {
        Servo servo(m_config);
        std::vector<Transition> seen{{0.0, 0, 0}};
        for (int step = 0; step * m_dt < end; ++step) {
            deliver(servo, step * m_dt);
            servo.step(m_dt, m_inputs);
            const int mode = static_cast<int>(servo.mode());
            if (mode != seen.back().mode || servo.faultCode() != seen.back().fault) {
                seen.push_back({step * m_dt, mode, servo.faultCode()});
            }
        }
        return seen;
    }

private:
    void deliver(Servo& servo, double time)
    {
        while (m_next < m_events.size() && m_events[m_next].toObject()[QLatin1String("t")].toDouble() <= time + 1e-9) {
            const QJsonObject event = m_events[m_next++].toObject();
            const QJsonObject conditions = event[QLatin1String("set")].toObject();
            for (auto item = conditions.begin(); item != conditions.end(); ++item) {
                setCondition(m_inputs, item.key(), golden::number(item.value()));
            }
            if (event.contains(QLatin1String("command"))) {
                servo.command(commandOf(event[QLatin1String("command")].toObject()));
            }
        }
    }

    QJsonArray m_events;
    double m_dt;
    DriveConfig m_config;
    ServoInputs m_inputs;
    int m_next = 0;
};

class ModeSequenceGolden : public testing::TestWithParam<double>
{};

// Modes and faults must be the same. Times may differ by two steps and by 0.1 ms, the rounding of the vectors.
// REQ-SIM-02 (ModeSequenceGolden.*): Modes and fault codes are those of the firmware, with times within two steps.
TEST_P(ModeSequenceGolden, ChangesModeLikeTheFirmware)
{
    const double dt = GetParam();
    for (const QJsonValue& value : golden::vectors("mode_sequences")) {
        const QJsonObject vector = value.toObject();
        SCOPED_TRACE(vector[QLatin1String("name")].toString().toStdString());
        const QJsonArray expected = vector[QLatin1String("transitions")].toArray();
        // 80 ms past the last change. This is longer than the 50 ms watchdogs that must not act, and shorter than the
        // next one that may act.
        const double end = expected.last().toArray()[0].toDouble() + 0.08;
        const std::vector<Transition> seen = SequencePlayer(vector, dt).play(end);
        ASSERT_EQ(seen.size(), static_cast<std::size_t>(expected.size()));
        for (std::size_t i = 0; i < seen.size(); ++i) {
            const QJsonArray transition = expected[static_cast<int>(i)].toArray();
            EXPECT_EQ(seen[i].mode, transition[1].toInt()) << "transition " << i;
            EXPECT_EQ(seen[i].fault, transition[2].toInt()) << "transition " << i;
            EXPECT_NEAR(seen[i].time, transition[0].toDouble(), 2.0 * dt + 1e-4) << "transition " << i;
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Rates, ModeSequenceGolden, testing::Values(1.0 / 30000.0, 1.0 / 1000.0),
                         [](const auto& rate) { return rate.param < 1e-3 ? "At30kHz" : "At1kHz"; });

}  // namespace
}  // namespace boresight::sim
