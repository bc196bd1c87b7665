// SPDX-License-Identifier: GPL-3.0-or-later
// With real sockets.
#include "core/udp_server/datagram_server.h"

#include "core/udp_server/pst_words.h"
#include "tests/fakes/dummy_rotator.h"
#include "tests/fakes/manual_clock.h"
#include "tests/fakes/wait_until.h"

#include <QUdpSocket>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>

namespace boresight::udp {
namespace {

using namespace std::chrono_literals;

// Every address of 127.0.0.0/8 is this computer, and another host to the server.
const QHostAddress kHost(QStringLiteral("127.0.0.1"));
const QHostAddress kOtherHost(QStringLiteral("127.0.0.2"));

struct DatagramServerTest : ::testing::Test
{
    void serve(rotctld::ServerSettings settings = {})
    {
        settings.port = 0;
        settings.protocol = "PstRotator";
        settings.allowKey = "listeners.list";
        server = std::make_unique<DatagramServer>(settings, parsePst, rotator, clock, isReadOnly);
        ASSERT_TRUE(server->listen());
    }
    void send(QUdpSocket& from, const QByteArray& bytes) const
    {
        ASSERT_EQ(from.writeDatagram(bytes, kHost, server->port()), bytes.size());
    }
    [[nodiscard]] bool isMovedBy(QUdpSocket& from, int degrees)
    {
        send(from, "<PST><AZIMUTH>" + QByteArray::number(degrees) + "</AZIMUTH></PST>");
        return fakes::waitUntil(
            [&] { return rotator.lastRequest && rotator.lastRequest->azimuth == Angle::fromDegrees(degrees); });
    }
    void run(std::chrono::seconds time)
    {
        for (auto past = 0s; past < time; past += 1s) {
            clock.advance(1s);
            server->tick();
        }
    }

    fakes::ManualClock clock;
    fakes::DummyRotator rotator{clock};
    std::set<std::uint64_t> marked;  // as read-only
    IsReadOnly isReadOnly = [this](std::uint64_t client) { return marked.contains(client); };
    std::unique_ptr<DatagramServer> server;
    QUdpSocket program;
};

// REQ-UDPSERVER-06: A host is one client, from whatever port it sends. It is in the list with its last command.
TEST_F(DatagramServerTest, AHostIsOneClient)
{
    serve();
    EXPECT_EQ(server->address(), "UDP 127.0.0.1:" + std::to_string(server->port()));
    QUdpSocket later;
    QUdpSocket other;
    ASSERT_TRUE(program.bind(kHost) && later.bind(kHost) && other.bind(kOtherHost));
    EXPECT_TRUE(isMovedBy(program, 10));
    EXPECT_TRUE(isMovedBy(later, 20));
    EXPECT_TRUE(isMovedBy(other, 30));
    const auto clients = server->clients();
    ASSERT_EQ(clients.size(), 2U);
    EXPECT_EQ(clients[0].address, "127.0.0.1:" + std::to_string(program.localPort()));
    EXPECT_EQ(clients[0].program, "PstRotator");
    EXPECT_EQ(clients[0].lastCommand, QStringLiteral("<PST><AZIMUTH>20</AZIMUTH></PST>"));
    EXPECT_TRUE(clients[0].lastMotion);
    EXPECT_EQ(rotator.connected.size(), 2U);
}

// REQ-UDPSERVER-07: A question is answered to its host, at the port after that of the listener.
TEST_F(DatagramServerTest, AnswersAtThePortAfterItsOwn)
{
    QUdpSocket answers;
    for (int tries = 0; tries < 20 && answers.state() != QAbstractSocket::BoundState; ++tries) {
        serve();
        static_cast<void>(answers.bind(kHost, static_cast<quint16>(server->port() + 1)));
    }
    ASSERT_EQ(answers.state(), QAbstractSocket::BoundState);
    send(program, "<PST>AZ?</PST>");
    ASSERT_TRUE(fakes::waitUntil([&] { return answers.hasPendingDatagrams(); }));
    QByteArray answer(100, ' ');
    answer.resize(answers.readDatagram(answer.data(), answer.size()));
    EXPECT_EQ(answer, "AZ:0.0\r");
}

// REQ-UDPSERVER-08: Each datagram of a host that is not in the list of the listener is dropped without an answer, a
// stop too.
TEST_F(DatagramServerTest, AHostThatMayNotIsNoClient)
{
    serve({.allow = {"127.0.0.2"}});
    QUdpSocket other;
    ASSERT_TRUE(program.bind(kHost) && other.bind(kOtherHost));
    send(program, "<PST><AZIMUTH>10</AZIMUTH></PST>");
    send(program, "<PST><STOP>1</STOP></PST>");
    send(program, "<PST>AZ?</PST>");
    EXPECT_TRUE(isMovedBy(other, 30)) << "sent later, so the others have been read";
    EXPECT_EQ(rotator.actions, 1);
    EXPECT_EQ(server->clients().size(), 1U);
    EXPECT_EQ(rotator.questions, 0);
    ASSERT_EQ(rotator.remarks.size(), 3U);
    EXPECT_EQ(rotator.remarks[0], "refused: its address is not permitted (listeners.list)");
}

// REQ-UDPSERVER-13: There are at most as many clients as the profile permits. A stop of a further permitted host is
// obeyed.
TEST_F(DatagramServerTest, ACrowdIsBounded)
{
    serve({.maxClients = 1});
    QUdpSocket other;
    ASSERT_TRUE(program.bind(kHost) && other.bind(kOtherHost));
    EXPECT_TRUE(isMovedBy(program, 10));
    send(other, "<PST><AZIMUTH>30</AZIMUTH></PST>");
    EXPECT_TRUE(isMovedBy(program, 20));
    EXPECT_EQ(rotator.actions, 2);
    send(other, "<PST><STOP>1</STOP></PST>");
    ASSERT_TRUE(fakes::waitUntil([this] { return rotator.actions == 3; })) << "a stop needs no room";
    EXPECT_EQ(server->clients().size(), 1U);
    run(DatagramServer::kSilence + 1s);
    EXPECT_TRUE(isMovedBy(other, 30)) << "the first has left";
}

// REQ-UDPSERVER-09: A host that is silent for 60 s is not a client any more. Its next datagram makes it a new client.
TEST_F(DatagramServerTest, ASilentHostLeaves)
{
    serve();
    EXPECT_TRUE(isMovedBy(program, 10));
    const std::uint64_t id = server->clients().front().id;
    run(DatagramServer::kSilence);
    EXPECT_EQ(server->clients().size(), 1U);
    run(1s);
    EXPECT_TRUE(server->clients().empty());
    EXPECT_EQ(rotator.gone.at(id), "was silent for 60 s");
    EXPECT_TRUE(isMovedBy(program, 20));
    EXPECT_GT(server->clients().front().id, id);
}

TEST_F(DatagramServerTest, TheOperatorSendsAClientAway)
{
    serve();
    EXPECT_TRUE(isMovedBy(program, 10));
    const std::uint64_t id = server->clients().front().id;
    EXPECT_FALSE(server->disconnect(id + 1, QStringLiteral("by the operator")));
    EXPECT_TRUE(server->disconnect(id, QStringLiteral("by the operator")));
    EXPECT_EQ(rotator.gone.at(id), "by the operator");
    EXPECT_TRUE(server->clients().empty());
}

// REQ-UDPSERVER-14: A client that the operator made read-only stays a client while it is silent, and after Disconnect,
// because a new client of its host could move the mount. The right "read" of a listener keeps no client.
TEST_F(DatagramServerTest, AReadOnlyClientStays)
{
    serve();
    EXPECT_TRUE(isMovedBy(program, 10));
    const std::uint64_t id = server->clients().front().id;
    marked.insert(id);
    run(DatagramServer::kSilence * 2);
    EXPECT_TRUE(server->disconnect(id, QStringLiteral("by the operator")));
    EXPECT_TRUE(rotator.gone.empty());
    ASSERT_EQ(rotator.remarks.size(), 1U);
    EXPECT_TRUE(rotator.remarks[0].starts_with("is not disconnected, because it is read-only."));
    EXPECT_EQ(server->clients().front().id, id);
    marked.clear();
    run(1s);
    EXPECT_TRUE(server->clients().empty());

    isReadOnly = [](std::uint64_t) { return true; };
    serve({.readsOnly = true});
    EXPECT_TRUE(isMovedBy(program, 20));
    run(DatagramServer::kSilence + 1s);
    EXPECT_TRUE(server->clients().empty());
}

// REQ-UDPSERVER-10: A datagram that is no command, or is longer than 512 bytes, moves nothing. The log has each one,
// and the list of clients the last one.
TEST_F(DatagramServerTest, AnUnknownDatagramIsLogged)
{
    serve();
    const QByteArray tooLong = "<PST><AZIMUTH>10</AZIMUTH></PST>" + QByteArray(500, ' ') + "</PST>";
    for (const QByteArray& bytes : {QByteArray("GET / HTTP/1.1\r\n"), QByteArray("\x80\x01\x02"), QByteArray(),
                                    QByteArray("<PST><QRA>KN34BJ</QRA></PST>"), QByteArray(2000, 'x'), tooLong}) {
        send(program, bytes);
    }
    ASSERT_TRUE(
        fakes::waitUntil([this] { return !server->clients().empty() && server->clients().front().oddCommands == 5; }));
    EXPECT_EQ(rotator.actions, 0);
    ASSERT_EQ(rotator.remarks.size(), 5U);
    EXPECT_EQ(rotator.remarks[0], "\"GET / HTTP/1.1\" refused: This is no datagram for PstRotator.");
    EXPECT_THAT(server->clients().front().lastCommand.toStdString(),
                ::testing::HasSubstr("refused. A datagram has at most 512 bytes."));
    EXPECT_TRUE(isMovedBy(program, 20)) << "it is served on";
}

// However long it is.
// REQ-UDPSERVER-02
TEST_F(DatagramServerTest, AStopCountsInTheLongestDatagram)
{
    serve();
    send(program, QByteArray(65'507 - 14, 'x') + "<STOP>1</STOP>");
    ASSERT_TRUE(fakes::waitUntil([this] { return rotator.actions == 1; }));
    EXPECT_FALSE(rotator.lastRequest) << "a stop";
}

// REQ-UDPSERVER-11: A flood is read 32 datagrams at a time. The event loop goes on meanwhile, and stops of another host
// come through.
TEST_F(DatagramServerTest, AFloodIsReadABatchAtATime)
{
    serve();
    QUdpSocket other;
    ASSERT_TRUE(program.bind(kHost) && other.bind(kOtherHost));
    const auto sendMoreThanABatch = [&] {
        for (int i = 0; i < 2 * DatagramServer::kAtOnce; ++i) {
            send(program, "<PST>AZ?</PST>");
            if (i == DatagramServer::kAtOnce / 4) {
                send(other, "<PST><STOP>1</STOP></PST>");
            }
        }
    };
    int most = 0;
    int seen = 0;
    ASSERT_TRUE(fakes::waitUntil([&] {
        most = std::max(most, rotator.questions - std::exchange(seen, rotator.questions));
        sendMoreThanABatch();
        return rotator.questions >= 300 && rotator.stops >= 3;
    }));
    EXPECT_LE(most, DatagramServer::kAtOnce);
}

// The datagrams waited at the port meanwhile.
// REQ-UDPSERVER-12
TEST_F(DatagramServerTest, MovesNothingAfterTheThreadWasBlocked)
{
    serve();
    EXPECT_TRUE(isMovedBy(program, 10));
    clock.advance(5s);
    send(program, "<PST><AZIMUTH>20</AZIMUTH></PST>");
    send(program, "<PST><STOP>1</STOP></PST>");
    ASSERT_TRUE(fakes::waitUntil([this] { return rotator.actions == 2; })) << "the stop";
    EXPECT_EQ(rotator.lastRequest->azimuth, 10_deg);
    EXPECT_EQ(rotator.remarks.size(), 1U);
    run(2s);
    EXPECT_TRUE(isMovedBy(program, 20));
}

TEST_F(DatagramServerTest, MovesNothingAfterTheComputerSlept)
{
    serve();
    clock.sleep(30min);
    server->tick();
    send(program, "<PST><AZIMUTH>20</AZIMUTH></PST>");
    ASSERT_TRUE(fakes::waitUntil([this] { return !rotator.remarks.empty(); }));
    EXPECT_EQ(rotator.actions, 0);
    run(2s);
    EXPECT_TRUE(isMovedBy(program, 20));
}

TEST_F(DatagramServerTest, AllAddressesAreThoseOfBothVersions)
{
    serve({.host = "::", .allow = {"127.0.0.1", "::1"}});
    EXPECT_TRUE(isMovedBy(program, 10)) << "IPv4";
    EXPECT_TRUE(server->clients().front().address.starts_with("127.0.0.1:"));
    if (QUdpSocket sixth; sixth.bind(QHostAddress(QHostAddress::LocalHostIPv6))) {
        sixth.writeDatagram("<PST><AZIMUTH>20</AZIMUTH></PST>", QHostAddress(QHostAddress::LocalHostIPv6),
                            server->port());
        EXPECT_TRUE(fakes::waitUntil([&] { return rotator.lastRequest->azimuth == 20_deg; }));
    }
}

TEST_F(DatagramServerTest, APortThatIsTakenIsAnError)
{
    serve();
    DatagramServer second({.port = server->port(), .protocol = "PstRotator"}, parsePst, rotator, clock, isReadOnly);
    const Result<> refused = second.listen();
    ASSERT_FALSE(refused);
    EXPECT_TRUE(refused.error().text.contains(QString::number(server->port())));
    EXPECT_EQ(second.address(), "");
    EXPECT_TRUE(isMovedBy(program, 10)) << "the first serves on";
}

TEST_F(DatagramServerTest, ItsEndIsThatOfItsClients)
{
    serve();
    EXPECT_TRUE(isMovedBy(program, 10));
    server.reset();
    EXPECT_EQ(rotator.gone.size(), 1U);
}

}  // namespace
}  // namespace boresight::udp
