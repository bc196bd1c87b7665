// SPDX-License-Identifier: GPL-3.0-or-later
// The client when no broker accepts it. Other servers, played by the test, listen at its address. The event loop must
// not stop, because it also serves the drives with their watchdog of 100 ms.
#include "core/base/file_descriptor.h"
#include "tests/core/mqtt/mqtt_rig.h"

#include <QTcpServer>
#include <QTcpSocket>

#include <arpa/inet.h>
#include <gmock/gmock.h>
#include <sys/socket.h>

#include <functional>

namespace boresight::mqtt {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

// A port that listens and never accepts. Its queue is full, so the system drops new connections, as for an address
// without a host.
class DeafPort
{
public:
    DeafPort() : m_listener(newSocket())
    {
        sockaddr_in address{};
        address.sin_family = AF_INET;
        address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
        EXPECT_EQ(bind(m_listener.number(), generic(address), sizeof address), 0);
        EXPECT_EQ(listen(m_listener.number(), 0), 0);
        socklen_t size = sizeof address;
        EXPECT_EQ(getsockname(m_listener.number(), generic(address), &size), 0);
        m_port = ntohs(address.sin_port);
        for (FileDescriptor& visitor : m_visitors) {
            visitor = newSocket();
            static_cast<void>(::connect(visitor.number(), generic(address), sizeof address));
        }
    }
    [[nodiscard]] std::uint16_t port() const { return m_port; }

private:
    [[nodiscard]] static FileDescriptor newSocket()
    {
        return FileDescriptor(socket(AF_INET, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0));
    }
    [[nodiscard]] static sockaddr* generic(sockaddr_in& address) { return reinterpret_cast<sockaddr*>(&address); }

    FileDescriptor m_listener;
    std::array<FileDescriptor, 4> m_visitors;
    std::uint16_t m_port = 0;
};

// A server that accepts connections. The test decides what it does with what it reads.
class StandIn
{
public:
    using Behaviour = std::function<void(QTcpSocket& peer)>;

    explicit StandIn(
        Behaviour atOnce, Behaviour onData = [](QTcpSocket&) {})
    {
        EXPECT_TRUE(m_server.listen(QHostAddress::LocalHost));
        QObject::connect(&m_server, &QTcpServer::newConnection, &m_server, [this, atOnce, onData] {
            QTcpSocket* const peer = m_server.nextPendingConnection();
            QObject::connect(peer, &QTcpSocket::readyRead, peer, [peer, onData] { onData(*peer); });
            ++m_visits;
            atOnce(*peer);
        });
    }
    [[nodiscard]] std::uint16_t port() const { return m_server.serverPort(); }
    [[nodiscard]] bool visited() const
    {
        return fakes::waitUntil([this] { return m_visits > 0; });
    }

private:
    QTcpServer m_server;
    int m_visits = 0;
};

StandIn silent()
{
    return StandIn([](QTcpSocket&) {});
}

Broker encrypted(Broker broker)
{
    broker.encryption = Encryption::Tls;
    return broker;
}

std::uint16_t closedPort()
{
    QTcpServer server;
    EXPECT_TRUE(server.listen(QHostAddress::LocalHost));
    return server.serverPort();
}

// REQ-MQTT-02
// REQ-MQTT-03 (MqttConnecting.*)
TEST(MqttConnecting, AClosedPortIsToldWithAndWithoutTls)
{
    const Broker broker = onLoopback(closedPort());
    for (const Broker& one : {broker, encrypted(broker)}) {
        const auto stall = stallOf([&one](LoopWatch&) {
            Rig rig;
            rig.client.open(one);
            ASSERT_TRUE(rig.failed());
            EXPECT_THAT(rig.problems, ElementsAre(HasSubstr("No connection (Connection refused)")));
        });
        EXPECT_LT(stall, kLongestStall);
    }
}

// On most computers "localhost" is ::1 first.
// REQ-MQTT-05: Every address of a name is tried.
TEST(MqttConnecting, EveryAddressOfANameIsTried)
{
    StandIn broker([](QTcpSocket&) {},
                   [](QTcpSocket& peer) {
                       if (peer.readAll().startsWith('\x10')) {
                           peer.write(QByteArray("\x20\x02\0\0", 4));
                       }
                   });
    Rig rig;
    rig.client.open({.host = QStringLiteral("localhost"), .port = broker.port()});
    EXPECT_TRUE(rig.connected());
    EXPECT_THAT(rig.problems, IsEmpty());
}

void waitForTheUnreachable(const Broker& broker, LoopWatch& watch)
{
    Rig rig;
    rig.client.open(broker);
    EXPECT_LT(watch.turnsIn(std::chrono::milliseconds(300)), 1000) << "the loop runs hot";
    rig.letTimePass(Seconds(9));
    EXPECT_FALSE(rig.client.nextAttempt());
    rig.letTimePass(Seconds(1));
    ASSERT_TRUE(rig.client.nextAttempt());
    EXPECT_THAT(rig.problems, ElementsAre(HasSubstr("No answer. Check mqtt.host, the network and the firewall")));
    for (int i = 0; i < 3; ++i) {
        rig.letTimePass(RetryDelay::kLongest);
        EXPECT_FALSE(rig.client.nextAttempt());
        rig.letTimePass(Seconds(10));
        ASSERT_TRUE(rig.client.nextAttempt());
    }
    EXPECT_EQ(rig.problems.size(), 1U);
}

// REQ-MQTT-02: Whatever is at the other end, the event loop goes on: no gap of 50 ms, no busy loop.
TEST(MqttConnecting, AnUnreachableAddressDoesNotHoldTheLoopUp)
{
    const DeafPort port;
    const Broker broker = onLoopback(port.port());
    for (const Broker& one : {broker, encrypted(broker)}) {
        EXPECT_LT(stallOf([&one](LoopWatch& watch) { waitForTheUnreachable(one, watch); }), kLongestStall);
    }
}

// REQ-MQTT-02
TEST(MqttConnecting, SomebodyWhoSaysNothingIsGivenUp)
{
    const StandIn somebody = silent();
    const Broker broker = onLoopback(somebody.port());
    for (const Broker& one : {broker, encrypted(broker)}) {
        const auto stall = stallOf([&](LoopWatch& watch) {
            Rig rig;
            rig.client.open(one);
            ASSERT_TRUE(somebody.visited());
            EXPECT_LT(watch.turnsIn(std::chrono::milliseconds(300)), 1000) << "the loop runs hot";
            rig.letTimePass(Seconds(10));
            EXPECT_THAT(rig.problems, ElementsAre(HasSubstr("accepts the connection but does not answer")));
        });
        EXPECT_LT(stall, kLongestStall);
    }
}

// During a TLS handshake libmosquitto does not detect this.
TEST(MqttConnecting, SomebodyWhoHangsUpIsTold)
{
    const auto hangUp = [](QTcpSocket& peer) { peer.disconnectFromHost(); };
    const auto slam = [](QTcpSocket& peer) { peer.abort(); };
    for (const auto& [atOnce, onData] : {std::pair<StandIn::Behaviour, StandIn::Behaviour>(hangUp, hangUp),
                                         {[](QTcpSocket&) {}, hangUp},
                                         {[](QTcpSocket&) {}, slam}}) {
        const StandIn somebody(atOnce, onData);
        const Broker broker = onLoopback(somebody.port());
        for (const Broker& one : {broker, encrypted(broker)}) {
            Rig rig;
            rig.client.open(one);
            ASSERT_TRUE(rig.failed());
            EXPECT_THAT(rig.problems, ElementsAre(HasSubstr("Is mqtt.port")));
        }
    }
}

// A broker behind a proxy is found by the name in the TLS greeting, but libmosquitto only knows the address.
TEST(MqttConnecting, TheTlsGreetingSaysTheName)
{
    QByteArray greeting;
    const StandIn somebody([](QTcpSocket&) {}, [&greeting](QTcpSocket& peer) { greeting += peer.readAll(); });
    Rig rig;
    rig.client.open(encrypted({.host = QStringLiteral("localhost"), .port = somebody.port()}));
    ASSERT_TRUE(fakes::waitUntil([&] { return !greeting.isEmpty(); }));
    EXPECT_TRUE(greeting.contains("localhost"));
    EXPECT_FALSE(greeting.contains("127.0.0.1"));
}

TEST(MqttConnecting, ARefusalIsToldInWords)
{
    for (const auto& [code, words] : {std::pair{'\1', "refuses MQTT 3.1.1"},
                                      {'\2', "refuses the client id \"b1\""},
                                      {'\3', "is not available"},
                                      {'\4', "refuses the user"},
                                      {'\5', "refuses the user"},
                                      {'\6', "is not MQTT"}}) {
        const StandIn broker([](QTcpSocket&) {},
                             [code = code](QTcpSocket& peer) {
                                 peer.write(QByteArray("\x20\x02\0", 3) + code);
                                 peer.disconnectFromHost();
                             });
        Rig rig;
        Broker who = onLoopback(broker.port());
        who.clientId = QStringLiteral("b1");
        who.user = QStringLiteral("mount");
        rig.client.open(who);
        ASSERT_TRUE(rig.failed());
        EXPECT_THAT(rig.problems, ElementsAre(HasSubstr(words)));
    }
}

TEST(MqttConnecting, WhatIsNotMqttIsTold)
{
    const StandIn server([](QTcpSocket& peer) { peer.write(QByteArray(200, '\x20')); });
    Rig rig;
    rig.client.open(onLoopback(server.port()));
    ASSERT_TRUE(rig.failed());
    EXPECT_THAT(rig.problems, ElementsAre(HasSubstr("Is mqtt.port")));
}

TEST(MqttConnecting, ANameThatIsNoneIsTold)
{
    Rig rig;
    rig.client.open({.host = QStringLiteral("broker..example")});
    ASSERT_TRUE(rig.failed());
    EXPECT_THAT(rig.problems, ElementsAre(HasSubstr("The name cannot be resolved")));
}

// REQ-MQTT-09
TEST(MqttConnecting, ClosingEndsAnAttemptInEveryPhase)
{
    const DeafPort deaf;
    const StandIn somebody = silent();
    for (const Broker& broker : {onLoopback(deaf.port()), onLoopback(somebody.port()),
                                 Broker{.host = QStringLiteral("localhost"), .port = somebody.port()}}) {
        Rig rig;
        rig.client.open(broker);
        rig.client.close();
        rig.letTimePass(Seconds(60));
        EXPECT_FALSE(rig.client.nextAttempt());
        EXPECT_THAT(rig.problems, IsEmpty());
    }
}

}  // namespace
}  // namespace boresight::mqtt
