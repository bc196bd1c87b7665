// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mqtt/ending.h"

#include <gtest/gtest.h>

#include <set>

namespace boresight::mqtt {
namespace {

constexpr EndKind kAll[] = {
    EndKind::NameUnknown,     EndKind::ConnectionFailed, EndKind::NoAnswer,         EndKind::Silent,
    EndKind::HungUp,          EndKind::TlsRefused,       EndKind::CertificateWrong, EndKind::ProtocolRefused,
    EndKind::ClientIdRefused, EndKind::NotServing,       EndKind::LoginRefused,     EndKind::Lost,
    EndKind::Ousted,          EndKind::NoPulse,          EndKind::Nonsense,         EndKind::Local};

const Broker kBroker{
    .host = QStringLiteral("shack"), .user = QStringLiteral("mount"), .clientId = QStringLiteral("b1")};

// Each end has one line, which names the broker, differs from all others and never shows the password.
// REQ-MQTT-03 (MqttEnding.*)
TEST(MqttEnding, EachHasALineOfItsOwn)
{
    Broker broker = kBroker;
    broker.password = QStringLiteral("s3cret");
    std::set<QString> lines;
    for (const EndKind kind : kAll) {
        const QString line = toText({.kind = kind, .detail = QStringLiteral("why")}, broker);
        EXPECT_TRUE(line.startsWith(QLatin1String("MQTT broker shack:1883: "))) << line.toStdString();
        EXPECT_FALSE(line.contains(QLatin1Char('\n'))) << line.toStdString();
        EXPECT_FALSE(line.contains(QLatin1String("s3cret"))) << line.toStdString();
        EXPECT_TRUE(lines.insert(line).second) << line.toStdString();
    }
}

TEST(MqttEnding, SaysWhatToDo)
{
    const auto line = [](EndKind kind, const Broker& broker = kBroker, const char* detail = "") {
        return toText({.kind = kind, .detail = QLatin1String(detail)}, broker).toStdString();
    };
    EXPECT_EQ(line(EndKind::LoginRefused),
              "MQTT broker shack:1883: The broker refuses the user \"mount\" or the password. Check mqtt.user and "
              "mqtt.password");
    Broker nobody = kBroker;
    nobody.user.clear();
    EXPECT_EQ(line(EndKind::LoginRefused, nobody),
              "MQTT broker shack:1883: A user name and a password are required. Set mqtt.user and mqtt.password");
    EXPECT_EQ(line(EndKind::ConnectionFailed, kBroker, "Connection refused"),
              "MQTT broker shack:1883: No connection (Connection refused). Is the broker running there?");
    Broker tls = kBroker;
    tls.encryption = Encryption::Tls;
    tls.host = QStringLiteral("::1");
    EXPECT_EQ(
        line(EndKind::HungUp, tls),
        "MQTT broker [::1]:1883: The port closes the connection before it answers. Is mqtt.port the TLS port of the "
        "broker?");
}

}  // namespace
}  // namespace boresight::mqtt
