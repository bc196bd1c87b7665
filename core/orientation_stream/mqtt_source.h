// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/clock.h"
#include "core/mqtt/connection.h"
#include "core/orientation/json_payload.h"
#include "core/orientation_stream/sensor_source.h"

#include <QTimer>

#include <optional>

// The sensor's messages from an MQTT broker. Another object opens the connection and shares it. This source only
// listens to three topics. It works without the last two, which newer firmware rarely sends. Station thread.
namespace boresight::orientation {

struct MqttTopics
{
    QString orientation = QStringLiteral("antenna/orientation");
    QString status = QStringLiteral("antenna/status");
    QString calibration = QStringLiteral("antenna/calibration");
    // Connected for this long without an orientation: then a problem is reported.
    std::chrono::milliseconds silence{5000};
};

class MqttSource final : public SensorSource
{
    Q_OBJECT

public:
    // `client` and `clock` must outlive the source.
    MqttSource(mqtt::Connection& client, const MqttTopics& topics, const Clock& clock, QObject* parent = nullptr);
    ~MqttSource() override;

    [[nodiscard]] QString name() const override;
    [[nodiscard]] const SourceStatus& status() const override { return m_status; }
    void open() override;
    void close() override;

private:
    void stopListening();
    void showConnection();
    void take(const QString& topic, const QByteArray& payload, mqtt::Retain retain);
    [[nodiscard]] std::optional<Topic> topicOf(const QString& name) const;
    void takeDenial(const QString& topic);
    void takeGrant(const QString& topic);
    [[nodiscard]] bool isDenied() const { return m_denied.contains(m_topics.orientation); }
    [[nodiscard]] QString denial() const;  // empty: nothing is denied
    void tellSilence();
    void showDenial();
    void show(bool open, const QString& problem);

    mqtt::Connection& m_client;
    MqttTopics m_topics;
    const Clock& m_clock;
    PayloadReader m_reader;
    QTimer m_silence;
    std::optional<Refused> m_refused;  // of the last message, if it was refused
    bool m_wanted = false;
    QStringList m_denied;       // topics that the broker denied on this connection
    bool m_denialTold = false;  // the status already shows the present denial, or that there is none
    SourceStatus m_status;
};

}  // namespace boresight::orientation
