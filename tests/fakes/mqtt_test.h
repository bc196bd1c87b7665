// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/fakes/mqtt_broker.h"

#include <gtest/gtest.h>

#include <memory>

// A test with the real mosquitto. It is skipped where mosquitto is not installed.
namespace boresight::fakes {

class MqttTest : public testing::Test
{
protected:
    using Door = MqttBroker::Door;

    void SetUp() final
    {
        if (!MqttBroker::isInstalled()) {
            GTEST_SKIP() << "no mosquitto, mosquitto_passwd or openssl (Debian packages mosquitto and openssl)";
        }
        prepare();
    }
    // Is called before each test of a fixture.
    virtual void prepare() {}

    // True when it listens.
    [[nodiscard]] bool startBroker(Door door = Door::Open)
    {
        broker = std::make_unique<MqttBroker>(door);
        return broker->start();
    }

    std::unique_ptr<MqttBroker> broker;
};

}  // namespace boresight::fakes
