// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"
#include "core/mqtt/threaded_client.h"
#include "core/transmit_output/transmit_output.h"

// A topic of an MQTT broker with the message "on" or "off". "off" is retained, and it is the will: the broker sends it
// when Boresight is gone without a word. "on" is never retained: who comes later must not find an old one. The
// connection is the output's own, because one connection has one will.
namespace boresight::transmit {

class BrokerOutput final : public TransmitOutput
{
    Q_OBJECT

public:
    // `clock` outlives the output and may be read by any thread.
    BrokerOutput(const mqtt::Broker& broker, const QString& topic, const Clock& clock, QObject* parent = nullptr);
    ~BrokerOutput() override;

    void set(bool on) override;

private:
    void publish();

    QString m_topic;
    bool m_wanted = false;
    mqtt::ThreadedClient m_client;
};

}  // namespace boresight::transmit
