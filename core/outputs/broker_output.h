// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"
#include "core/mqtt/threaded_client.h"
#include "core/outputs/output.h"

// Publishes "on" or "off" to a topic of an MQTT broker. "off" is retained. It is also the will: the broker publishes it
// when the connection to Boresight breaks. "on" is never retained, because a client that subscribes later must not
// receive an old "on". The output has a connection of its own, because an MQTT connection has only one will.
namespace boresight::outputs {

class BrokerOutput final : public Output
{
    Q_OBJECT

public:
    // `clock` must outlive the output and be readable from any thread.
    BrokerOutput(const mqtt::Broker& broker, const QString& topic, const Clock& clock, QObject* parent = nullptr);
    ~BrokerOutput() override;

    void set(bool on) override;

private:
    void publish();

    QString m_topic;
    bool m_wanted = false;
    mqtt::ThreadedClient m_client;
};

}  // namespace boresight::outputs
