// SPDX-License-Identifier: GPL-3.0-or-later
// Real sockets on loopback; the clock is turned by hand.
#include "core/power/power_line.h"

#include "tests/fakes/manual_clock.h"
#include "tests/fakes/program.h"
#include "tests/fakes/unused_port.h"
#include "tests/fakes/wait_until.h"

#include <QTcpServer>

#include <gtest/gtest.h>

#include <algorithm>
#include <utility>
#include <vector>

namespace boresight::power {
namespace {

using fakes::waitUntil;

struct Ear
{
    explicit Ear(LineSettings settings) : line(settings, clock)
    {
        QObject::connect(&line, &PowerLine::received, [this](const Value& value) {
            values.push_back(value);
            ++m_helping;
        });
        QObject::connect(&line, &PowerLine::stateChanged,
                         [this] { m_longestHelping = std::max(m_longestHelping, std::exchange(m_helping, 0)); });
        line.open();
    }

    [[nodiscard]] bool hears(std::size_t count)
    {
        return waitUntil([this, count] { return values.size() >= count; });
    }
    [[nodiscard]] bool refuses(std::uint64_t count)
    {
        return waitUntil([this, count] { return line.state().refused >= count; });
    }
    [[nodiscard]] std::string problem() const { return line.problem().toStdString(); }
    // The largest number of values in one pass of the event loop.
    [[nodiscard]] int longestHelping() const { return m_longestHelping; }

    fakes::ManualClock clock;
    PowerLine line;
    std::vector<Value> values;

private:
    int m_helping = 0;
    int m_longestHelping = 0;
};

LineSettings udpSettings(std::uint16_t port)
{
    return {.transport = Transport::Udp,
            .host = QStringLiteral("127.0.0.1"),
            .port = port,
            .firstRetry = std::chrono::milliseconds(5),
            .longestRetry = std::chrono::milliseconds(20)};
}

LineSettings tcpSettings(std::uint16_t port)
{
    LineSettings settings = udpSettings(port);
    settings.transport = Transport::Tcp;
    return settings;
}

struct UdpEar : Ear
{
    UdpEar() : UdpEar(fakes::unusedUdpPort()) {}
    explicit UdpEar(std::uint16_t at) : Ear(udpSettings(at)), port(at) {}
    void send(const QByteArray& datagram)
    {
        ASSERT_EQ(datagram.size(), sender.writeDatagram(datagram, QHostAddress::LocalHost, port));
    }

    std::uint16_t port;
    QUdpSocket sender;
};

// REQ-POWER-03: Each value has its time of arrival. Lines may be split or joined anywhere. A line of more than 300
// bytes is dropped.
TEST(PowerLine, UdpIsReadLineByLineWithItsTimeOfArrival)
{
    UdpEar ear;
    ear.clock.advance(Seconds(2.0));
    ear.send("-73.2\n");
    ASSERT_TRUE(ear.hears(1));
    EXPECT_EQ(-73.2, ear.values.at(0).decibels);
    EXPECT_EQ(ear.clock.now(), ear.values.at(0).arrival);
    ear.send("STRENGTH -70\r\n\n-69,5 dBm");  // the end of a datagram ends its line
    ear.send("-68");
    ASSERT_TRUE(ear.hears(4));
    EXPECT_EQ(-70.0, ear.values.at(1).decibels);
    EXPECT_EQ(-69.5, ear.values.at(2).decibels);
    EXPECT_EQ(-68.0, ear.values.at(3).decibels);
    EXPECT_EQ(QStringLiteral("UDP 127.0.0.1:%1").arg(ear.port), nameOf(udpSettings(ear.port)));
    EXPECT_EQ(-68.0, ear.line.state().last->decibels);
    EXPECT_EQ(ear.clock.now(), ear.line.state().last->arrival);
    EXPECT_EQ(4U, ear.line.state().values);
    EXPECT_EQ("", ear.problem());
}

// REQ-POWER-04
TEST(PowerLine, RubbishIsOneLineThatSaysWhatCame)
{
    UdpEar ear;
    ear.send("-73");
    ASSERT_TRUE(ear.hears(1));
    for (int i = 0; i < 20; ++i) {
        ear.send(i == 0 ? "S7 \x1b[J" : "14.074 -73");
    }
    ASSERT_TRUE(ear.refuses(20));
    EXPECT_EQ("", ear.problem()) << "a slip now and then is only counted";
    ear.clock.advance(Seconds(5.1));
    const std::string told = ear.problem();
    EXPECT_NE(std::string::npos, told.find("\"S7 ?[J\": it contains no number")) << told;
    ear.send("still nothing");
    ASSERT_TRUE(ear.refuses(21));
    EXPECT_EQ(told, ear.problem()) << "the line stays the same";
    EXPECT_EQ(1U, ear.values.size());
    ear.send("-72");
    ASSERT_TRUE(ear.hears(2));
    EXPECT_EQ("", ear.problem());
}

// REQ-POWER-04: Silence or unreadable data for 5 s is reported in one sentence with an example of the data, until a
// value arrives. Occasional errors are only counted.
TEST(PowerLine, SilenceIsSaid)
{
    UdpEar ear;
    ear.clock.advance(Seconds(4.0));
    EXPECT_EQ("", ear.problem());
    ear.clock.advance(Seconds(2.0));
    EXPECT_NE(std::string::npos, ear.problem().find("No data"));
    ear.send("-73");
    ASSERT_TRUE(ear.hears(1));
    EXPECT_EQ("", ear.problem());
    ear.clock.advance(Seconds(6.0));
    EXPECT_NE(std::string::npos, ear.problem().find("No data"));
}

// REQ-POWER-03
TEST(PowerLine, LinesThatAreTooLongAreDropped)
{
    UdpEar ear;
    ear.send(QByteArray(1000, '1') + "\n-73\n");
    ear.send(QByteArray(5000, '2') + "\n-72\n");  // only its beginning is examined
    ear.send("-71");
    ASSERT_TRUE(ear.hears(2));
    EXPECT_EQ(-73.0, ear.values.at(0).decibels);
    EXPECT_EQ(-71.0, ear.values.at(1).decibels);
    EXPECT_EQ(2U, ear.line.state().refused);
}

// REQ-POWER-03
TEST(PowerLine, ABurstIsReadWhole)
{
    UdpEar ear;
    for (int i = 0; i < 150; ++i) {
        ear.send(QByteArray::number(-i));
    }
    ASSERT_TRUE(ear.hears(150));
    EXPECT_EQ(-149.0, ear.values.back().decibels);
}

// Story: a flood delayed the drives by 0.37 s, because everything that had arrived was read at once.
// REQ-POWER-08: A flood on the line delays nothing: 4 kB or 50 datagrams are read every 10 ms on a separate thread, and
// the station receives the newest 32 values every 20 ms.
TEST(PowerLine, AFloodOfDatagramsIsReadInSmallHelpings)
{
    UdpEar ear;
    for (int i = 0; i < 3 * PowerLine::kDatagramsAtOnce; ++i) {
        ear.send(QByteArray::number(-i % 100));
    }
    ASSERT_TRUE(ear.hears(1));
    EXPECT_LE(ear.values.size(), static_cast<std::size_t>(PowerLine::kDatagramsAtOnce));
    EXPECT_LE(ear.longestHelping(), PowerLine::kDatagramsAtOnce);
    ASSERT_TRUE(ear.hears(3 * PowerLine::kDatagramsAtOnce));
    EXPECT_LE(ear.longestHelping(), PowerLine::kDatagramsAtOnce);
}

// REQ-POWER-06: UDP is received only at the one address that the profile names.
TEST(PowerLine, OtherAddressesOfThisComputerAreNotListenedAt)
{
    UdpEar ear;
    QUdpSocket sender;
    sender.writeDatagram("-1", QHostAddress(QStringLiteral("127.0.0.2")), ear.port);
    ear.send("-2");
    ASSERT_TRUE(ear.hears(1));
    EXPECT_EQ(-2.0, ear.values.front().decibels);
}

// REQ-POWER-05: A port that is in use, or a program that is missing or closes the connection, is reported in one
// sentence. The connection is tried again after 1, 2, 4, 8, 10 s.
TEST(PowerLine, APortThatIsTakenIsSaidAndTriedAgain)
{
    auto holder = std::make_unique<QUdpSocket>();
    ASSERT_TRUE(holder->bind(QHostAddress::LocalHost, 0, QAbstractSocket::DontShareAddress));
    UdpEar ear(holder->localPort());
    EXPECT_NE(std::string::npos, ear.problem().find("cannot listen on")) << ear.problem();
    holder.reset();
    ASSERT_TRUE(waitUntil([&] {
        ear.sender.writeDatagram("-73", QHostAddress::LocalHost, ear.port);
        return !ear.values.empty();
    }));
    EXPECT_EQ("", ear.problem());
}

// As an operator's script does it.
// REQ-POWER-07: A script of one or two lines is enough as a source.
TEST(PowerLine, AProgramThatSendsByUdpIsHeard)
{
    UdpEar ear;
    fakes::Program shell(QStringLiteral("/bin/bash"),
                         {QStringLiteral("-c"), QStringLiteral("for power in -73.2 'SNR 12' '-71,5 dBm'; do echo "
                                                               "\"$power\" >/dev/udp/127.0.0.1/%1; done")
                                                    .arg(ear.port)});
    ASSERT_EQ(0, shell.waitForEnd()) << shell.errors().toStdString();
    ASSERT_TRUE(ear.hears(3));
    EXPECT_EQ(-73.2, ear.values.at(0).decibels);
    EXPECT_EQ(12.0, ear.values.at(1).decibels);
    EXPECT_EQ(-71.5, ear.values.at(2).decibels);
}

// A program of the receiver, to which Boresight connects.
struct Receiver
{
    explicit Receiver(std::uint16_t port = 0)
    {
        EXPECT_TRUE(server.listen(QHostAddress::LocalHost, port)) << server.errorString().toStdString();
    }
    [[nodiscard]] QTcpSocket* client()
    {
        EXPECT_TRUE(waitUntil([this] { return server.hasPendingConnections(); }));
        return server.nextPendingConnection();
    }

    QTcpServer server;
};

// REQ-POWER-03
TEST(PowerLine, TcpMayBeSplitAnywhere)
{
    Receiver receiver;
    Ear ear(tcpSettings(receiver.server.serverPort()));
    QTcpSocket* const socket = receiver.client();
    ASSERT_NE(nullptr, socket);
    const QByteArray noise(400, 'x');
    for (const QByteArray& part : {QByteArray("-7"), QByteArray("3.2\r"), QByteArray("\n-7"), QByteArray("0\n"), noise,
                                   QByteArray("y\nlevel=-69\n")}) {
        socket->write(part);
        ASSERT_TRUE(socket->flush());
        ASSERT_TRUE(waitUntil([socket] { return socket->bytesToWrite() == 0; }));
    }
    ASSERT_TRUE(ear.hears(3));
    EXPECT_EQ(-73.2, ear.values.at(0).decibels);
    EXPECT_EQ(-70.0, ear.values.at(1).decibels);
    EXPECT_EQ(-69.0, ear.values.at(2).decibels);
    EXPECT_EQ(1U, ear.line.state().refused);
    EXPECT_EQ(0, socket->bytesAvailable()) << "nothing is ever sent";
}

// REQ-POWER-08
TEST(PowerLine, AFloodByTcpIsReadInSmallHelpingsAndHeldUp)
{
    Receiver receiver;
    Ear ear(tcpSettings(receiver.server.serverPort()));
    QTcpSocket* const socket = receiver.client();
    ASSERT_NE(nullptr, socket);
    const int lines = 10 * static_cast<int>(PowerLine::kBytesAtOnce) / 4;
    socket->write(QByteArray("-73\n").repeated(lines));
    ASSERT_TRUE(ear.hears(static_cast<std::size_t>(lines)));
    EXPECT_EQ(ear.values.size(), static_cast<std::size_t>(lines)) << "nothing is lost";
    EXPECT_LE(ear.longestHelping(), PowerLine::kBytesAtOnce / 4);
}

// REQ-POWER-05
TEST(PowerLine, TcpConnectsAgain)
{
    const std::uint16_t port = fakes::unusedPort();
    Ear ear(tcpSettings(port));
    ASSERT_TRUE(waitUntil([&] { return !ear.problem().empty(); }));
    EXPECT_NE(std::string::npos, ear.problem().find("No connection to the program of the receiver")) << ear.problem();
    {
        Receiver first(port);
        QTcpSocket* const socket = first.client();
        ASSERT_NE(nullptr, socket);
        EXPECT_FALSE(ear.problem().empty()) << "until something has come";
        socket->write("-73\n-7");
        ASSERT_TRUE(ear.hears(1));
        EXPECT_EQ("", ear.problem());
        socket->disconnectFromHost();
        ASSERT_TRUE(waitUntil([&] { return !ear.problem().empty(); }));
    }
    Receiver second(port);
    QTcpSocket* const socket = second.client();
    ASSERT_NE(nullptr, socket);
    socket->write("1\n");  // an incomplete earlier line is dropped
    ASSERT_TRUE(ear.hears(2));
    EXPECT_EQ(1.0, ear.values.at(1).decibels);
    EXPECT_EQ("", ear.problem());
}

// REQ-POWER-05
TEST(PowerLine, AProgramThatHangsUpAtOnceIsOneLine)
{
    Receiver receiver;
    Ear ear(tcpSettings(receiver.server.serverPort()));
    std::vector<std::string> told;
    for (int i = 0; i < 5; ++i) {
        QTcpSocket* const socket = receiver.client();
        ASSERT_NE(nullptr, socket);
        socket->abort();
        ASSERT_TRUE(waitUntil([&] { return !ear.problem().empty(); }));
        told.push_back(ear.problem());
    }
    for (const std::string& line : told) {
        EXPECT_EQ(told.back(), line);
    }
}

}  // namespace
}  // namespace boresight::power
