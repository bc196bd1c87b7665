// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/messages/calibration_status.h"
#include "core/mqtt/broker_client.h"
#include "core/sim/simulated_sensor.h"
#include "tests/fakes/mqtt_test.h"
#include "tests/fakes/wait_until.h"
#include "tests/system/simulated_station.h"

#include <gmock/gmock.h>

#include <algorithm>

// The orientation sensor of a simulated mount sends through a real mosquitto to a whole station. The broker goes away
// and comes back. The clock stands still while messages are under way.
namespace boresight::system_test {
namespace {

using testing::HasSubstr;

profile::Profile heardBy(const fakes::MqttBroker& broker)
{
    profile::Profile profile = anyPort();
    profile.sensor.source = profile::SensorSource::Mqtt;
    profile.mqtt.host = "127.0.0.1";
    profile.mqtt.port = broker.port();
    return profile;
}

// The sensor box on the antenna: it measures every 0.2 s and publishes about once a second.
class PublishingSensor
{
public:
    PublishingSensor(SimulatedStation& rig, const fakes::MqttBroker& broker) : m_rig(rig), m_broker(broker)
    {
        m_client.open({.host = QStringLiteral("127.0.0.1"), .port = broker.port()});
    }

    void tick()
    {
        if (++m_ticks % 10 != 0) {
            return;
        }
        const auto message = m_sensor.read(m_rig.clock.now(), m_rig.clock.utc(), m_rig.truth());
        if (message && isHeard()) {
            const std::uint64_t before = accepted();
            publish(*message, "antenna/calibration", orientation::Topic::Calibration);
            publish(*message, "antenna/orientation", orientation::Topic::Orientation);
            EXPECT_TRUE(fakes::waitUntil([&] { return accepted() > before; }));
        }
    }

    // Both are connected to the broker, and the station has subscribed.
    [[nodiscard]] bool isHeard() const
    {
        return m_client.isConnected() && m_rig.status().broker.connected &&
               m_broker.count("Sending SUBACK to boresight-") >= 3;
    }
    // Advances the time until both are connected. Each attempt is completed before the next one.
    [[nodiscard]] bool findBroker(Seconds limit)
    {
        return m_rig.runUntil(
            [&] {
                m_client.service();
                EXPECT_TRUE(fakes::waitUntil([this] {
                    return isSettled(m_rig.status()) && (m_client.isConnected() || m_client.nextAttempt());
                }));
                const bool both = m_rig.status().broker.connected && m_client.isConnected();
                return both && fakes::waitUntil([this] { return isHeard(); });
            },
            limit);
    }

    // The station is connected, or waits for its next attempt.
    [[nodiscard]] static bool isSettled(const StationStatus& status)
    {
        return status.broker.connected || status.broker.retryIn.value_or(Seconds(0.0)) > Seconds(0.0);
    }

    [[nodiscard]] sim::SensorTruth& truth() { return m_sensor.truth(); }

private:
    [[nodiscard]] std::uint64_t accepted() const { return m_rig.status().sensor.counts.accepted; }
    void publish(const sim::SensorMessage& message, const char* topic, orientation::Topic kind)
    {
        EXPECT_TRUE(m_client.publish({.topic = QLatin1String(topic), .payload = sim::toPayload(message, kind)}));
    }

    SimulatedStation& m_rig;
    const fakes::MqttBroker& m_broker;
    sim::SimulatedSensor m_sensor;
    mqtt::BrokerClient m_client{m_rig.clock};
    int m_ticks = 0;
};

class MqttSensorTest : public fakes::MqttTest
{
protected:
    void prepare() override { broker = std::make_unique<fakes::MqttBroker>(); }

    // A mount that does not know north, half a minute into its swing.
    void swing()
    {
        ASSERT_TRUE(broker->start());
        rig = std::make_unique<SimulatedStation>(heardBy(*broker));
        sensor = std::make_unique<PublishingSensor>(*rig, *broker);
        sensor->truth().mount.azimuthOffset = 37.4_deg;
        sensor->truth().a1 = 8_deg;
        sensor->truth().b2 = 3_deg;
        sensor->truth().noise = 0.5_deg;
        rig->onTick = [this] { sensor->tick(); };
        ASSERT_TRUE(sensor->findBroker(Seconds(5.0)));
        ASSERT_EQ(rig->ask(request::TakeAuthority{}), "");
        ASSERT_EQ(rig->ask(request::PointAxes{{.azimuth = 60_deg, .elevation = 30_deg}}), "");
        ASSERT_TRUE(rig->settle());
        ASSERT_EQ(rig->ask(request::StartSwing{.rate = 5_deg_s, .headings = 0}), "");
        rig->run(Seconds(60.0));
        ASSERT_EQ(progress().run, CalibrationRun::Swing) << progress().outcome.toStdString();
    }
    void stopBroker()
    {
        broker->stop();
        ASSERT_TRUE(fakes::waitUntil([this] { return !rig->status().broker.connected; }));
    }
    [[nodiscard]] CalibrationProgress progress() const { return rig->status().calibration->progress; }

    std::unique_ptr<SimulatedStation> rig;
    std::unique_ptr<PublishingSensor> sensor;
};

// REQ-NORTH-42 (MqttSensorTest.*)
TEST_F(MqttSensorTest, ASwingWaitsForABrokerThatIsStartedAgain)
{
    swing();
    stopBroker();
    rig->run(Seconds(3.0));
    EXPECT_GT(abs(rig->link->truth(Axis::Azimuth).rate), 4_deg_s) << "a hiccup does not stop it";
    rig->run(Seconds(9.0));
    EXPECT_THAT(progress().text.toStdString(), HasSubstr("waiting for sensor data"));
    EXPECT_TRUE(
        rig->logSays(QStringLiteral("the swing pauses for at most 30 s: The orientation sensor has sent nothing for")));
    EXPECT_TRUE(rig->alarmSays(QStringLiteral("The orientation sensor (MQTT 127.0.0.1:")));
    EXPECT_EQ(rig->status().state, StationState::Calibrate);
    const AxisPosition rest = rig->truth();
    rig->run(Seconds(2.0));
    EXPECT_LT(rig->farthestFrom(rest), 0.01_deg);

    ASSERT_TRUE(broker->start());
    ASSERT_TRUE(sensor->findBroker(Seconds(15.0)));
    ASSERT_TRUE(rig->runUntil([this] { return progress().run == CalibrationRun::None; }, Seconds(200.0)));
    EXPECT_TRUE(rig->logSays(QStringLiteral("sensor data is back, and the swing continues")));
    const auto found = rig->status().calibration;
    ASSERT_TRUE(found->proposal) << found->progress.outcome.toStdString();
    ASSERT_EQ(rig->ask(request::ApplyCalibration{found->proposal->number}), "");
    EXPECT_NEAR(rig->status().profile->pointing.azimuthOffset.degrees(), 37.4, 2.0);
    rig->run(Seconds(5.0));
    EXPECT_FALSE(rig->status().sensor.disagrees);
    ASSERT_TRUE(rig->status().sensor.azimuthSigma);
    EXPECT_LT(*rig->status().sensor.azimuthSigma, 3_deg);
}

TEST_F(MqttSensorTest, ASwingEndsWithTheReasonWhereTheBrokerStaysAway)
{
    swing();
    stopBroker();
    rig->run(Seconds(40.0));
    EXPECT_EQ(progress().run, CalibrationRun::None);
    EXPECT_TRUE(progress().failed);
    EXPECT_THAT(progress().outcome.toStdString(), HasSubstr("The orientation sensor has sent nothing for"));
    EXPECT_THAT(progress().outcome.toStdString(), HasSubstr("MQTT broker 127.0.0.1:"));
    EXPECT_EQ(rig->status().state, StationState::Hold);
    const AxisPosition rest = rig->truth();
    EXPECT_THAT(rig->ask(request::StartSwing{}), HasSubstr("MQTT broker 127.0.0.1:"));

    ASSERT_TRUE(broker->start());
    ASSERT_TRUE(sensor->findBroker(Seconds(40.0)));
    rig->run(Seconds(5.0));
    EXPECT_LT(rig->farthestFrom(rest), 0.01_deg) << "nothing moves by itself";
    EXPECT_EQ(rig->ask(request::StartSwing{}), "");
}

// The positions of the antenna while a client tracks for half a minute.
std::vector<AxisPosition> tracked(SimulatedStation& rig)
{
    const auto client = rig.connect();
    std::vector<AxisPosition> places;
    for (int second = 0; second < 30; ++second) {
        const std::string point = "P " + std::to_string(60 + second) + " 30\n";
        EXPECT_EQ(client->ask(point), "RPRT 0\n");
        rig.run(Seconds(1.0));
        places.push_back(rig.truth());
    }
    return places;
}

// REQ-STATION-43: A broker that is missing at the start is one line in the log. The tracking is the same to the last
// digit.
TEST_F(MqttSensorTest, ABrokerThatIsNotThereAtTheStartIsOneLineAndTheTrackingDoesNotMindIt)
{
    rig = std::make_unique<SimulatedStation>(heardBy(*broker));  // the broker was not started
    ASSERT_TRUE(fakes::waitUntil([this] { return PublishingSensor::isSettled(rig->status()); }));
    const auto places = tracked(*rig);
    const QString trouble = QStringLiteral("MQTT broker 127.0.0.1:");
    EXPECT_TRUE(rig->logSays(trouble));
    const auto told =
        std::ranges::count_if(rig->log, [&](const LogEntry& entry) { return entry.text.startsWith(trouble); });
    EXPECT_EQ(told, 1);
    EXPECT_TRUE(rig->alarmSays(QStringLiteral("The orientation sensor (MQTT 127.0.0.1:")));
    SimulatedStation without;
    EXPECT_EQ(places, tracked(without));
}

}  // namespace
}  // namespace boresight::system_test
