// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/moteus_mount/moteus_connection.h"
#include "core/sim_bus/simulated_link.h"
#include "core/station/station.h"
#include "tests/core/mqtt/mqtt_rig.h"
#include "tests/fakes/mqtt_test.h"

#include <QTemporaryDir>

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <string>
#include <utility>
#include <vector>

// A whole Station with simulated drives, the real mosquitto, and a client that reads what the station publishes.
namespace boresight {

inline profile::Profile publishing(std::uint16_t port)
{
    profile::Profile profile;
    profile.rotctld.listen.port = 0;
    profile.mqtt.host = "127.0.0.1";
    profile.mqtt.port = port;
    profile.mqtt.publish = profile::Publish::On;
    return profile;
}

class StationBrokerTest : public fakes::MqttTest
{
protected:
    void prepare() override
    {
        ASSERT_TRUE(startBroker());
        logger.client.subscribe(QStringLiteral("boresight/#"));
        logger.client.open(mqtt::onLoopback(broker->port()));
        ASSERT_TRUE(logger.connected());
    }
    void build(const profile::Profile& profile)
    {
        station = std::make_unique<Station>(
            profile, moteusRotator(std::make_unique<SimulatedLink>(clock), {stateDir.path(), Simulation::Reference}),
            stateDir.path(), clock);
        link = station->findChild<SimulatedLink*>();
        QObject::connect(station.get(), &Station::updated, station.get(), [this](const StationUpdate& update) {
            for (const LogEntry& entry : update.log) {
                if (entry.source == QLatin1String("mqtt")) {
                    log.push_back(entry.text.toStdString());
                }
            }
            station->updateTaken();
        });
        station->openAll();
    }
    void run(int ticks)
    {
        for (int i = 0; i < ticks; ++i) {
            clock.advance(Seconds(0.02));
            link->deliver();
            station->tick();
            station->publish();
        }
    }
    [[nodiscard]] bool connected() const
    {
        return fakes::waitUntil([this] { return station->status().broker.connected; });
    }
    // Runs the station until a message of this topic contains `part`. Returns everything received since the last call.
    std::vector<QByteArray> heardUntil(const QString& topic, const QByteArray& part)
    {
        const auto isIt = [&](const mqtt::Message& message) {
            return message.topic == topic && message.payload.contains(part);
        };
        EXPECT_TRUE(fakes::waitUntil([&] { return std::ranges::any_of(logger.messages, isIt); })) << part.toStdString();
        std::vector<QByteArray> all;
        for (const mqtt::Message& message : std::exchange(logger.messages, {})) {
            if (message.topic == topic) {
                all.push_back(message.payload);
            }
        }
        return all;
    }

    const QString kState = QStringLiteral("boresight/state");
    const QString kAvailability = QStringLiteral("boresight/availability");
    mqtt::Rig logger;
    fakes::ManualClock clock;
    QTemporaryDir stateDir;
    SimulatedLink* link = nullptr;
    std::unique_ptr<Station> station;
    std::vector<std::string> log;
};

}  // namespace boresight
