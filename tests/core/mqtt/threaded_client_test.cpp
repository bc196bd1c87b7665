// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mqtt/threaded_client.h"

#include "core/base/file_descriptor.h"
#include "core/mqtt/client_worker.h"
#include "tests/core/mqtt/mqtt_rig.h"
#include "tests/fakes/mqtt_test.h"

#include <QSignalSpy>

#include <arpa/inet.h>
#include <gmock/gmock.h>
#include <sys/socket.h>

namespace boresight::mqtt {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

const QString kThreadedClientTopic = QStringLiteral("antenna/orientation");

struct ThreadedRig
{
    ThreadedRig()
    {
        QObject::connect(&client, &Connection::connected, &client, [this] { ++connections; });
        QObject::connect(&client, &Connection::problemChanged, &client,
                         [this](const QString& text) { problems.push_back(text.toStdString()); });
        QObject::connect(&client, &Connection::messageReceived, &client,
                         [this](const QString& topic, const QByteArray& payload, Retain retain) {
                             messages.push_back({.topic = topic, .payload = payload, .retain = retain});
                         });
    }
    [[nodiscard]] bool connected() const
    {
        return fakes::waitUntil([this] { return client.isConnected(); });
    }
    [[nodiscard]] bool received(std::size_t count) const
    {
        return fakes::waitUntil([this, count] { return messages.size() >= count; });
    }

    fakes::ManualClock clock;
    ThreadedClient client{clock};
    int connections = 0;
    std::vector<std::string> problems;
    std::vector<Message> messages;
};

// A broker of blocking system calls. It serves a client without the event loop of this thread.
class BlockingBroker
{
public:
    BlockingBroker() : m_listener(socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0))
    {
        sockaddr_in address{};
        address.sin_family = AF_INET;
        address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
        auto* const generic = reinterpret_cast<sockaddr*>(&address);
        EXPECT_EQ(bind(m_listener.number(), generic, sizeof address), 0);
        EXPECT_EQ(listen(m_listener.number(), 1), 0);
        socklen_t size = sizeof address;
        EXPECT_EQ(getsockname(m_listener.number(), generic, &size), 0);
        m_port = ntohs(address.sin_port);
        giveUpAfter(m_listener);
    }
    [[nodiscard]] std::uint16_t port() const { return m_port; }
    void takeVisitor()
    {
        m_visitor = FileDescriptor(accept4(m_listener.number(), nullptr, nullptr, SOCK_CLOEXEC));
        ASSERT_TRUE(m_visitor.isOpen());
        giveUpAfter(m_visitor);
    }
    // The type of the next packet, which must be short.
    [[nodiscard]] int nextPacket() const
    {
        std::array<unsigned char, 2> header{};
        if (recv(m_visitor.number(), header.data(), header.size(), MSG_WAITALL) != 2) {
            return -1;
        }
        std::array<char, 127> rest{};
        EXPECT_EQ(recv(m_visitor.number(), rest.data(), header[1], MSG_WAITALL), header[1]);
        return header[0];
    }
    void send(const std::string& bytes) const
    {
        EXPECT_EQ(::send(m_visitor.number(), bytes.data(), bytes.size(), MSG_NOSIGNAL),
                  static_cast<ssize_t>(bytes.size()));
    }

private:
    static void giveUpAfter(const FileDescriptor& descriptor)
    {
        const timeval limit{.tv_sec = 10, .tv_usec = 0};
        setsockopt(descriptor.number(), SOL_SOCKET, SO_RCVTIMEO, &limit, sizeof limit);
    }

    FileDescriptor m_listener;
    FileDescriptor m_visitor;
    std::uint16_t m_port = 0;
};

constexpr int kConnect = 0x10;
constexpr int kSubscribe = 0x82;
constexpr int kDisconnect = 0xE0;

// REQ-MQTT-09d: The broker is served while the station's thread is busy, and the station never waits for the broker.
TEST(ThreadedClient, ServesTheBrokerWhileItsOwnerDoesNotRun)
{
    BlockingBroker broker;
    ThreadedRig rig;
    rig.client.subscribe(kThreadedClientTopic);
    rig.client.open(onLoopback(broker.port()));
    broker.takeVisitor();
    ASSERT_EQ(broker.nextPacket(), kConnect);
    broker.send(std::string("\x20\x02\0\0", 4));
    ASSERT_EQ(broker.nextPacket(), kSubscribe);
    EXPECT_FALSE(rig.client.isConnected()) << "its report is still on the way";
    ASSERT_TRUE(rig.connected());
    rig.client.close();
    EXPECT_FALSE(rig.client.isConnected());
    EXPECT_EQ(broker.nextPacket(), kDisconnect);
}

// With addresses only, because name look-ups are internal to Qt, and so are the reports of ThreadSanitizer about them.
// REQ-MQTT-09d
TEST(ThreadedClient, MayBeClosedInEveryPhase)
{
    const BlockingBroker silent;
    const auto isClosed = [&](std::uint16_t port) {
        ThreadedRig closed;
        closed.client.open(onLoopback(port));
        closed.client.close();
        ThreadedRig destroyed;
        destroyed.client.open(onLoopback(port));
        return !closed.client.isConnected() && !destroyed.client.isConnected();
    };
    EXPECT_TRUE(isClosed(silent.port()));
    EXPECT_TRUE(isClosed(1));  // where nothing listens
    ThreadedRig unused;
    unused.client.close();
    EXPECT_FALSE(unused.client.publish({.topic = kThreadedClientTopic, .payload = "x"}));
}

using MqttThreaded = fakes::MqttTest;

// REQ-MQTT-09f: Messages requested before the end are still sent: "offline" and the disconnect. Without a disconnect
// the broker sends the will.
TEST_F(MqttThreaded, DoesAllThatAClientDoes)
{
    ASSERT_TRUE(startBroker());
    Rig other;
    other.client.subscribe(QStringLiteral("boresight/#"));
    other.client.open(onLoopback(broker->port()));
    ASSERT_TRUE(other.connected());
    const Message will{.topic = QStringLiteral("boresight/end"), .payload = "will"};
    {
        ThreadedRig rig;
        rig.client.open(onLoopback(broker->port()), will);
        rig.client.subscribe(kThreadedClientTopic);
        rig.client.subscribe(QStringLiteral("elsewhere"));
        ASSERT_TRUE(rig.connected());
        EXPECT_EQ(rig.connections, 1);
        rig.client.unsubscribe(QStringLiteral("elsewhere"));
        ASSERT_TRUE(fakes::waitUntil([this] { return broker->count("Sending UNSUBACK") == 1; }));
        other.client.publish({.topic = QStringLiteral("elsewhere"), .payload = "not for us"});
        other.client.publish({.topic = kThreadedClientTopic, .payload = QByteArray(2 * kLargestMessage, 'x')});
        QSignalSpy dropped(&rig.client, &Connection::messageDropped);
        other.client.publish({.topic = kThreadedClientTopic, .payload = "12"});
        ASSERT_TRUE(rig.received(1));
        EXPECT_THAT(rig.messages, ElementsAre(Message{.topic = kThreadedClientTopic, .payload = "12"}));
        EXPECT_EQ(dropped.count(), 1);
        EXPECT_TRUE(rig.client.publish({.topic = QStringLiteral("boresight/state"), .payload = "1"}));
        ASSERT_TRUE(other.received(1));

        broker->kill();
        ASSERT_TRUE(fakes::waitUntil([&] { return rig.client.nextAttempt().has_value(); }));
        EXPECT_FALSE(rig.client.isConnected());
        EXPECT_THAT(rig.problems, ElementsAre(HasSubstr("The connection is lost")));
        ASSERT_TRUE(broker->start());
        ASSERT_TRUE(other.failed());
        other.letTimePass(RetryDelay::kLongest);
        rig.clock.advance(RetryDelay::kLongest);
        ASSERT_TRUE(rig.connected() && other.connected());
        EXPECT_EQ(rig.connections, 2);
        EXPECT_THAT(rig.problems.back(), IsEmpty());
        EXPECT_FALSE(rig.client.nextAttempt());
    }
    ASSERT_TRUE(other.received(2)) << "destroyed without close(): the broker sends the will";
    EXPECT_EQ(other.messages.back(), will);
    {
        ThreadedRig rig;
        rig.client.open(onLoopback(broker->port()), will);
        ASSERT_TRUE(rig.connected());
        rig.client.publish({.topic = QStringLiteral("boresight/end"), .payload = "goodbye"});
        rig.client.close();
    }
    ASSERT_TRUE(other.received(3));
    EXPECT_EQ(other.messages.back().payload, "goodbye") << "what was asked for before the end is done";
}

TEST_F(MqttThreaded, WithAnotherBrokerNothingOfTheOneBeforeIsReported)
{
    fakes::MqttBroker first;
    fakes::MqttBroker second;
    ASSERT_TRUE(first.start() && second.start());
    ThreadedRig rig;
    rig.client.open(onLoopback(first.port()));
    ASSERT_TRUE(rig.connected());
    rig.client.open(onLoopback(second.port()));
    EXPECT_FALSE(rig.client.isConnected()) << "with this one";
    ASSERT_TRUE(rig.connected());
    EXPECT_EQ(second.count("New client connected"), 1);
    EXPECT_EQ(rig.connections, 2);
    rig.client.open(onLoopback(second.port()));
    EXPECT_TRUE(rig.client.isConnected()) << "the same: it stays";
}

// The owner of the client takes no report meanwhile.
// REQ-MQTT-09c: Every 20 ms the station receives at most 32 messages and 64 kB, the newest ones. A flood never becomes
// a queue.
TEST_F(MqttThreaded, OfAFloodTheNewestAreReportedInOneReport)
{
    ASSERT_TRUE(startBroker());
    const fakes::ManualClock clock;
    ClientWorker worker(clock);
    std::vector<ClientReport> reports;
    QObject::connect(&worker, &ClientWorker::reported, [&](const ClientReport& report) { reports.push_back(report); });
    worker.keepUrgent([](const Message& message) { return message.payload == "7" ? Urgency::Stop : Urgency::None; });
    worker.client().subscribe(kThreadedClientTopic);
    worker.open(1, onLoopback(broker->port()), std::nullopt);
    Rig other;
    other.client.open(onLoopback(broker->port()));
    ASSERT_TRUE(other.connected());
    ASSERT_TRUE(fakes::waitUntil([this] { return broker->count("Sending SUBACK") == 1; }));
    const std::size_t before = reports.size();
    int arrived = 0;
    QObject::connect(&worker.client(), &BrokerClient::messageReceived, [&] { ++arrived; });
    for (int i = 0; i < 500; ++i) {
        ASSERT_TRUE(other.client.publish({.topic = kThreadedClientTopic, .payload = QByteArray::number(i)}));
    }
    ASSERT_TRUE(fakes::waitUntil([&] { return arrived == 500; }));
    EXPECT_EQ(reports.size(), before) << "the last one was not taken yet";
    worker.taken();
    ASSERT_TRUE(fakes::waitUntil([&] { return reports.size() > before; }));
    const auto& messages = reports.back().messages;
    ASSERT_EQ(messages.size(), NewestMessages::kMost);
    EXPECT_EQ(messages.back().payload, "499");
    EXPECT_EQ(messages.front().payload, "7") << "an urgent one";
    EXPECT_EQ(messages[1].payload, QByteArray::number(501 - static_cast<int>(NewestMessages::kMost)));
}

}  // namespace
}  // namespace boresight::mqtt
